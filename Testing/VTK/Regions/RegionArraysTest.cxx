// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the arrays of a region that describe the whole volume, and the errors for invalid arrays.
 */

#include "Rigs/BadImage.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkHapticRegionFilter.h>
#include <vtkStringArray.h>

using namespace apitest;

namespace
{
void SetField(vtkImageData* image, const char* name, const std::vector<double>& numbers)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double number : numbers)
  {
    array->InsertNextValue(number);
  }
  image->GetFieldData()->AddArray(array);
}

/// Makes the ramp a valid region of a volume. Each test then invalidates one array.
void MakeRegion(vtkImageData* image)
{
  SetField(image, "HapticWholeExtent", { 0, 15, 0, 15, -10, 15 });
  SetField(image, "HapticNoise", { 0.0 });
  SetField(image, "HapticBorderValue", { 0.0 });
}

std::function<void(vtkImageData*, vtkVolumeHapticsFilter*)> With(
  const char* name, const std::vector<double>& numbers)
{
  return [=](vtkImageData* image, vtkVolumeHapticsFilter*)
  {
    MakeRegion(image);
    SetField(image, name, numbers);
  };
}

const BadImage BadRegions[] = {
  { "NoNoise",
    [](auto* image, auto*)
    {
      MakeRegion(image);
      image->GetFieldData()->RemoveArray("HapticNoise");
    },
    { "region", "\"HapticNoise\"", "missing", "vtkHapticRegionFilter" } },
  { "NoExtent",
    [](auto* image, auto*)
    {
      MakeRegion(image);
      image->GetFieldData()->RemoveArray("HapticWholeExtent");
    },
    { "region", "\"HapticWholeExtent\"", "missing", "remove the field arrays" } },
  { "TextForABorder",
    [](auto* image, auto*)
    {
      MakeRegion(image);
      vtkNew<vtkStringArray> text;
      text->SetName("HapticBorderValue");
      image->GetFieldData()->AddArray(text);
    },
    { "\"HapticBorderValue\"", "not of numbers", "vtkHapticRegionFilter" } },
  { "FiveIndices", With("HapticWholeExtent", { 0, 15, 0, 15, 0 }),
    { "\"HapticWholeExtent\"", "5 number(s)", "6 are needed" } },
  { "Elsewhere", With("HapticWholeExtent", { 4, 40, 0, 15, 0, 15 }),
    { "extent (0, 15, 0, 15, 0, 15)", "not within the whole", "keeps the indices" } },
  { "Halves", With("HapticWholeExtent", { -0.5, 15, 0, 15, 0, 15 }), { "not within the whole" } },
  { "EndlessWhole", With("HapticWholeExtent", { 0, HUGE_VAL, 0, 15, 0, 15 }),
    { "\"HapticWholeExtent\"", "inf", "not finite" } },
  { "NegativeNoise", With("HapticNoise", { -1.0 }), { "\"HapticNoise\"", "-1", "0 or more" } },
  { "NoiseNaN", With("HapticNoise", { NAN }), { "\"HapticNoise\"", "not finite" } },
  { "NoNumbers", With("HapticBorderValue", {}),
    { "\"HapticBorderValue\"", "0 number(s)", "1 are needed" } },
};
} // namespace

class BadRegionsTest : public BadImageTest
{
};

TEST_P(BadRegionsTest, GivesOneErrorAndRecovers)
{
  this->ExpectErrorAndRecovery();
}

INSTANTIATE_TEST_SUITE_P(Images, BadRegionsTest, testing::ValuesIn(BadRegions), NameOf);

TEST_F(ApiTest, ARegionAsItShouldBeIsFelt)
{
  MakeRegion(this->Image);
  this->Run(51);
}

TEST_F(ApiTest, ARegionFilterSaysWhatIsWrongWithItsInput)
{
  vtkNew<vtkHapticRegionFilter> crop;
  MessageLog log(crop);
  crop->SetInputData(this->Image);
  crop->SetRegion(20, 30, 0, 5, 0, 5);
  crop->Update();
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("no part of the image"), std::string::npos);
  crop->SetRegion(3, 30, 0, 5, 0, 5);
  crop->Update();
  EXPECT_EQ(crop->GetOutput()->GetNumberOfPoints(), 13 * 6 * 6);
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(9, 9, 9);
  crop->SetInputData(bare);
  crop->Update();
  ASSERT_EQ(log.Errors.size(), 2U);
  EXPECT_NE(log.Errors[1].find("no point scalars"), std::string::npos);
}
