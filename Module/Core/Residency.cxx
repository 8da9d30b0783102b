// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Residency.h"

#include "ServoTick.h"

namespace VolumeHaptics
{
namespace
{

/** The diagonal of a cube. */
constexpr double Diagonal = 1.7320508075688772;

Vector3 Least(const Vector3& a, const Vector3& b) noexcept
{
  return { std::fmin(a.X, b.X), std::fmin(a.Y, b.Y), std::fmin(a.Z, b.Z) };
}

Vector3 Most(const Vector3& a, const Vector3& b) noexcept
{
  return { std::fmax(a.X, b.X), std::fmax(a.Y, b.Y), std::fmax(a.Z, b.Z) };
}

/**
 * How many index steps a way of length 1, in the space that a matrix begins in, is along each axis
 * at most.
 */
Vector3 StepsPerLength(const Matrix3& toIndex) noexcept
{
  return { Norm(toIndex.Row[0]), Norm(toIndex.Row[1]), Norm(toIndex.Row[2]) };
}

/** How far (world units) a local surface is looked for around a place, without what is ahead. */
double LocalDistance(const HapticModel& model) noexcept
{
  return Diagonal * LocalReach * LargestColumn(model.IndexToWorld.Linear);
}

} // namespace

ResidentBox::ResidentBox(const VolumeView& view) noexcept
{
  double low[3];
  double high[3];
  for (int a = 0; a < 3; ++a)
  {
    const bool isFirst = view.First[a] <= 0;
    const bool isLast = view.Last(a) >= view.Border(a);
    low[a] = isFirst ? -HUGE_VAL : static_cast<double>(view.First[a]);
    high[a] = isLast ? HUGE_VAL : static_cast<double>(view.Last(a));
    this->Whole = this->Whole && isFirst && isLast;
  }
  this->Low = { low[0], low[1], low[2] };
  this->High = { high[0], high[1], high[2] };
}

double ResidentBox::Find(
  const Vector3& low, const Vector3& high, const Vector3& margin) const noexcept
{
  const Vector3 before = low - margin - this->Low;
  const Vector3 behind = this->High - (high + margin);
  const Vector3 nearest = Least(before, behind);
  const double clearance = std::fmin(std::fmin(nearest.X, nearest.Y), nearest.Z);
  const double t = std::fmin(std::fmax(clearance / ResidencyBand, 0.0), 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Vector3 FindReadReach(const HapticModel& model) noexcept
{
  const HapticSettings& settings = model.Settings;
  const Vector3 perMeter = StepsPerLength(model.DeviceToIndex.Linear);
  const Vector3 perUnit = (1.0 / model.WorldUnitsPerMeter) * perMeter;
  const double radius = model.Kernel.Radius;
  const Vector3 spare{ ResidencySpare, ResidencySpare, ResidencySpare };
  const Vector3 kernel = Vector3{ radius, radius, radius } + spare;
  if (settings.Method == HapticMethod::SurfaceProxy)
  {
    return settings.ProxyRadius * perUnit + spare;
  }
  if (settings.Method == HapticMethod::LocalSurface)
  {
    const double bend = radius * LargestColumn(model.IndexToWorld.Linear);
    return (LocalDistance(model) + bend) * perUnit + kernel;
  }
  return Most(model.KernelLength * perMeter + spare, kernel);
}

double FindResidency(const HapticModel& model, const ServoState& state, const Vector3& tip) noexcept
{
  const HapticSettings& settings = model.Settings;
  const bool readsMesh = settings.Method == HapticMethod::SurfaceProxy && !settings.HasIsoSurface;
  // A tip that is nowhere is the tick's to judge.
  if (model.Resident.IsWhole() || readsMesh || !IsFinite(tip))
  {
    return 1.0;
  }
  const Vector3 at = model.DeviceToIndex(tip);
  Vector3 low = at;
  Vector3 high = at;
  Vector3 margin = model.ReadReach;
  const auto include = [&](const Vector3& index)
  {
    low = Least(low, index);
    high = Most(high, index);
  };
  if (state.Enabled && settings.Method != HapticMethod::ForceField)
  {
    include(model.DeviceToIndex(state.Proxy));
    include(model.DeviceToIndex(state.PreviousTip));
    if (settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Precise)
    {
      include(model.DeviceToIndex(state.Precise.ReachedTip));
    }
    if (settings.Method == HapticMethod::LocalSurface)
    {
      const LocalQuestion& asked = state.Local.Asked;
      include(model.DeviceToIndex(model.WorldToDevice(asked.Where)));
      const Vector3 perMeter = StepsPerLength(model.DeviceToIndex.Linear);
      // The nearest place of a surface that is met ahead may lie on any side.
      const double most = LocalReachAhead * LargestColumn(model.IndexToWorld.Linear);
      const double ahead = std::fmin(Norm(asked.Ahead), most) - LocalDistance(model);
      margin += (std::fmax(ahead, 0.0) / model.WorldUnitsPerMeter) * perMeter;
    }
  }
  return model.Resident.Find(low, high, margin);
}

void ResidentServo::Follow(double target, double period) noexcept
{
  const double step = period / FadeTime;
  const double wanted = this->FadesOut || this->Held ? 0.0 : target;
  // Not std::clamp: what is within a step is reached to the bit.
  const double way = wanted - this->Share;
  this->Share = std::fabs(way) <= step ? wanted : this->Share + std::copysign(step, way);
}

void ResidentServo::Rest(double period) noexcept
{
  this->IsOut = false;
  this->Awaits = false;
  this->Follow(1.0, period);
}

void ResidentServo::Tick(const HapticModel& model, ServoState& state, const Vector3& tip,
  double period, TickRecord& record, const LocalAnswer& answer) noexcept
{
  const double there = model.Resident.IsWhole() ? 1.0 : FindResidency(model, state, tip);
  if (!(there > 0.0) && !this->IsOut)
  {
    this->IsOut = true;
    const bool isFelt = state.Enabled && this->Share > 0.0;
    this->Force = isFelt ? record.Force : Vector3{};
    this->Lag = isFelt ? record.Proxy - record.Tip : Vector3{};
  }
  this->Follow(this->IsOut ? 0.0 : there, period);
  this->Awaits = !model.Resident.IsWhole() &&
    (this->IsOut || (this->Share < 1.0 && !this->FadesOut && !this->Held));
  if (!this->IsOut)
  {
    VolumeHaptics::Tick(model, state, tip, record, answer);
    return;
  }
  if (this->Share == 0.0 || !state.Enabled)
  {
    // Whoever disabled the state wants to begin from the tip, without force.
    this->Force = this->Lag = Vector3{};
    record = TickRecord{};
  }
  record.Tip = tip;
  record.Proxy = tip + this->Lag;
  record.Force = this->Force;
  record.IsRenewed = record.IsUnfinished = false;
  state.Proxy = state.PreviousTip = tip;
  state.Precise = PreciseState{};
  state.Precise.ReachedTip = tip;
  state.Enabled = this->Share > 0.0;
  this->IsOut = this->Share > 0.0;
}

} // namespace VolumeHaptics
