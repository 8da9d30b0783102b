// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a ball in air with streaks, as in micro-CT: the noise is neither white nor uniform, and the
 * air is clipped at 0. The ball's wall must be felt at its true position, and nowhere else.
 */

#include "Rigs/ApiRig.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHapticRegionFilter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace apitest;

namespace
{
constexpr int Width = 96; // number of voxels, each 1 mm wide
constexpr double Middle = 0.5 * (Width - 1);
constexpr double Ball = 20.0; // mm, radius of the ball
constexpr double Bright = 90.0;
constexpr int Rays = 120;
constexpr double Start = 44.0; // distance of a ray's start from the middle (mm)
constexpr double RayStep = 0.1;
constexpr double Deep = 4.0; // mm, depth at the end of a ray

/// Makes white noise, and smooths it over some voxels along x, and between neighbours along y and
/// z.
std::vector<double> MakeStreaks()
{
  std::mt19937_64 engine(11);
  std::normal_distribution<double> random;
  std::vector<double> noise(static_cast<std::size_t>(Width) * Width * Width);
  for (double& value : noise)
  {
    value = random(engine);
  }
  const std::size_t strides[] = { 1, Width, std::size_t{ Width } * Width };
  const int passes[] = { 24, 2, 2 };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int pass = 0; pass < passes[axis]; ++pass)
    {
      std::vector<double> smooth = noise;
      for (std::size_t i = strides[axis]; i + strides[axis] < noise.size(); ++i)
      {
        smooth[i] = 0.25 * (noise[i - strides[axis]] + 2.0 * noise[i] + noise[i + strides[axis]]);
      }
      noise = smooth;
    }
  }
  double squares = 0.0;
  for (const double value : noise)
  {
    squares += value * value / static_cast<double>(noise.size());
  }
  for (double& value : noise)
  {
    value /= std::sqrt(squares);
  }
  return noise;
}

/// Makes the ball with `levels` grey levels, and streaks scaled by `streak`. If `core` is not 0,
/// the middle of the ball is brighter by this value.
vtkSmartPointer<vtkImageData> MakeBall(
  double levels = 256.0, double core = 0.0, double streak = 1.0)
{
  const std::vector<double> streaks = MakeStreaks();
  std::mt19937_64 engine(12);
  std::normal_distribution<double> random;
  std::size_t number = 0;
  return MakeImage(Width, core > 0.0 ? VTK_FLOAT : VTK_UNSIGNED_CHAR,
    [&](const Point& x)
    {
      const double r = std::hypot(x[0] - Middle, x[1] - Middle, x[2] - Middle);
      const double inside = 0.5 * std::erfc((r - Ball) / (0.8 * std::sqrt(2.0)));
      // The amplitude of the streaks increases from 1 at z = 30 mm to 9 at z = 60 mm.
      const double fraction = std::clamp((x[2] - 30.0) / 30.0, 0.0, 1.0);
      const double noise =
        streak * (1.0 + 8.0 * fraction) * streaks[number++] + 0.4 * random(engine);
      const double middle = core * 0.5 * std::erfc(r - 0.4 * Ball);
      const double value = 2.0 + Bright * inside + middle + noise;
      const double scale = levels / 256.0;
      return std::round(std::clamp(scale * value, 0.0, core > 0.0 ? 1e4 : levels - 1.0));
    });
}

/// Makes rays from all directions to the middle, as separate lines.
vtkSmartPointer<vtkPolyData> MakeRays()
{
  constexpr double from = Start;
  constexpr double to = Ball - Deep;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  const int ticks = static_cast<int>((from - to) / RayStep);
  for (int ray = 0; ray < Rays; ++ray)
  {
    // Distribute the directions evenly over the sphere (a Fibonacci lattice).
    const double z = 1.0 - (2.0 * ray + 1.0) / Rays;
    const double around = ray * 2.399963229728653;
    const double across = std::sqrt(1.0 - z * z);
    lines->InsertNextCell(ticks);
    for (int tick = 0; tick < ticks; ++tick)
    {
      const double r = from - RayStep * tick;
      lines->InsertCellPoint(points->InsertNextPoint(Middle + r * across * std::cos(around),
        Middle + r * across * std::sin(around), Middle + r * z));
    }
  }
  auto path = vtkSmartPointer<vtkPolyData>::New();
  path->SetPoints(points);
  path->SetLines(lines);
  return path;
}

/// Results of moving the tip along all rays.
struct FeltRays
{
  int Off = 0;       ///< number of rays whose first contact is too far from the surface, or missing
  double Air = 0.0;  ///< largest force (N) more than 3 mm before the surface
  double Step = 0.0; ///< largest change (N) of the force from tick to tick
};

FeltRays Feel(vtkVolumeHapticsFilter* filter, double farthest = 2.0)
{
  filter->SetPathData(MakeRays());
  filter->Update();
  vtkPolyData* const output = filter->GetOutput();
  vtkDataArray* const forces = output->GetPointData()->GetArray("Force");
  const vtkIdType ticks = output->GetNumberOfPoints() / Rays;
  FeltRays felt;
  for (int ray = 0; ray < Rays; ++ray)
  {
    bool isMet = false;
    bool isRight = false;
    double last = 0.0;
    for (vtkIdType tick = 0; tick < ticks; ++tick)
    {
      const vtkIdType i = ray * ticks + tick;
      double f[3];
      double proxy[3];
      forces->GetTuple(i, f);
      output->GetPoint(i, proxy);
      const double force = std::hypot(f[0], f[1], f[2]);
      const double r = std::hypot(proxy[0] - Middle, proxy[1] - Middle, proxy[2] - Middle);
      felt.Step = std::max(felt.Step, std::abs(force - last));
      felt.Air = r > Ball + 3.0 ? std::max(felt.Air, force) : felt.Air;
      if (!isMet && force > 0.1)
      {
        isMet = true;
        isRight = std::abs(r - Ball) <= farthest;
      }
      last = force;
    }
    felt.Off += isRight ? 0 : 1;
  }
  return felt;
}

} // namespace

TEST(UnevenNoise, MicroCTHasNoWallInStreaks)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->GetProperty()->ApplyPreset("Micro-CT");
  for (const double levels : { 256.0, 32.0 })
  {
    filter->SetInputData(0, MakeBall(levels));
    for (const int estimator : { vtkVolumeHapticsFilter::CENTRAL_DIFFERENCE,
           vtkVolumeHapticsFilter::GAUSSIAN, vtkVolumeHapticsFilter::CUBIC_BSPLINE })
    {
      filter->SetGradientEstimator(estimator);
      for (const bool isPrecise : { true, false })
      {
        filter->SetSolver(
          isPrecise ? vtkVolumeHapticsFilter::PRECISE : vtkVolumeHapticsFilter::PAPER);
        // The method PAPER meets a wall earlier than PRECISE, by up to a kernel radius plus half a
        // voxel.
        const FeltRays felt = Feel(filter, isPrecise ? 2.0 : 3.0);
        SCOPED_TRACE(levels * 100 + estimator * 10 + isPrecise);
        EXPECT_LE(felt.Off, Rays / 50);
        EXPECT_LT(felt.Air, 0.1);
        EXPECT_LT(felt.Step, 0.5);
      }
    }
  }
}

// A clump whose values are a tenth of the way from Otsu's threshold to the solid is a grain of the
// background; a clump halfway is solid. The threshold between the two peaks, 0 and 100, is 50.
TEST(UnevenNoise, MicroCTHasNoWallInGrains)
{
  for (const double clump : { 55.0, 75.0 })
  {
    constexpr int side = 48;
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(side, side, side);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int k = 0; k < side; ++k)
    {
      for (int j = 0; j < side; ++j)
      {
        for (int i = 0; i < side; ++i)
        {
          const double far = std::hypot(i - 12.0, std::hypot(j - 24.0, k - 24.0));
          const double blur = 1.0 / (1.0 + std::exp(2.0 * (far - 5.0)));
          const double solid = 1.0 / (1.0 + std::exp(2.0 * (30.0 - i)));
          *value++ = static_cast<unsigned char>(std::lround(100.0 * solid + clump * blur));
        }
      }
    }
    vtkNew<vtkPoints> points;
    for (int tick = 0; tick < 200; ++tick)
    {
      points->InsertNextPoint(12.0, 24.0, 10.0 + 0.05 * tick);
    }
    vtkNew<vtkPolyData> path;
    path->SetPoints(points);
    vtkNew<vtkVolumeHapticsFilter> filter;
    filter->GetProperty()->ApplyPreset("Micro-CT");
    filter->SetInputData(0, image);
    filter->SetPathData(path);
    filter->Update();
    const double most = filter->GetOutput()->GetPointData()->GetArray("NormalForce")->GetRange()[1];
    EXPECT_EQ(most > 0.1, clump > 60.0) << clump << ": " << most;
  }
}

TEST(UnevenNoise, StreaksAreWallsWithoutTheImagesLevel)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->GetProperty()->ApplyPreset("Micro-CT");
  filter->GetProperty()->SolidFromImageOff();
  filter->SetInputData(0, MakeBall());
  EXPECT_GT(Feel(filter).Off, Rays / 4) << "so the volume tests what it is made for";
  filter->GetProperty()->SolidFromImageOn();
  EXPECT_LE(Feel(filter).Off, Rays / 50);
  filter->GetProperty()->SetSurfaceSideToBoth();
  EXPECT_GT(Feel(filter).Off, Rays / 4) << "what is dark may be a structure";
}

TEST(UnevenNoise, ABrightCoreLeavesTheBallSolid)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->GetProperty()->ApplyPreset("Micro-CT");
  filter->SetInputData(0, MakeBall(256.0, 500.0));
  const FeltRays felt = Feel(filter);
  EXPECT_LE(felt.Off, Rays / 50);
  EXPECT_LT(felt.Air, 0.1);
}

TEST(UnevenNoise, ARegionHasTheLevelOfTheWhole)
{
  vtkNew<vtkHapticRegionFilter> crop;
  crop->SetInputData(MakeBall());
  crop->Update();
  vtkNew<vtkImageData> part;
  part->DeepCopy(crop->GetOutput());
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->GetProperty()->ApplyPreset("Micro-CT");
  filter->SetInputData(0, part);
  EXPECT_LE(Feel(filter).Off, Rays / 50);
  const auto felt = Keep(filter);
  filter->SetInputData(0, MakeBall());
  filter->Update();
  EXPECT_TRUE(IsSame(felt, filter->GetOutput()));
  // Without the array with the whole volume's level, the filter computes the level from the region
  // alone. Then over a quarter of the rays touch the ball at a wrong position.
  part->GetFieldData()->RemoveArray("HapticSolid");
  part->Modified();
  filter->SetInputData(0, part);
  EXPECT_GT(Feel(filter).Off, Rays / 4);
}

TEST(UnevenNoise, FunctionsAreProposedInStreaks)
{
  for (const double levels : { 256.0, 32.0 })
  {
    for (const bool isDark : { false, true })
    {
      SCOPED_TRACE(levels + isDark);
      // Invert the image if `isDark`. The noise of a dark ball in bright air is the same, but
      // clipped at the brightest value.
      const auto image = MakeBall(levels, 0.0, 0.3);
      vtkDataArray* const scalars = image->GetPointData()->GetScalars();
      for (vtkIdType i = 0; isDark && i < scalars->GetNumberOfTuples(); ++i)
      {
        scalars->SetComponent(i, 0, levels - 1.0 - scalars->GetComponent(i, 0));
      }
      vtkNew<vtkVolumeHapticsFilter> filter;
      filter->SetInputData(0, image);
      ASSERT_TRUE(filter->GetProperty()->ProposeFromImage(image));
      filter->SetKernelRadius(filter->GetProperty()->GetProposedKernelRadius());
      EXPECT_EQ(filter->GetProperty()->GetSurfaceSide(),
        isDark ? vtkHapticProperty::LOWER : vtkHapticProperty::HIGHER);
      const FeltRays felt = Feel(filter);
      EXPECT_LE(felt.Off, Rays / 50);
      EXPECT_LT(felt.Air, 0.1);
      EXPECT_LT(felt.Step, 0.5);
    }
  }
}
