// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BumpyBall.h"

#include "Shapes.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
using Filter = vtkVolumeHapticsFilter;

constexpr double MeanRadius = 90.0;
constexpr double Bump = 2.0;
constexpr double Across = 5.0;
constexpr double Along = 6.0;
constexpr double Depth = 2.0;
constexpr double Above = 8.0;
constexpr double TickStep = 0.05;

/**
 * Returns a value that is zero on the surface and negative inside. Its gradient is not a unit
 * vector.
 */
double Off(const Vector3& x)
{
  return Norm(x) - MeanRadius - Bump * std::sin(x.X / Across) * std::cos(x.Y / Along);
}

Vector3 GradientOfOff(const Vector3& x)
{
  Vector3 g = (1.0 / Norm(x)) * x;
  g.X -= Bump / Across * std::cos(x.X / Across) * std::cos(x.Y / Along);
  g.Y += Bump / Along * std::sin(x.X / Across) * std::sin(x.Y / Along);
  return g;
}

/** Returns the point where the true surface meets a direction from the middle. */
Vector3 InDirection(const Vector3& out)
{
  double radius = MeanRadius;
  for (int i = 0; i < 50; ++i)
  {
    radius -= Off(radius * out);
  }
  return radius * out;
}

/**
 * Makes a stroke that presses in, and then follows the true surface at a constant depth along a
 * tilted circle for a length (mm).
 */
Stroke MakeStroke(double tilt, double length)
{
  const Vector3 start = { std::cos(tilt), 0.0, std::sin(tilt) };
  const Vector3 side = { 0.0, 1.0, 0.0 };
  const auto tip = [&](double angle, double height)
  {
    const SurfacePoint at =
      NearestOnBumpyBall(InDirection(std::cos(angle) * start + std::sin(angle) * side));
    return at.Position + height * at.Outward;
  };
  Stroke stroke{ tip(0.0, 0.0), start, { tip(0.0, Above) }, 0 };
  MoveTo(stroke.Tips, tip(0.0, -Depth), TickStep);
  stroke.Pressed = stroke.Tips.size();
  for (double way = TickStep; way < length; way += TickStep)
  {
    stroke.Tips.push_back(tip(way / MeanRadius, -Depth));
  }
  return stroke;
}

/** Makes the image, rounded to 16-bit integers as scans are. */
vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int half = static_cast<int>(MeanRadius + Bump + Above + 4.0);
  const int n = 2 * half + 1;
  image->SetDimensions(n, n, n);
  image->SetOrigin(-half, -half, -half);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* to = static_cast<short*>(image->GetScalarPointer());
  for (int k = -half; k <= half; ++k)
  {
    for (int j = -half; j <= half; ++j)
    {
      for (int i = -half; i <= half; ++i)
      {
        *to++ = static_cast<short>(std::lround(BumpyBallValue({ 1.0 * i, 1.0 * j, 1.0 * k })));
      }
    }
  }
  return image;
}
} // namespace

double BumpyBallValue(const Vector3& x)
{
  return 100.0 * (1.0 - std::tanh(0.5 * Off(x)));
}

SurfacePoint NearestOnBumpyBall(const Vector3& x)
{
  Vector3 p = x;
  Vector3 outward;
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 g = GradientOfOff(p);
    outward = (1.0 / Norm(g)) * g;
    const Vector3 aside = (x - p) - Dot(x - p, outward) * outward;
    const Vector3 step = 0.5 * aside - (Off(p) / Norm(g)) * outward;
    p = p + step;
    if (Norm(step) < 1e-12)
    {
      break;
    }
  }
  return { p, outward };
}

BumpyBallFeel FeelBumpyBall(Filter* filter, const Effort& effort)
{
  static const vtkSmartPointer<vtkImageData> image = MakeImage();
  filter->SetInputDataObject(0, image);
  BumpyBallFeel felt;
  const auto model = filter->GetBaker().Bake(1000.0, {}, nullptr);
  for (int i = 0; model && i < effort.Pick(2, 12); ++i)
  {
    const Stroke stroke = MakeStroke(0.1 + 0.1 * i, 60.0);
    const Trace trace = Play(*model, stroke.Tips);
    for (std::size_t tick = stroke.Pressed + 100; tick < trace.size(); ++tick)
    {
      if (Norm(trace[tick].Force) < 1e-6)
      {
        continue;
      }
      const Vector3 proxy = ProxyOf(trace[tick]);
      const SurfacePoint at = NearestOnBumpyBall(proxy);
      felt.Distance += Norm(proxy - at.Position);
      felt.Angle += 360.0 / TwoPi *
        std::atan2(Norm(Cross(trace[tick].Force, at.Outward)), Dot(trace[tick].Force, at.Outward));
      ++felt.Ticks;
    }
  }
  const double count = std::max<double>(1.0, felt.Ticks);
  felt.Distance /= count;
  felt.Angle /= count;
  return felt;
}

Table CompareOnBumpyBall(const Effort& effort)
{
  Table table{ "Felt where it is seen: a bumpy ball",
    "A ball of 90 voxels with bumps of 2, stroked 2 voxels deep without friction. The proxy's "
    "distance to the true surface and the angle of the force to its normal there, means.",
    { "method", "distance (voxels)", "angle (degrees)", "ticks with force" }, {} };
  const auto add = [&](const char* name, const std::function<void(Filter*)>& set)
  {
    vtkNew<Filter> filter;
    set(filter);
    const BumpyBallFeel felt = FeelBumpyBall(filter, effort);
    table.Rows.push_back(
      { name, Number(felt.Distance), Number(felt.Angle), std::to_string(felt.Ticks) });
  };
  add("PAPER", [](Filter* filter) { filter->SetSolverToPaper(); });
  add("PRECISE", [](Filter*) {});
  for (const bool isFar : { true, false })
  {
    for (const bool isEdge : { false, true })
    {
      const std::string name = std::string("PRECISE, ") + (isFar ? "far side" : "kernel") +
        (isEdge ? ", Edge" : ", Distinctness");
      add(name.c_str(),
        [=](Filter* filter)
        {
          filter->SetMaterialPlacement(isFar ? Filter::FAR_SIDE : Filter::KERNEL);
          filter->SetContactAlignment(isEdge ? Filter::EDGE : Filter::DISTINCTNESS);
        });
    }
  }
  add("SURFACE_PROXY",
    [](Filter* filter)
    {
      filter->SetMethodToSurfaceProxy();
      filter->SetProxyRadius(ProbeRadius);
      filter->SetIsoValue(100.0);
    });
  return table;
}

Figures MeasureBumpyBall(const Effort& effort)
{
  vtkNew<Filter> filter;
  const BumpyBallFeel felt = FeelBumpyBall(filter, effort);
  return { { "bumpy ball, default settings: proxy to the true surface, mean", "voxel",
             felt.Distance, 0.2 },
    { "bumpy ball, default settings: force to the true normal, mean", "degree", felt.Angle, 0.5 } };
}

} // namespace evaluation
