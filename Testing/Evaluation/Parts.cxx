// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parts.h"

#include "Shapes.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Air = 4000.0;
constexpr double Metal = 24000.0; // grey value above air at the ball's surface
constexpr double Cupping = 0.12;
constexpr double BeamBlur = 1.2; // mm, scale of the metal ball's edge
constexpr double NoiseOfMetal = 400.0;
constexpr double Label = 3.0;
constexpr double Room = 14.0; // mm around a ball, where the hand starts

double OffBall(const Vector3& x)
{
  return Norm(x - OddCentre) - PartRadius;
}

/** Samples a field with noise of a given standard deviation, rounded to 16-bit integers. */
vtkSmartPointer<vtkImageData> MakeImage(const Field& field, double noise)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int half = static_cast<int>(PartRadius + Room);
  const int n = 2 * half + 1;
  image->SetDimensions(n, n, n);
  image->SetOrigin(-half, -half, -half);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* to = static_cast<short*>(image->GetScalarPointer());
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int k = -half; k <= half; ++k)
  {
    for (int j = -half; j <= half; ++j)
    {
      for (int i = -half; i <= half; ++i)
      {
        const double value = field({ 1.0 * i, 1.0 * j, 1.0 * k });
        *to++ =
          static_cast<short>(std::lround(noise > 0.0 ? value + noise * normal(random) : value));
      }
    }
  }
  return image;
}

/** Returns strokes along great circles in planes that contain no axis. */
std::vector<Arc> FindGreatCircles(vtkImageData* image, double level, const Effort& effort)
{
  const std::pair<Vector3, Vector3> planes[] = { { OddAside, OddUp }, { OddUp, OddNormal },
    { OddNormal, OddAside } };
  std::vector<Arc> arcs;
  for (int i = 0; i < effort.Pick(1, 3); ++i)
  {
    Course course;
    course.Level = level;
    course.Middles = { OddCentre };
    course.Side = planes[i].first;
    course.Up = planes[i].second;
    course.Radius = PartRadius;
    const std::vector<Arc> found = FindArcs(image, course);
    arcs.insert(arcs.end(), found.begin(), found.end());
  }
  return arcs;
}
} // namespace

double MetalValue(const Vector3& x)
{
  const double fraction = std::min(1.0, Norm(x - OddCentre) / PartRadius);
  const double rise = Metal * (1.0 - Cupping * (1.0 - fraction * fraction));
  return Air + BlurredStep(-OffBall(x), BeamBlur, rise);
}

std::vector<FeltSurface> MakePartSurfaces(const Effort& effort)
{
  const auto metal = MakeImage(MetalValue, NoiseOfMetal);
  const auto label =
    MakeImage([](const Vector3& x) { return OffBall(x) <= 0.0 ? Label : 0.0; }, 0.0);
  const double edge = Air + 0.5 * Metal;
  const double wall = 0.5 * Label;
  return { { "industrial CT", "ball", "Micro-CT", metal, edge,
             FindGreatCircles(metal, edge, effort), 0.1 * Metal, true },
    { "label map", "ball", "Labels", label, wall, FindGreatCircles(label, wall, effort), LabelRamp,
      true } };
}

double SlidingForce(double radius, double depth, double stiffness, double friction)
{
  const double cosine = 1.0 / std::hypot(1.0, friction);
  const double along = radius * cosine;
  const double aside = radius * friction * cosine;
  const double tip = radius - depth;
  return 0.001 * stiffness * (along - std::sqrt(tip * tip - aside * aside));
}

PartFeel FeelPart(const FeltSurface& part)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputDataObject(0, part.Image);
  vtkHapticProperty* const feel = filter->GetProperty();
  feel->ApplyPreset(part.Preset.c_str());
  // The solid's value is far above the preset's ramps, so the functions are constant there.
  const double solid = part.Image->GetScalarRange()[1];
  const double stiffness = feel->GetStiffness()->GetValue(solid);
  const double friction = feel->GetFriction()->GetValue(solid);
  const auto model = filter->GetBaker().Bake(1000.0, {}, nullptr);
  PartFeel felt;
  for (std::size_t i = 0; model && i < part.Arcs.size(); ++i)
  {
    const Arc& arc = part.Arcs[i];
    const Trace trace = Play(*model, arc.Tips);
    for (std::size_t tick = arc.GetSettled(); tick < trace.size(); ++tick)
    {
      const double off = std::abs(OffBall(ProxyOf(trace[tick])));
      felt.Distance += off;
      felt.Largest = std::max(felt.Largest, off);
      felt.Force += Norm(trace[tick].Force);
      felt.Expected += SlidingForce(PartRadius, -OffBall(arc.Tips[tick]), stiffness, friction);
      ++felt.Ticks;
    }
  }
  const double count = std::max<double>(1.0, felt.Ticks);
  felt.Distance /= count;
  felt.Force /= count;
  felt.Expected /= count;
  return felt;
}

Table ComparePartsWithFormulas(const std::vector<FeltSurface>& parts)
{
  Table table{ "Scans that are made, beside their formulas",
    "Balls of 40 voxels, stroked as above with the default settings: the proxy's distance to the "
    "true sphere, and the force beside that of a tip that slides at the same depth under it.",
    { "surface", "preset", "distance, mean (voxels)", "largest", "force, mean (N)",
      "by the formula (N)", "ticks" },
    {} };
  for (const FeltSurface& part : parts)
  {
    const PartFeel felt = FeelPart(part);
    table.Rows.push_back(
      { part.Scan + ", " + part.Name, part.Preset, Number(felt.Distance), Number(felt.Largest),
        Number(felt.Force), Number(felt.Expected), std::to_string(felt.Ticks) });
  }
  return table;
}

} // namespace evaluation
