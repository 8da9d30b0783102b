// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/SafetyStage.h"

#include "Core/Safety/DeviceBackend.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Longest time (s) until a force has fallen to zero if there are no samples. */
constexpr double RetreatTime = 0.02;

/**
 * Computes the energy (J) that an input's spring gives back when it relaxes, if at most `most` (N)
 * of its pull is felt. The pull is computed from the stretch, because the force may be clamped.
 * Returns a negative number if the stiffness is not known.
 */
double ComputeRecoverable(const SafetyInput& input, double most) noexcept
{
  const double k = input.Stiffness;
  const double pull = std::max(Norm(input.Force), k * input.Stretch);
  return k > 0.0 ? 0.5 * most * (2.0 * pull - most) / k : -1.0;
}

/**
 * Returns the fraction of the device's largest damping that is stable with the loop's round trip.
 */
double ComputeDampingShare(const SafetyInput& input) noexcept
{
  return std::min(1.0, StatedRoundTrip / std::max(input.Period, input.RoundTrip));
}

/** Returns the magnitude (N) to which a force in the direction of `wall` may grow after `last`. */
double ComputeMost(
  const Vector3& last, const Vector3& wall, double period, const SafetyLimits& limits) noexcept
{
  // A margin, so that rounding does not cut a force that the slew limit allows.
  constexpr double above = 1.0 + 1e-12;
  const double norm = Norm(wall);
  const double before = norm > 0.0 ? std::max(0.0, Dot(last, wall) / norm) : 0.0;
  return std::min(limits.MaximumForce, above * (before + limits.MaximumForceRate * period));
}

} // namespace

void SafetyStage::Reset() noexcept
{
  this->HasTip = false;
  this->Growth.Reset();
  this->Observer.Reset();
  this->Energy.Reset();
  this->Augmentation.Reset();
  this->Transient.Reset();
  this->Damper.Reset();
  this->Augmented = {};
  this->Touched = {};
}

bool SafetyStage::IsForceLeft() const noexcept
{
  const Vector3& last = this->Growth.GetForce();
  return Dot(last, last) > 0.0;
}

GrowthInput SafetyStage::ComputeGrowth(
  const SafetyInput& input, const SafetyLimits& limits) const noexcept
{
  const Vector3 clamped = ClampNorm(input.Force, limits.MaximumForce);
  const double norm = Norm(input.Force);
  GrowthInput growth;
  growth.Wanted = clamped;
  growth.Drag = norm > 0.0 ? Norm(clamped) / norm * input.Drag : Vector3{};
  growth.Tip = input.Tip;
  growth.IsMeasured = input.Fresh;
  growth.Recoverable = ComputeRecoverable(input, Norm(clamped));
  return growth;
}

Vector3 SafetyStage::Retreat(
  const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept
{
  // Without fresh samples, a force must end soon, even if the slew limit is low.
  const double rate = std::max(limits.MaximumForceRate, limits.MaximumForce / RetreatTime);
  Vector3 last = ClampNorm(this->Growth.GetForce(), limits.MaximumForce);
  // Augmentation and pulses may have made the sent force smaller.
  const double sent = std::min(Norm(last), Norm(this->Touched));
  const double most = std::max(0.0, sent - rate * input.Period);
  if (input.Fresh || input.Alive)
  {
    // The hand's position is known, so limit the last force as in any other tick: it may push the
    // hand only as far as the wanted force does.
    GrowthInput growth = this->ComputeGrowth(input, limits);
    growth.Share = gate.GetOpening();
    last = this->Growth.Apply(growth);
  }
  const Vector3 next = ClampNorm(last, most);
  this->Growth.Lower(next);
  this->Augmented = this->Touched = next;
  gate.ReportRetreat(this->Stale, this->IsForceLeft());
  return next;
}

double SafetyStage::MeasureSpeed(const SafetyInput& input) noexcept
{
  // A tick that wakes up late may be followed by an early one, but the device has moved for a whole
  // period.
  const double measured = input.MotionTime > 0.0 ? input.MotionTime : this->SampleAge;
  const double time = std::max(measured, input.Period);
  const double speed = this->HasTip && time > 0.0 ? Norm(input.Tip - this->LastTip) / time : 0.0;
  this->LastTip = input.Tip;
  this->HasTip = true;
  return speed;
}

void SafetyStage::ObserveGains(
  const SafetyInput& input, const SafetyLimits& limits, bool finite) noexcept
{
  const bool taps = limits.TransientGain > 0.0 && (!limits.MovesTip || input.RoundTrip > 0.0);
  const bool augments = input.Feedback > 0.0;
  // A rule that was switched off has not observed the ticks in between.
  if (taps && !this->Taps)
  {
    this->Transient.Reset();
  }
  if (augments && !this->Augments)
  {
    this->Augmentation.Reset();
  }
  this->Taps = taps;
  this->Augments = augments;
  if (!finite || !(input.Fresh || input.Alive))
  {
    return;
  }
  const double time = input.MotionTime > 0.0 ? input.MotionTime : this->SampleAge;
  const double late = std::max(0.0, 0.5 * (input.RoundTrip - time));
  if (taps && input.Fresh)
  {
    this->Transient.Observe(input.Tip, time, late, input.Period);
  }
  else if (taps)
  {
    this->Transient.Rest(input.Elapsed);
  }
  if (augments && input.Fresh)
  {
    this->Augmentation.Observe(
      input.Tip, time, late, 0.5 * input.Feedback * std::max(input.RoundTrip, input.Period));
  }
  else if (augments)
  {
    this->Augmentation.Rest(input.Elapsed);
  }
}

bool SafetyStage::UpdateSamples(
  const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept
{
  this->SampleAge += input.Elapsed;
  this->Silence += input.Elapsed;
  const bool finite = IsFinite(input.Force) && IsFinite(input.Torque) && IsFinite(input.Tip);
  double speed = 0.0;
  bool isActive = false;
  bool givesEnergy = false;
  this->Stale = this->Silence > limits.WatchdogTime;
  // A gap counts even if a fresh sample ends it, because the hand was not observed during the gap.
  const bool gap = this->Stale;
  this->ObserveGains(input, limits, finite);
  if (input.Fresh && finite)
  {
    speed = this->MeasureSpeed(input);
    const double time = input.MotionTime > 0.0 ? input.MotionTime : this->SampleAge;
    isActive = this->Observer.Observe(input.Tip, time);
    givesEnergy = this->Energy.Observe(input.Tip, time);
    this->Damper.Observe(input.Tip, time);
    this->SampleAge = 0.0;
  }
  if ((input.Fresh || input.Alive) && finite)
  {
    this->Silence = 0.0;
    this->Stale = false;
  }
  if (input.Lost)
  {
    gate.ReportFault(GateReason::DeviceLost);
  }
  else if (!finite)
  {
    gate.ReportFault(GateReason::NotFinite);
  }
  else if (limits.MaximumSpeed > 0.0 && speed > limits.MaximumSpeed)
  {
    gate.ReportFault(GateReason::OverSpeed);
  }
  else if (limits.MovesTip && isActive)
  {
    gate.ReportFault(GateReason::Active);
  }
  else if (limits.MovesTip && givesEnergy)
  {
    this->Damper.IsEngaged() ? gate.ReportUnstable() : this->Damper.Engage();
  }
  return gap;
}

Vector3 SafetyStage::ComputeCommand(
  const SafetyInput& input, const SafetyLimits& limits, bool gap, ForceGate& gate) noexcept
{
  if (!gate.IsOpen())
  {
    this->Growth.Reset();
    this->Augmented = this->Touched = {};
    gate.Cut();
    return {};
  }
  if (input.Elapsed > limits.WatchdogTime)
  {
    // The loop itself has paused, and the device may have ended the force by itself.
    this->Growth.Lower({});
    this->Augmented = this->Touched = {};
  }
  if (gap)
  {
    gate.ReportGap(this->Stale, this->IsForceLeft());
  }
  if (gate.IsRetreating())
  {
    return this->Retreat(input, limits, gate);
  }
  GrowthInput growth = this->ComputeGrowth(input, limits);
  growth.Share = gate.Pass(limits.RampTime > 0.0 ? input.Period / limits.RampTime : 1.0);
  growth.Growth = limits.MaximumForceRate * input.Period;
  // After a gain was switched off, the force may still have to grow to the wall's force.
  const bool isBehind = !IsIdentical(this->Touched, this->Growth.GetForce());
  const Vector3 wall = this->Growth.Apply(growth);
  this->Augmented = this->Augment(wall, input, limits, growth.Share);
  this->Touched = this->Taps || this->Augments || isBehind
    ? this->AddTransient(this->Augmented, input, limits, growth.Share)
    : this->Augmented;
  return this->Damp(this->Touched, input, limits, gate);
}

Vector3 SafetyStage::AddTransient(
  const Vector3& wall, const SafetyInput& input, const SafetyLimits& limits, double share) noexcept
{
  const double most = ComputeMost(this->Touched, wall, input.Period, limits);
  if (!this->Taps)
  {
    return ClampNorm(wall, most);
  }
  TransientInput touch;
  touch.Wall = wall;
  touch.Frequency = input.Frequency;
  touch.Gain = limits.TransientGain;
  touch.Share = share;
  touch.Most = most;
  // If more of the force dropped at once, the slew limit would delay its return.
  touch.Least = std::max(0.0, most - 2.0 * limits.MaximumForceRate * input.Period);
  touch.Period = input.Period;
  touch.MovesTip = limits.MovesTip;
  // The part of the force that the slew limit holds back after a pulse counts as a part of the
  // pulse.
  const Vector3 force = ClampNorm(this->Transient.Apply(touch), most);
  this->Pulse = force - wall;
  return force;
}

Vector3 SafetyStage::Augment(
  const Vector3& wall, const SafetyInput& input, const SafetyLimits& limits, double share) noexcept
{
  if (!this->Augments)
  {
    return wall;
  }
  AugmentationInput augmented;
  augmented.Wall = wall;
  augmented.Pull = std::max(Norm(input.Force), input.Stiffness * input.Stretch);
  augmented.Stiffness = std::max(input.Stiffness, input.Slope);
  augmented.Feedback = input.Feedback;
  augmented.Most = ComputeMost(this->Augmented, wall, input.Period, limits);
  augmented.MaximumDamping = ComputeDampingShare(input) * limits.MaximumDamping;
  // Don't damp twice, because both dampings together would exceed the limit of each.
  augmented.DampingShare = this->Damper.IsEngaged() ? 0.0 : share;
  augmented.Period = input.Period;
  return this->Augmentation.Apply(augmented);
}

Vector3 SafetyStage::Damp(const Vector3& wall, const SafetyInput& input, const SafetyLimits& limits,
  const ForceGate& gate) noexcept
{
  if (input.IsNew || gate.GetShare() != this->LastShare || gate.IsUnconfirmed())
  {
    this->Energy.Excuse();
  }
  this->LastShare = gate.GetShare();
  const double whole = Norm(input.Force);
  const double felt = whole > 0.0 ? std::min(1.0, Norm(wall) / whole) : 0.0;
  this->Energy.RecordSent(wall, felt * input.WallWork);
  const double before = Norm(this->LastCommand);
  const double most =
    std::min(limits.MaximumForce, before + limits.MaximumForceRate * input.Period);
  return this->Damper.Apply(
    wall, most, ComputeDampingShare(input) * limits.MaximumDamping, input.Period);
}

Vector3 SafetyStage::Apply(
  const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept
{
  const bool gap = this->UpdateSamples(input, limits, gate);
  this->Pulse = {};
  const Vector3 command = this->ComputeCommand(input, limits, gap, gate);
  this->LastCommand = command;
  gate.ReportCommand(Dot(command, command) > 0.0);
  this->Observer.RecordSent(command);
  if (this->Augments)
  {
    // The pulse has its own account, so leave it out.
    const Vector3 sent = command - this->Pulse;
    const double whole = Norm(input.Force);
    const double felt = whole > 0.0 ? std::min(1.0, Norm(sent) / whole) : 0.0;
    this->Augmentation.RecordSent(sent, input.Period, felt * input.WallWork);
  }
  if (this->Taps)
  {
    this->Transient.RecordSent(this->Pulse);
  }
  return command;
}

void SaturateTogether(double* commands, int count, double limit) noexcept
{
  double largest = 0.0;
  bool sound = limit >= 0.0;
  for (int i = 0; i < count; ++i)
  {
    largest = std::max(largest, std::abs(commands[i]));
    sound = sound && std::isfinite(commands[i]);
  }
  if (!sound)
  {
    std::fill(commands, commands + count, 0.0);
  }
  else if (largest > limit)
  {
    for (int i = 0; i < count; ++i)
    {
      commands[i] *= limit / largest;
    }
  }
}

} // namespace VolumeHaptics
