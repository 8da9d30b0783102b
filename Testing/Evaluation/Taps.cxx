// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Taps.h"

#include "Rigs/Taps.h"

#include "Devices/Pad/Vibration.h"

#include <algorithm>

using namespace rigs;
using namespace VolumeHaptics;

namespace evaluation
{
namespace
{

/** Returns the mean level of a gamepad's weak motor during 50 ms after the touch. */
double FindVibration(const std::vector<double>& forces)
{
  constexpr std::size_t Ticks = 50;
  Vibration vibration;
  double sum = 0.0;
  for (std::size_t i = 0; i < Ticks; ++i)
  {
    const double force = i < forces.size() ? forces[i] : 0.0;
    sum += vibration.Advance({ 0.0, 0.0, force }, StiffArm::Period).Weak;
  }
  return sum / Ticks;
}

} // namespace

Table MeasureTaps()
{
  constexpr int Phases = 10;
  Table table;
  table.Title = "Taps";
  table.Text =
    "Arms like a Falcon and a Touch are thrown at a wall of 2 b / T. Effective: the ideal spring "
    "that stops the arm after the same way. Returned: energy with which the arm leaves / that with "
    "which it came, the largest of ten phases. Vibration: mean level of a pad's weak motor over "
    "the first 50 ms. The materials differ in their surface strength alone.";
  table.Columns = { "arm", "m/s", "gain", "strength, N", "Hz", "effective / k, mean", "least",
    "returned", "mJ too much", "vibration" };
  for (const StiffArm& arm : { StiffArm::FalconLike(), StiffArm::TouchLike() })
  {
    for (const double speed : { 0.05, 0.1, 0.3 })
    {
      for (const double gain : { 0.0, 0.5, 1.0 })
      {
        for (const double strength : { 0.7, 1.5, 12.0 })
        {
          if (gain == 0.0 && strength != 0.7)
          {
            continue;
          }
          const double frequency = ContactTransient::ComputeFrequency(arm.Sampled(), strength);
          double mean = 0.0;
          double least = 1e9;
          TapResult worst;
          double vibration = 0.0;
          for (int phase = 0; phase < Phases; ++phase)
          {
            Tap tap{ speed, arm.Sampled(), frequency, gain, static_cast<double>(phase) / Phases,
              true };
            const TapResult result = TapOnce(arm, tap);
            mean += result.Effective / Phases;
            least = std::min(least, result.Effective);
            worst.Returned = std::max(worst.Returned, result.Returned);
            worst.MostGiven = std::max(worst.MostGiven, result.MostGiven);
            tap.MovesTip = false;
            vibration += FindVibration(TapOnce(arm, tap).Forces) / Phases;
          }
          table.Rows.push_back(
            { arm.Name, Number(speed), Number(gain), gain > 0.0 ? Number(strength) : "-",
              gain > 0.0 ? Number(frequency) : "-", Number(mean / arm.Sampled()),
              Number(least / arm.Sampled()), Number(worst.Returned < 1e-6 ? 0.0 : worst.Returned),
              Number(1e3 * worst.MostGiven), Number(vibration) });
        }
      }
    }
  }
  return table;
}

} // namespace evaluation
