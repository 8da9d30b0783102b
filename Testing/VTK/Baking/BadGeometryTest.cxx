// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests images without extent, and images with an impossible position in the world. */

#include "Rigs/BadImage.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>

#include <limits>

using namespace apitest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Inf = std::numeric_limits<double>::infinity();

void Reshape(vtkImageData* image, int x, int y, int z)
{
  image->SetDimensions(x, y, z);
  image->AllocateScalars(VTK_SHORT, 1);
  image->GetPointData()->GetScalars()->Fill(0.0);
}

const BadImage BadGeometries[] = {
  { "Empty", [](auto* image, auto*) { image->SetExtent(0, -1, 0, -1, 0, -1); },
    { "input image", "empty", "dimensions", "5 x 5 x 5" } },
  { "ThinAlongX", [](auto* image, auto*) { Reshape(image, 1, 9, 9); },
    { "input image", "one voxel thin", "1 x 9 x 9" } },
  { "ThinAlongY", [](auto* image, auto*) { Reshape(image, 9, 1, 9); },
    { "input image", "one voxel thin", "9 x 1 x 9" } },
  { "ThinAlongZ", [](auto* image, auto*) { Reshape(image, 9, 9, 1); },
    { "input image", "one voxel thin", "9 x 9 x 1", "5 points along every axis",
      "KernelRadius of 2", "3 are enough" } },
  { "ThinWithASmallKernel",
    [](auto* image, auto* filter)
    {
      Reshape(image, 9, 9, 1);
      filter->SetKernelRadius(1);
    },
    { "one voxel thin", "3 points along every axis", "KernelRadius of 1" } },
  { "SpacingNaN", [](auto* image, auto*) { image->SetSpacing(1, NaN, 1); },
    { "input image", "spacing", "finite", "SetSpacing" } },
  { "SpacingInfinite", [](auto* image, auto*) { image->SetSpacing(Inf, 1, 1); },
    { "input image", "spacing", "finite", "SetSpacing" } },
  { "SpacingZero", [](auto* image, auto*) { image->SetSpacing(1, 1, 0); },
    { "input image", "spacing", "not zero", "SetSpacing" } },
  { "OriginNaN", [](auto* image, auto*) { image->SetOrigin(0, 0, NaN); },
    { "input image", "origin", "finite", "SetOrigin" } },
  { "SingularDirection",
    [](auto* image, auto*) { image->SetDirectionMatrix(1, 0, 1, 0, 1, 0, 1, 0, 1); },
    { "input image", "direction matrix", "singular", "SetDirectionMatrix" } },
  { "DirectionNaN",
    [](auto* image, auto*) { image->SetDirectionMatrix(1, 0, 0, 0, NaN, 0, 0, 0, 1); },
    { "input image", "direction matrix", "SetDirectionMatrix" } },
  { "KernelTooLarge", [](auto*, auto* filter) { filter->SetKernelRadius(8); },
    { "input image", "KernelRadius of 8", "16 x 16 x 16", "Lower KernelRadius" } },
};
} // namespace

/// Follows the error's advice: images with the stated number of points can be touched.
TEST(ThinImages, AreFeltWithAsManyPointsAsTheErrorNames)
{
  for (const auto& [radius, points] : { std::pair(1, 3), std::pair(2, 5), std::pair(4, 9) })
  {
    vtkNew<vtkVolumeHapticsFilter> filter;
    MessageLog log(filter);
    MessageLog executiveLog(filter->GetExecutive());
    const auto image = MakeRamp(points);
    filter->SetInputData(0, image);
    filter->SetKernelRadius(radius);
    filter->Update();
    EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
    Reshape(image, points, points, 1);
    filter->Update();
    ASSERT_EQ(log.Errors.size(), 1U);
    EXPECT_NE(log.Errors[0].find("least " + std::to_string(points) + " points"), std::string::npos)
      << log.Errors[0];
  }
}

class BadGeometryTest : public BadImageTest
{
};

TEST_P(BadGeometryTest, GivesOneErrorAndRecovers)
{
  this->ExpectErrorAndRecovery();
}

INSTANTIATE_TEST_SUITE_P(Images, BadGeometryTest, testing::ValuesIn(BadGeometries), NameOf);
