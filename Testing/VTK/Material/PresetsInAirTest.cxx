// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests every preset with a hand that presses through 60 mm of noisy air into a wall: the force
 * must reach 0.1 N at a depth of 5 mm. It must also do so on the slopes of knobs of skin, where the
 * hand slides off.
 */

#include "Rigs/ApiRig.h"

#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace apitest;

namespace
{
constexpr double Air = 60.0; // mm in front of the wall
constexpr double Deep = 5.0; // mm behind the wall's surface
constexpr double Felt = 0.1; // N that a hand notices
constexpr int Side = 20;     // number of voxels, each 1 mm wide
constexpr int Presses = 6;   // number of presses in one volume

/// Values of air and of a wall in a kind of scan, and its largest noise, which is equivalent to 60
/// HU.
struct Scan
{
  double Outside = -1000.0;
  double Inside = 60.0;
  double MostNoise = 60.0;
};

Scan FindScan(const std::string& preset)
{
  if (preset == "MRI")
  {
    return { 4.0, 200.0, 12.0 };
  }
  return preset == "Labels" ? Scan{ 0.0, 5.0, 0.0 } : Scan{};
}

vtkSmartPointer<vtkImageData> MakeScan(const Scan& scan, double noise, unsigned seed)
{
  vtkNew<vtkImageData> image;
  const int depth = static_cast<int>(Air + 4.0 * Deep);
  image->SetDimensions(Side, Side, depth);
  const bool isLabels = scan.MostNoise == 0.0;
  image->AllocateScalars(isLabels ? VTK_UNSIGNED_CHAR : VTK_FLOAT, 1);
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> random;
  for (int k = 0; k < depth; ++k)
  {
    // The wall is a step between two samples, blurred like a scanner's image.
    const double fraction = 0.5 * (1.0 + std::erf((k - Air) / (0.8 * std::sqrt(2.0))));
    const double value = isLabels ? (k >= Air ? scan.Inside : scan.Outside)
                                  : scan.Outside + fraction * (scan.Inside - scan.Outside);
    for (int j = 0; j < Side; ++j)
    {
      for (int i = 0; i < Side; ++i)
      {
        const double sample = value + noise * random(engine);
        // Scans in grey levels have no values below 0.
        image->SetScalarComponentFromDouble(
          i, j, k, 0, scan.Outside >= 0.0 ? std::max(0.0, sample) : sample);
      }
    }
  }
  return image;
}

/// Returns the force (N) at the end of each press.
std::vector<double> Press(vtkVolumeHapticsFilter* filter)
{
  std::vector<double> forces;
  for (int n = 0; n < Presses; ++n)
  {
    const double x = 6.0 + 1.6 * n;
    const double y = 13.3 - 1.1 * n;
    const vtkSmartPointer<vtkPolyData> path =
      MakePath(Line({ x, y, 1.0 }, { x, y, Air + Deep }, 640));
    filter->SetPathData(path);
    filter->Update();
    const vtkIdType last = filter->GetOutput()->GetNumberOfPoints() - 1;
    const double f[3] = { Get(filter->GetOutput(), "Force", last, 0),
      Get(filter->GetOutput(), "Force", last, 1), Get(filter->GetOutput(), "Force", last, 2) };
    forces.push_back(std::hypot(f[0], f[1], f[2]));
  }
  return forces;
}

struct Method
{
  const char* Name;
  std::function<void(vtkVolumeHapticsFilter*, const Scan&)> Choose;
};

const Method Methods[] = {
  { "PRECISE", [](vtkVolumeHapticsFilter*, const Scan&) {} },
  { "PRECISE, kernel",
    [](vtkVolumeHapticsFilter* filter, const Scan&) { filter->SetMaterialPlacementToKernel(); } },
  { "PRECISE, distinctness",
    [](vtkVolumeHapticsFilter* filter, const Scan&)
    { filter->SetContactAlignmentToDistinctness(); } },
  { "PAPER", [](vtkVolumeHapticsFilter* filter, const Scan&) { filter->SetSolverToPaper(); } },
  { "SURFACE_PROXY",
    [](vtkVolumeHapticsFilter* filter, const Scan& scan)
    {
      filter->SetMethodToSurfaceProxy();
      filter->SetIsoValue(0.5 * (scan.Outside + scan.Inside));
    } },
  { "LOCAL_SURFACE",
    [](vtkVolumeHapticsFilter* filter, const Scan& scan)
    {
      filter->SetMethodToLocalSurface();
      filter->SetIsoValue(0.5 * (scan.Outside + scan.Inside));
    } },
};
} // namespace

/// Makes a knob of skin in air, like an ear or a chin: a ball with one value.
vtkSmartPointer<vtkImageData> MakeKnob(double radius, double value)
{
  constexpr double middle = 24.0;
  return MakeImage(49, VTK_FLOAT,
    [=](const Point& x)
    {
      const double r = std::hypot(x[0] - middle, x[1] - middle, x[2] - middle);
      return -1000.0 + 0.5 * (value + 1000.0) * std::erfc((r - radius) / (0.8 * std::sqrt(2.0)));
    });
}

class PresetsInAir : public testing::TestWithParam<std::string>
{
};

TEST_P(PresetsInAir, LeaveNoWallUnfelt)
{
  const Scan scan = FindScan(this->GetParam());
  int presses = 0;
  for (const double fraction : { 0.0, 0.25, 0.5, 0.75, 1.0 })
  {
    const double noise = fraction * scan.MostNoise;
    const vtkSmartPointer<vtkImageData> image =
      MakeScan(scan, noise, static_cast<unsigned>(1 + 100.0 * fraction));
    for (const Method& method : Methods)
    {
      const bool isOfValues = std::string(method.Name).find("_") == std::string::npos;
      if (scan.MostNoise == 0.0 && !isOfValues)
      {
        continue; // skips the labels, which only PROXY can touch
      }
      vtkNew<vtkVolumeHapticsFilter> filter;
      filter->GetProperty()->ApplyPreset(this->GetParam().c_str());
      filter->SetInputData(0, image);
      method.Choose(filter, scan);
      for (const double force : Press(filter))
      {
        EXPECT_GT(force, Felt) << method.Name << ", noise " << noise;
        ++presses;
      }
    }
  }
  EXPECT_GE(presses, 120);
}

TEST_P(PresetsInAir, LeaveNoSlopeUnfelt)
{
  if (this->GetParam().find("CT ") != 0)
  {
    return; // skips presets that are not for CT values
  }
  // On a slope of 40 degrees, a finger slides off slippery skin. Just below the skin, a head CT has
  // values from -56 to 37 HU (Documentation/materials.md).
  constexpr double middle = 24.0;
  constexpr double slope = 40.0 * 3.14159265358979 / 180.0;
  for (const double radius : { 6.0, 9.0, 12.0 })
  {
    for (const double value : { -56.0, -30.0, -10.0, 0.0, 10.0, 15.0, 20.0, 25.0, 30.0, 37.0 })
    {
      const vtkSmartPointer<vtkImageData> knob = MakeKnob(radius, value);
      const double x = middle + radius * std::sin(slope);
      const double z = middle - radius * std::cos(slope);
      for (const bool isKernel : { false, true })
      {
        vtkNew<vtkVolumeHapticsFilter> filter;
        filter->GetProperty()->ApplyPreset(this->GetParam().c_str());
        if (isKernel)
        {
          filter->SetMaterialPlacementToKernel();
        }
        filter->SetInputData(0, knob);
        filter->SetPathData(MakePath(Line({ x, middle, 1.0 }, { x, middle, z + Deep }, 200)));
        filter->Update();
        vtkPolyData* const felt = filter->GetOutput();
        const auto force = [=](vtkIdType tick, int axis) { return Get(felt, "Force", tick, axis); };
        double most = 0.0;
        for (vtkIdType i = 0; i < felt->GetNumberOfPoints(); ++i)
        {
          most = std::max(most, std::hypot(force(i, 0), force(i, 1), force(i, 2)));
        }
        EXPECT_GT(most, Felt) << radius << " mm, " << value << " HU, kernel " << isKernel;
      }
    }
  }
}

/// A plateau precedes a wall of 60 HU. A plateau of at most -420 HU is a blanket, which the hand
/// penetrates until it touches the wall. A plateau of at least -400 HU is skin, which the hand
/// touches instead of the wall.
TEST(PresetsAtTheEdgeOfSkin, PhysicalPassesABlanketAndHoldsSkin)
{
  constexpr double plateau = 12.0; // mm, z of the plateau
  constexpr double wall = 24.0;    // mm, z of the wall
  for (const double value : { -550.0, -420.0, -250.0, -150.0 })
  {
    const auto step = [](double x) { return 0.5 * std::erfc(-x / (0.8 * std::sqrt(2.0))); };
    const vtkSmartPointer<vtkImageData> image = MakeImage(37, VTK_FLOAT,
      [=](const Point& x) {
        return -1000.0 + (value + 1000.0) * step(x[2] - plateau) +
          (60.0 - value) * step(x[2] - wall);
      });
    vtkNew<vtkVolumeHapticsFilter> filter;
    filter->GetProperty()->ApplyPreset("CT physical");
    filter->SetInputData(0, image);
    filter->SetPathData(
      MakePath(Line({ 18.0, 18.0, 1.0 }, { 18.0, 18.0, wall + 2.0 * Deep }, 640)));
    filter->Update();
    vtkPolyData* const felt = filter->GetOutput();
    double place = 0.0; // position (mm) of the first 0.1 N
    for (vtkIdType i = 0; i < felt->GetNumberOfPoints() && place == 0.0; ++i)
    {
      const double force =
        std::hypot(Get(felt, "Force", i, 0), Get(felt, "Force", i, 1), Get(felt, "Force", i, 2));
      place = force >= Felt ? felt->GetPoint(i)[2] : 0.0;
    }
    EXPECT_NEAR(place, value > -400.0 ? plateau : wall, 2.0) << value << " HU";
  }
}

INSTANTIATE_TEST_SUITE_P(All, PresetsInAir,
  testing::Values(
    "CT contrast", "CT physical", "CT angiography", "CT chest", "MRI", "Micro-CT", "Labels"),
  [](const testing::TestParamInfo<std::string>& info)
  {
    std::string name;
    for (const char letter : info.param)
    {
      name += std::isalnum(static_cast<unsigned char>(letter)) ? std::string(1, letter) : "";
    }
    return name;
  });
