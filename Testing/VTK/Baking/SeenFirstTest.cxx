// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that there is no force in the air beside a body, where nothing is visible. The volumes'
 * formulas determine the positions of the surfaces.
 */

#include "Rigs/ApiRig.h"

#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

using namespace apitest;

namespace
{
/// Makes a volume of 1 mm voxels; `formula` computes the value from the indices.
template <typename Formula>
vtkSmartPointer<vtkImageData> MakeVolume(int x, int y, int z, int type, const Formula& formula)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(x, y, z);
  image->AllocateScalars(type, 1);
  for (int k = 0; k < z; ++k)
  {
    for (int j = 0; j < y; ++j)
    {
      for (int i = 0; i < x; ++i)
      {
        image->SetScalarComponentFromDouble(i, j, k, 0, formula(i, j, k));
      }
    }
  }
  return image;
}

/// Returns the value (0 to 1) at a `distance` behind the middle of an edge that is blurred by a
/// Gaussian of this `width`.
double Blurred(double distance, double width)
{
  return 0.5 * (1.0 + std::erf(distance / (width * std::sqrt(2.0))));
}

double ForceAt(vtkPolyData* trace, vtkIdType tick)
{
  return std::hypot(
    Get(trace, "Force", tick, 0), Get(trace, "Force", tick, 1), Get(trace, "Force", tick, 2));
}

double LargestForce(vtkPolyData* trace)
{
  double largest = 0.0;
  for (vtkIdType tick = 0; tick < trace->GetNumberOfPoints(); ++tick)
  {
    largest = std::max(largest, ForceAt(trace, tick));
  }
  return largest;
}

/// Smallest force (N) that counts as felt, as in the presses of the evaluation.
constexpr double Felt = 0.1;

/// Returns the largest force (N) on a straight path that passes a ball with a radius of 8 mm around
/// (20, 20, 20) at this `distance`.
double PassBy(const char* preset, vtkImageData* ball, double distance)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputData(ball);
  EXPECT_TRUE(filter->GetProperty()->ApplyPreset(preset));
  const double y = 20.0 + 8.0 + distance;
  filter->SetPathData(MakePath(Line({ 4.0, y, 20.3 }, { 36.0, y, 20.3 }, 640)));
  filter->Update();
  return LargestForce(filter->GetOutput());
}
} // namespace

TEST(SeenFirst, AirBesideALabelDoesNotDrag)
{
  const vtkSmartPointer<vtkImageData> ball = MakeVolume(41, 41, 41, VTK_UNSIGNED_CHAR,
    [](int i, int j, int k) { return std::hypot(i - 20.0, j - 20.0, k - 20.0) < 8.0 ? 5.0 : 0.0; });
  for (const double distance : { 1.0, 1.2, 1.6, 2.2, 2.8, 3.4 })
  {
    EXPECT_LT(PassBy("Labels", ball, distance), Felt) << distance << " mm from the label";
  }
  EXPECT_GT(PassBy("Labels", ball, -2.0), 0.2) << "the label itself is felt";
}

TEST(SeenFirst, ThinLabelsAreFeltAtTheVoxelsThatAreShown)
{
  const auto thread = MakeVolume(41, 41, 41, VTK_UNSIGNED_CHAR,
    [](int i, int j, int) { return (i == 20 || i == 21) && (j == 20 || j == 21) ? 7.0 : 0.0; });
  const auto sheet =
    MakeVolume(41, 41, 41, VTK_UNSIGNED_CHAR, [](int, int j, int) { return j == 20 ? 7.0 : 0.0; });
  vtkNew<vtkVolumeProperty> look;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.499, 0.0);
  opacity->AddPoint(0.501, 1.0);
  look->SetScalarOpacity(opacity);
  look->SetInterpolationTypeToNearest();
  for (vtkImageData* const labels : { thread.GetPointer(), sheet.GetPointer() })
  {
    vtkNew<vtkVolumeHapticsFilter> filter;
    filter->SetInputData(labels);
    EXPECT_TRUE(filter->GetProperty()->ApplyPreset("Labels"));
    filter->GetProperty()->SetVisibilityFrom(look);
    filter->SetPathData(MakePath(Line({ 20.5, 14.0, 20.3 }, { 20.5, 20.3, 20.3 }, 126)));
    filter->Update();
    vtkPolyData* const trace = filter->GetOutput();
    vtkIdType tick = 0;
    while (tick < 126 && ForceAt(trace, tick) < Felt)
    {
      ++tick;
    }
    EXPECT_NEAR(trace->GetPoint(tick)[1], 19.5, 0.01) << "the face of the voxels";
    EXPECT_GT(ForceAt(trace, 126), 0.25) << "it holds";
  }
}

TEST(SeenFirst, AirBesideATwoSidedSurfaceDoesNotDrag)
{
  const vtkSmartPointer<vtkImageData> ball = MakeVolume(41, 41, 41, VTK_FLOAT,
    [](int i, int j, int k)
    { return 200.0 * Blurred(8.0 - std::hypot(i - 20.0, j - 20.0, k - 20.0), 1.0); });
  for (const double distance : { 2.0, 2.5, 3.0 })
  {
    EXPECT_LT(PassBy("MRI", ball, distance), Felt) << distance << " mm from the middle of the edge";
  }
  EXPECT_GT(PassBy("MRI", ball, -2.0), 0.2) << "the ball itself is felt";
}

TEST(SeenFirst, AGradualEdgeIsFeltWhereItIsShown)
{
  // Values increase by 2.5 per voxel, too slowly for a distinct edge. The opacity begins at the
  // value 50, at y = 20 mm.
  const vtkSmartPointer<vtkImageData> ramp =
    MakeVolume(41, 41, 41, VTK_FLOAT, [](int, int j, int) { return 2.5 * j; });
  vtkNew<vtkVolumeProperty> look;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(50.0, 0.0);
  opacity->AddPoint(52.0, 1.0);
  look->SetScalarOpacity(opacity);
  const auto press = [&](double strength, vtkVolumeProperty* picture)
  {
    vtkNew<vtkVolumeHapticsFilter> filter;
    filter->SetInputData(ramp);
    vtkHapticProperty* const feel = filter->GetProperty();
    for (const auto& [function, value] :
      { std::pair(feel->GetStiffness(), 500.0), std::pair(feel->GetFriction(), 0.0),
        std::pair(feel->GetViscosity(), 0.0), std::pair(feel->GetSurfaceStrength(), strength) })
    {
      function->RemoveAllPoints();
      function->AddPoint(0.0, value);
    }
    feel->GetDistinctness()->RemoveAllPoints();
    feel->GetDistinctness()->AddPoint(5.0, 0.0);
    feel->GetDistinctness()->AddPoint(20.0, 1.0);
    feel->SetVisibilityFrom(picture);
    filter->SetPathData(MakePath(Line({ 20.3, 12.0, 20.3 }, { 20.3, 21.0, 20.3 }, 180)));
    filter->Update();
    vtkSmartPointer<vtkPolyData> trace = filter->GetOutput();
    return trace;
  };
  EXPECT_EQ(LargestForce(press(1.0, nullptr)), 0.0) << "nothing is distinct";
  EXPECT_EQ(LargestForce(press(0.0, look)), 0.0) << "tissue without a surface";
  const vtkSmartPointer<vtkPolyData> trace = press(1.0, look);
  vtkIdType tick = 0;
  while (tick < 180 && ForceAt(trace, tick) < Felt)
  {
    ++tick;
  }
  EXPECT_NEAR(trace->GetPoint(tick)[1], 20.0, 0.05) << "where the picture begins";
  EXPECT_LE(LargestForce(trace), 0.15 + 1e-9);
  EXPECT_NEAR(LargestForce(press(0.12, look)), 0.12, 1e-6) << "no stronger than the tissue";
}
