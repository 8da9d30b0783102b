// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/HungWeight.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{

/// The handle is at rest if its position stays within RestPlace (m) and the force within
/// RestFraction of the largest force, for RestTime (s).
constexpr double RestPlace = 0.3e-3;
constexpr double RestFraction = 0.02;
constexpr double RestTime = 2.0;
/// SaturatedFraction: fraction of the largest force above which the force counts as limited.
/// MostSaturation: longest time (s) at the limit before the measurement fails.
constexpr double SaturatedFraction = 0.97;
constexpr double MostSaturation = 1.0;
/// Longest time (s) until a released handle is at rest.
constexpr double SettleTime = 20.0;
/// Thresholds for detecting a weight: the force has to change by more than NoticedFraction of the
/// largest force and by more than NoticedFriction times the friction, which can act on the handle
/// in either direction without a weight.
constexpr double NoticedFraction = 0.01;
constexpr double NoticedFriction = 1.2;
/// Smallest acceptable change of the force by a weight, without friction, as a fraction of the
/// largest force.
constexpr double LeastFraction = 0.04;
/// Limits, as fractions of the change of the force, of the range of the readings, the drift of the
/// zero, and the pull perpendicular to the axis.
constexpr double MostRange = 0.1;
constexpr double MostDrift = 0.1;
constexpr double MostAcross = 0.35;
constexpr int PairsWithout = 2;
constexpr int PairsWith = 3;

std::string Format(const char* format, double a, double b = 0.0)
{
  char text[500];
  std::snprintf(text, sizeof(text), format, a, b);
  return text;
}

using Reading = HandleSweep::Reading;

double MedianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

std::vector<double> Along(
  std::vector<Reading>::const_iterator first, std::vector<Reading>::const_iterator end, int axis)
{
  std::vector<double> forces;
  std::transform(first, end, std::back_inserter(forces),
    [axis](const Reading& reading) { return reading.Force[axis]; });
  return forces;
}

double RangeOf(const std::vector<double>& values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

} // namespace

HungWeight::HungWeight(const Settings& settings)
  : Given(settings)
  , Rest(RestPlace, RestFraction * settings.MostForce, RestTime)
{
}

const char* HungWeight::GetRequest() const
{
  switch (this->Now)
  {
    case Phase::Settle:
      return "Let the handle go slowly: a spring holds it. Don't touch it from now on.";
    case Phase::Before:
      return "Reading without the weight. Don't touch the handle.";
    case Phase::Hang:
      return "Hang the weight on the handle, gently, and take your hand away.";
    case Phase::With:
      return "Reading with the weight. Don't touch it.";
    case Phase::TakeOff:
      return "Hold the handle, take the weight off, and let the handle go slowly.";
    case Phase::After:
      return "Reading again without the weight. Don't touch the handle.";
    case Phase::Done:
    case Phase::Refused:
      break;
  }
  return "Hold the handle: the force ends.";
}

void HungWeight::Refuse(const std::string& fault)
{
  this->Fault = fault;
  this->Now = Phase::Refused;
}

void HungWeight::Begin(Phase phase, const HeldSample& sample)
{
  const int axis = this->Given.Axis;
  this->Now = phase;
  this->PhaseTime = 0.0;
  this->IsChanged = false;
  this->Rest.Reset();
  if (phase == Phase::Before)
  {
    this->Place = sample.Tip[axis];
  }
  if (phase == Phase::Before || phase == Phase::With || phase == Phase::After)
  {
    this->Sweep.Begin(
      axis, this->Place, this->Shift, phase == Phase::With ? PairsWith : PairsWithout);
  }
}

void HungWeight::UpdateSweep(const HeldSample& sample, Phase next)
{
  this->Sweep.Step(sample);
  this->Shift = this->Sweep.GetShift();
  if (this->Sweep.IsStuck())
  {
    this->Refuse(
      "The handle does not follow the device along this axis. See that nothing holds it, "
      "and that --axis names the vertical one.");
    return;
  }
  if (!this->Sweep.IsDone())
  {
    return;
  }
  const std::vector<Reading>& readings = this->Sweep.GetReadings();
  std::vector<Reading>& kept = this->Now == Phase::With ? this->With : this->Without;
  kept.insert(kept.end(), readings.begin(), readings.end());
  for (const Reading& reading : readings)
  {
    this->Friction = std::max(this->Friction, std::abs(reading.Friction));
  }
  this->CountBefore = this->Now == Phase::Before ? kept.size() : this->CountBefore;
  next == Phase::Done ? this->Judge() : this->Begin(next, sample);
}

void HungWeight::WaitForWeight(const HeldSample& sample)
{
  const double noticed = NoticedFraction * this->Given.MostForce + NoticedFriction * this->Friction;
  const double without =
    MedianOf(Along(this->Without.begin(), this->Without.end(), this->Given.Axis));
  const double force = sample.Force[this->Given.Axis];
  const bool rests = this->Rest.Step(sample.Tip[this->Given.Axis], force, sample.Elapsed);
  this->IsChanged = std::abs(force - without) > noticed;
  if (rests && this->IsChanged)
  {
    this->Begin(Phase::With, sample);
  }
  else if (this->PhaseTime > this->Given.Patience)
  {
    this->Refuse(this->IsChanged
        ? "The handle does not come to rest with the weight. Take your hand away, and keep the "
          "weight from swinging."
        : Format("Nothing has changed for %.0f s: no weight was hung, it is too light, or --axis "
                 "does not name the vertical axis. The friction alone holds %.2f N.",
            this->Given.Patience, this->Friction));
  }
}

void HungWeight::WaitForRemoval(const HeldSample& sample)
{
  const double with = MedianOf(Along(this->With.begin(), this->With.end(), this->Given.Axis));
  const double without =
    MedianOf(Along(this->Without.begin(), this->Without.end(), this->Given.Axis));
  const double force = sample.Force[this->Given.Axis];
  const bool rests = this->Rest.Step(sample.Tip[this->Given.Axis], force, sample.Elapsed);
  const bool isOff = std::abs(force - without) < 0.5 * std::abs(with - without) ||
    (force - without) * (with - without) < 0.0;
  if (rests && isOff)
  {
    this->Begin(Phase::After, sample);
  }
  else if (this->PhaseTime > this->Given.Patience)
  {
    this->Refuse("The weight was not taken off, or the handle does not come to rest without it.");
  }
}

void HungWeight::Judge()
{
  const int axis = this->Given.Axis;
  const auto middle = this->Without.begin() + static_cast<std::ptrdiff_t>(this->CountBefore);
  const std::vector<double> before = Along(this->Without.begin(), middle, axis);
  const std::vector<double> after = Along(middle, this->Without.end(), axis);
  const std::vector<double> with = Along(this->With.begin(), this->With.end(), axis);
  const double without = 0.5 * (MedianOf(before) + MedianOf(after));
  const double change = MedianOf(with) - without;
  const double size = std::abs(change);
  double across = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double other = MedianOf(Along(this->With.begin(), this->With.end(), i)) -
      MedianOf(Along(this->Without.begin(), this->Without.end(), i));
    across = i == axis ? across : std::hypot(across, other);
  }
  const double least = LeastFraction * this->Given.MostForce;
  if (size < least)
  {
    this->Refuse(Format("The weight is too light: it changes the force by %.2f N, and it has to be "
                        "%.2f N or more. Hang a heavier one.",
      size, least));
    return;
  }
  if (across > MostAcross * size)
  {
    this->Refuse(Format("The weight pulls along another axis: %.2f N along this one, %.2f N across "
                        "it. Stand the device level, or name the vertical axis with --axis.",
      size, across));
    return;
  }
  const double drift = std::abs(MedianOf(after) - MedianOf(before));
  if (drift > MostDrift * size)
  {
    this->Refuse(Format("The force without the weight is not what it was before, by %.2f N of "
                        "%.2f N. Let the device warm up, keep your hands off, and try again.",
      drift, size));
    return;
  }
  const double range = std::max({ RangeOf(with), RangeOf(before), RangeOf(after) });
  if (range > MostRange * size)
  {
    this->Refuse(Format("The readings differ by %.2f N of %.2f N. Keep your hands off, keep the "
                        "weight from swinging, or hang a heavier one.",
      range, size));
    return;
  }
  this->Factor = this->Given.Weight / size;
  this->Doubt = 0.5 * this->Factor * std::max(range, drift) / size;
  this->Now = Phase::Done;
}

void HungWeight::Step(const HeldSample& sample)
{
  if (this->IsOver())
  {
    return;
  }
  const std::array<double, 3>& f = sample.Force;
  const double size = std::hypot(f[0], f[1], f[2]);
  const bool isSaturated = size >= SaturatedFraction * this->Given.MostForce;
  this->SaturatedTime = isSaturated ? this->SaturatedTime + sample.Elapsed : 0.0;
  this->PhaseTime += sample.Elapsed;
  if (this->SaturatedTime > MostSaturation)
  {
    const bool hasWeight = this->Now != Phase::Settle && this->Now != Phase::Before;
    this->Refuse(Format(hasWeight
        ? "The force is at its limit of %.2f N: the weight is too heavy, or a hand pulls. Hang a "
          "lighter one, of %.0f g or less."
        : "The force is at its limit of %.2f N without a weight: a hand pulls, or the device can't "
          "hold its own handle.",
      this->Given.MostForce, 0.5e3 * this->Given.Weight / Gravity));
    return;
  }
  switch (this->Now)
  {
    case Phase::Settle:
      if (this->Rest.Step(sample.Tip[this->Given.Axis], f[this->Given.Axis], sample.Elapsed))
      {
        this->Begin(Phase::Before, sample);
      }
      else if (this->PhaseTime > SettleTime)
      {
        this->Refuse("The handle does not come to rest. Let it go, and stand the device firmly.");
      }
      break;
    case Phase::Before:
      this->UpdateSweep(sample, Phase::Hang);
      break;
    case Phase::Hang:
      this->WaitForWeight(sample);
      break;
    case Phase::With:
      this->UpdateSweep(sample, Phase::TakeOff);
      break;
    case Phase::TakeOff:
      this->WaitForRemoval(sample);
      break;
    case Phase::After:
      this->UpdateSweep(sample, Phase::Done);
      break;
    case Phase::Done:
    case Phase::Refused:
      break;
  }
}
