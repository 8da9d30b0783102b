// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TickRatio.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"

#include <algorithm>
#include <chrono>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr int Rounds = 3;

/** Runs the strokes, and adds the time (s) of each tick to `times`. */
void TimeTicks(const HapticModel& model, const std::vector<Arc>& arcs, std::vector<double>& times)
{
  using Clock = std::chrono::steady_clock;
  for (const Arc& arc : arcs)
  {
    ServoState state;
    TickRecord record;
    for (const Vector3& tip : arc.Tips)
    {
      const auto start = Clock::now();
      Tick(model, state, 0.001 * tip, record);
      times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
  }
}

double MedianOf(std::vector<double>& times)
{
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}
} // namespace

double MeasureTickRatio(
  const FeltSurface& surface, const Setting& measured, const Setting& reference)
{
  std::shared_ptr<const HapticModel> models[2];
  std::vector<double> times[2];
  for (const bool isReference : { false, true })
  {
    vtkNew<vtkVolumeHapticsFilter> filter;
    filter->SetInputDataObject(0, surface.Image);
    filter->GetProperty()->ApplyPreset(surface.Preset.c_str());
    (isReference ? reference : measured)(filter);
    models[isReference ? 1 : 0] = filter->GetBaker().Bake(1000.0, {}, nullptr);
  }
  if (!models[0] || !models[1] || surface.Arcs.empty())
  {
    return 0.0;
  }
  for (int round = 0; round < Rounds; ++round)
  {
    TimeTicks(*models[0], surface.Arcs, times[0]);
    TimeTicks(*models[1], surface.Arcs, times[1]);
  }
  return MedianOf(times[0]) / MedianOf(times[1]);
}

} // namespace evaluation
