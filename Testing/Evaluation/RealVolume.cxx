// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RealVolume.h"

#include "VTK/Filter/HapticBaker.h"

#include "Energy.h"
#include "Shapes.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVolumeHapticsFilter.h"

#include <chrono>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Speed = 0.2; // mm per tick, of the tip

/**
 * Returns a path that enters along a line until a surface resists, then goes deeper, sideways and
 * out.
 */
Path PressSomewhere(const HapticModel& model, const double* bounds, std::mt19937& random)
{
  Uniform uniform(random);
  const Vector3 middle = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double around = uniform(0.0, TwoPi);
  const double up = uniform(-0.3, 0.9);
  const double flat = std::sqrt(1.0 - up * up);
  const Vector3 out = { flat * std::cos(around), flat * std::sin(around), up };
  const double radius =
    0.5 * Norm({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  Path path = { middle + radius * out };
  ServoState state;
  TickRecord record;
  Tick(model, state, 0.001 * path[0], record);
  double depth = 0.0;
  while (depth < radius && Norm(record.Force) < 0.05)
  {
    depth += Speed;
    path.push_back(middle + (radius - depth) * out);
    Tick(model, state, 0.001 * path.back(), record);
  }
  Vector3 aside = Cross(out, { 0.0, 0.0, 1.0 });
  aside = (1.0 / Norm(aside)) * aside;
  const Vector3 deep = path.back() - uniform(2.0, 8.0) * out;
  MoveTo(path, deep, Speed);
  MoveTo(path, deep + uniform(-15.0, 15.0) * aside, Speed);
  MoveTo(path, path.back() + 60.0 * out, Speed);
  return path;
}
} // namespace

Figures MeasureRealVolume(vtkImageData* image, HapticSolver solver, const Effort& effort)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputDataObject(0, image);
  filter->GetProperty()->ApplyPreset("CT contrast");
  filter->SetSolver(solver == HapticSolver::Paper ? vtkVolumeHapticsFilter::PAPER
                                                  : vtkVolumeHapticsFilter::PRECISE);
  const auto model = filter->GetBaker().Bake(1000.0, {}, nullptr);
  if (!model)
  {
    return {};
  }
  std::mt19937 random(3);
  double given = 0.0;
  double beyond = 0.0;
  int late = 0;
  std::vector<double> times;
  for (int press = effort.Pick(20, 400); press > 0; --press)
  {
    const Path path = PressSomewhere(*model, image->GetBounds(), random);
    ServoState state;
    Trace trace(path.size());
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      const auto start = std::chrono::steady_clock::now();
      Tick(*model, state, 0.001 * path[i], trace[i]);
      times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      const TickRecord& tick = trace[i];
      const double bound = tick.SurfaceStrength * std::hypot(1.0, tick.Friction) + tick.Viscosity;
      beyond = std::max(beyond, Norm(tick.Force) - bound);
      late += tick.IsUnfinished ? 1 : 0;
    }
    given = std::max(given, EnergyGiven(path, trace));
  }
  std::sort(times.begin(), times.end());
  const double million = 1e6 / static_cast<double>(times.size());
  return { { "energy created over closed cycles, most", "uJ", 1e6 * given, 0.1 },
    { "force beyond what the material holds, most", "N", std::max(0.0, beyond), 1e-9 },
    // A proxy that slips many voxels at once arrives some ticks later, and its records report
    // unfinished motion. A short run may have three such ticks.
    { "ticks that spent their budget, of a million", "", million * late,
      std::max(100.0, 3.0 * million) },
    { "tick, median", "us", 1e6 * times[times.size() / 2], 1.0, true },
    { "tick, 99th percentile", "us", 1e6 * times[times.size() * 99 / 100], 10.0, true } };
}

} // namespace evaluation
