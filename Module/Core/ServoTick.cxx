// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ServoTick.h"

namespace VolumeHaptics
{
namespace
{

/** A gradient below this share of the value per voxel is rounding. */
constexpr double RelativeGradientEpsilon = 1e-12;
constexpr double SmallestSquare = std::numeric_limits<double>::min();
/** Distances (m) and forces (N) below these are zero. */
constexpr double DistanceEpsilon = 1e-15;
constexpr double ForceEpsilon = 1e-9;
/** No hand is farther away (m); squares of what is nearer do not overflow. */
constexpr double FarthestTip = 1e9;

double Capped(double value, double cap) noexcept
{
  return cap > 0.0 ? std::min(value, cap) : value;
}

/** Where a surface lies through a position. */
struct Surface
{
  Vector3 Normal; ///< unit, into the structure
  Vector3 Reach;  ///< x_s - x_p, as index steps
  double GradientMagnitude = 0.0;
  double Fade = 0.0; ///< by how much the border lets it be felt; 0 without a gradient
};

/** What the tip asks for: how far along the normal, and the rest. */
struct SplitLag
{
  double Push;
  Vector3 Tangent;
  double Length; ///< of Tangent
};

/** The surface through an index, with an ascending normal. */
Surface FindSurface(const HapticModel& model, const Vector3& index) noexcept
{
  Surface surface;
  surface.Normal = model.FallbackNormal;
  surface.Reach = model.FallbackReach;
  if (!model.Field.IsInside(index))
  {
    return surface;
  }
  const FieldSample sample = model.Field.Gradient(index);
  const double floor = RelativeGradientEpsilon * sample.Value;
  const Vector3 gradient = model.GradientToDevice * sample.Gradient;
  const double square = Dot(gradient, gradient);
  // False for NaN, too: no surface where a sample is not finite.
  if (Dot(sample.Gradient, sample.Gradient) > floor * floor && square > SmallestSquare &&
    std::isfinite(square))
  {
    // Root and reciprocal do not wait for each other.
    const double magnitude = std::sqrt(square);
    const double inverse = (1.0 / square) * magnitude;
    surface.Normal = inverse * gradient;
    surface.Reach = inverse * (model.GradientToReach * sample.Gradient);
    surface.GradientMagnitude = magnitude;
    surface.Fade = model.BorderFade(index);
  }
  return surface;
}

/** Whether the structure lies against the gradient, as the settings say. */
bool IsDescending(const HapticModel& model, const Vector3& lag, const Vector3& normal) noexcept
{
  const SurfaceSide side = model.Settings.Side;
  return side == SurfaceSide::Lower || (side == SurfaceSide::Both && Dot(lag, normal) < 0.0);
}

SplitLag Split(const Vector3& lag, const Vector3& normal) noexcept
{
  const double push = Dot(lag, normal);
  const Vector3 tangent = lag - push * normal;
  return { push, tangent, Norm(tangent) };
}

/** Materials at x_s and x_v of an index, written into the record (eq. 13, section 3.3). */
void ReadMaterials(const HapticModel& model, const Vector3& index, const Surface& surface,
  TickRecord& record) noexcept
{
  // Before the values, whose sampling hides it.
  const DistinctnessTable::Values distinct = model.Distinctness(surface.GradientMagnitude);
  const ValuePair values = model.Field.Values(index, surface.Reach);
  const MaterialTable::Values inside = model.Materials(values.Ahead);
  const MaterialTable::Values outside = model.Materials(values.Behind);
  record.Normal = surface.Normal;
  record.GradientMagnitude = surface.GradientMagnitude;
  record.SurfaceValue = values.Ahead;
  record.MediumValue = values.Behind;
  record.Stiffness = Capped(inside[0], model.Settings.Caps.Stiffness);
  record.Friction = inside[1];
  record.SurfaceStrength = inside[2] * (distinct[0] * surface.Fade) * (inside[4] * distinct[1]);
  record.Viscosity = outside[3] * (outside[4] * distinct[1]);
}

/**
 * SPEC 2: normal move (eq. 12), tangential move (eqs. 8-10), drag (eq. 14), spring force.
 *
 * Written with forces: each move is the part of the spring's force that nothing holds, over k. The
 * normal and the tangential move are perpendicular, so that the lag is split only once.
 */
Vector3 StepPaper(const Vector3& start, const SplitLag& lag, TickRecord& record) noexcept
{
  const double k = record.Stiffness;
  if (!(k > HapticModel::MinimumStiffness))
  {
    return record.Tip;
  }
  const double threshold = lag.Push > 0.0 ? record.SurfaceStrength : 0.0;
  if (threshold == 0.0 && record.Viscosity == 0.0)
  {
    // Nothing holds the proxy, and the moves below would bring it to the tip but for rounding.
    return record.Tip;
  }
  const double pushForce = k * std::abs(lag.Push);
  const bool through = pushForce > threshold;
  const double normalForce = through ? threshold : pushForce;
  const double normalExcess = pushForce - normalForce;

  const double pullForce = k * lag.Length;
  const double grip = record.Friction * normalForce;
  const bool slides = lag.Length > DistanceEpsilon && pullForce > grip;
  const double frictionForce = slides ? grip : pullForce;
  const double tangentExcess = pullForce - frictionForce;

  const double square = normalExcess * normalExcess + tangentExcess * tangentExcess;
  const double excess = std::sqrt(square);
  const double drag = record.Viscosity;
  Vector3 proxy = start;
  if (drag < excess)
  {
    const double share = 1.0 - drag / square * excess;
    proxy += (share * (std::copysign(normalExcess, lag.Push) / k)) * record.Normal;
    if (slides)
    {
      proxy += (share * (tangentExcess / pullForce)) * lag.Tangent;
    }
  }
  record.NormalForce = normalForce;
  record.FrictionForce = frictionForce;
  record.DragForce = std::min(drag, excess);
  record.Force = k * (proxy - record.Tip);
  if (lag.Push > 0.0 && normalForce > ForceEpsilon)
  {
    record.Contact = through ? ContactState::Penetrating
                             : (slides ? ContactState::Sliding : ContactState::Sticking);
  }
  return proxy;
}

/** Eq. 1, at the tip; there is no proxy. */
void StepForceField(
  const HapticModel& model, const Vector3& previousTip, TickRecord& record) noexcept
{
  record.Stiffness = record.Friction = record.Viscosity = record.SurfaceStrength = 0.0;
  const Vector3 push = (-model.Settings.ForceFieldGain * record.GradientMagnitude) * record.Normal;
  const Vector3 velocity = (1.0 / model.Settings.TickPeriod) * (record.Tip - previousTip);
  const double damping = Capped(model.Settings.ForceFieldDamping, model.Settings.Caps.Damping);
  const Vector3 drag = -damping * velocity;
  record.NormalForce = Norm(push);
  record.DragForce = Norm(drag);
  record.Force = push + drag;
}

} // namespace

void Tick(
  const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record) noexcept
{
  // Also false for NaN.
  const bool isSomewhere =
    std::abs(tip.X) < FarthestTip && std::abs(tip.Y) < FarthestTip && std::abs(tip.Z) < FarthestTip;
  if (!isSomewhere)
  {
    record = TickRecord{};
    record.Tip = tip;
    record.Proxy = state.Proxy;
    state.Enabled = false;
    return;
  }
  // What the methods below do not always write.
  record.Tip = tip;
  record.Force = Vector3{};
  record.NormalForce = record.FrictionForce = record.DragForce = 0.0;
  record.Contact = ContactState::Free;

  const bool isField = model.Settings.Method == HapticMethod::ForceField;
  const Vector3 position = state.Enabled && !isField ? state.Proxy : tip;
  const Vector3 lag = tip - position;
  const Vector3 index = model.DeviceToIndex(position);
  Surface surface = FindSurface(model, index);
  if (!isField && IsDescending(model, lag, surface.Normal))
  {
    surface.Normal = -surface.Normal;
    surface.Reach = -surface.Reach;
  }
  // Before the materials, so that the processor has it by the time they are there.
  const SplitLag split = Split(lag, surface.Normal);
  ReadMaterials(model, index, surface, record);
  Vector3 proxy = tip;
  if (state.Enabled && isField)
  {
    StepForceField(model, state.PreviousTip, record);
  }
  else if (state.Enabled)
  {
    proxy = StepPaper(position, split, record);
  }
  record.Proxy = proxy;
  state.Proxy = proxy;
  state.PreviousTip = tip;
  state.Enabled = true;

  const double limit = model.Settings.MaximumForce;
  if (limit > 0.0)
  {
    const double norm = Norm(record.Force);
    record.Force = norm > limit ? (limit / norm) * record.Force : record.Force;
  }
}

void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state) noexcept
{
  state.Proxy = to.WorldToDevice(from.DeviceToWorld(state.Proxy));
}

} // namespace VolumeHaptics
