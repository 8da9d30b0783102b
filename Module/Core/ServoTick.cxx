// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ServoTick.h"

namespace VolumeHaptics
{
namespace
{

/** A gradient below this share of the value per voxel is rounding. */
constexpr double RelativeGradientEpsilon = 1e-12;
/** Distances (m) and forces (N) below these are zero. */
constexpr double DistanceEpsilon = 1e-15;
constexpr double ForceEpsilon = 1e-9;
/** No hand is farther away (m); squares of what is nearer do not overflow. */
constexpr double FarthestTip = 1e9;

/**
 * Ascending normal and gradient magnitude at a position, written into the record. Returns by how
 * much the border lets a surface be felt there: 0 where there is no gradient.
 */
double ReadGradient(const HapticModel& model, const Vector3& position, TickRecord& record) noexcept
{
  record.Normal = model.FallbackNormal;
  record.GradientMagnitude = 0.0;
  const Vector3 index = model.DeviceToIndex(position);
  if (!model.Field.IsInside(index))
  {
    return 0.0;
  }
  const FieldSample sample = model.Field.Gradient(index);
  const double floor = RelativeGradientEpsilon * sample.Value;
  const Vector3 gradient = model.GradientToDevice * sample.Gradient;
  const double magnitude = Norm(gradient);
  // False for NaN, too: no surface where a sample is not finite.
  if (!(Dot(sample.Gradient, sample.Gradient) > floor * floor && std::isfinite(magnitude)))
  {
    return 0.0;
  }
  record.Normal = (1.0 / magnitude) * gradient;
  record.GradientMagnitude = magnitude;
  return model.BorderFade(index);
}

/** Turns the normal into the structure, as the settings say where that is. */
void OrientNormal(const HapticModel& model, const Vector3& lag, TickRecord& record) noexcept
{
  const SurfaceSide side = model.Settings.Side;
  if (side == SurfaceSide::Lower || (side == SurfaceSide::Both && Dot(lag, record.Normal) < 0.0))
  {
    record.Normal = -record.Normal;
  }
}

/** Materials at x_s and x_v of a position, written into the record (eq. 13, section 3.3). */
void ReadMaterials(
  const HapticModel& model, const Vector3& position, double fade, TickRecord& record) noexcept
{
  const Vector3 reach = model.KernelLength * record.Normal;
  record.SurfaceValue = model.ValueAtDevice(position + reach);
  record.MediumValue = model.ValueAtDevice(position - reach);
  const MaterialTable::Values surface = model.Materials(record.SurfaceValue);
  const MaterialTable::Values medium = model.Materials(record.MediumValue);
  const DistinctnessTable::Values distinct = model.Distinctness(record.GradientMagnitude);
  const double cap = model.Settings.MaximumStiffness;
  record.Stiffness = cap > 0.0 ? std::min(surface[0], cap) : surface[0];
  record.Friction = surface[1];
  record.SurfaceStrength = surface[2] * (distinct[0] * fade) * (surface[4] * distinct[1]);
  record.Viscosity = medium[3] * (medium[4] * distinct[1]);
}

void ReadSurface(const HapticModel& model, const Vector3& position, const Vector3& tip,
  TickRecord& record) noexcept
{
  const double fade = ReadGradient(model, position, record);
  OrientNormal(model, tip - position, record);
  ReadMaterials(model, position, fade, record);
}

/** SPEC 2: normal move (eq. 12), tangential move (eqs. 8-10), drag (eq. 14), spring force. */
void StepPaper(const HapticModel& model, ServoState& state, TickRecord& record) noexcept
{
  const Vector3 start = state.Proxy;
  const Vector3 tip = record.Tip;
  ReadSurface(model, start, tip, record);
  const double k = record.Stiffness;
  if (!(k > HapticModel::MinimumStiffness))
  {
    record.Proxy = tip;
    return;
  }
  const Vector3 normal = record.Normal;
  Vector3 proxy = start;

  const double push = Dot(tip - proxy, normal);
  const double threshold = push > 0.0 ? record.SurfaceStrength : 0.0;
  if (threshold == 0.0 && record.Viscosity == 0.0)
  {
    // Nothing holds the proxy, and the moves below would bring it to the tip but for rounding.
    record.Proxy = tip;
    return;
  }
  const bool through = k * std::abs(push) > threshold;
  if (through)
  {
    proxy += (push - std::copysign(threshold / k, push)) * normal;
  }

  const Vector3 lag = tip - proxy;
  const double depth = Dot(lag, normal);
  record.NormalForce = k * std::abs(depth);
  const Vector3 tangent = lag - depth * normal;
  const double length = Norm(tangent);
  const double grip = record.Friction * record.NormalForce;
  const bool slides = length > DistanceEpsilon && k * length > grip;
  if (slides)
  {
    proxy += ((length - grip / k) / length) * tangent;
  }
  record.FrictionForce = slides ? grip : k * length;

  const Vector3 back = start - proxy;
  const double distance = Norm(back);
  const double drag = record.Viscosity / k;
  if (drag < distance)
  {
    proxy += (drag / distance) * back;
    record.DragForce = record.Viscosity;
  }
  else
  {
    proxy = start;
    record.DragForce = k * distance;
  }

  record.Proxy = proxy;
  record.Force = k * (proxy - tip);
  if (push > 0.0 && record.NormalForce > ForceEpsilon)
  {
    record.Contact = through ? ContactState::Penetrating
                             : (slides ? ContactState::Sliding : ContactState::Sticking);
  }
}

/** Eq. 1, at the tip; there is no proxy. */
void StepForceField(const HapticModel& model, ServoState& state, TickRecord& record) noexcept
{
  const double fade = ReadGradient(model, record.Tip, record);
  ReadMaterials(model, record.Tip, fade, record);
  record.Stiffness = record.Friction = record.Viscosity = record.SurfaceStrength = 0.0;
  record.Proxy = record.Tip;
  const Vector3 push = (-model.Settings.ForceFieldGain * record.GradientMagnitude) * record.Normal;
  const Vector3 velocity = (1.0 / model.Settings.TickPeriod) * (record.Tip - state.PreviousTip);
  const Vector3 drag = -model.Settings.ForceFieldDamping * velocity;
  record.NormalForce = Norm(push);
  record.DragForce = Norm(drag);
  record.Force = push + drag;
}

} // namespace

void Tick(
  const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record) noexcept
{
  record = TickRecord{};
  record.Tip = tip;
  // Also false for NaN.
  const bool isSomewhere =
    std::abs(tip.X) < FarthestTip && std::abs(tip.Y) < FarthestTip && std::abs(tip.Z) < FarthestTip;
  if (!isSomewhere)
  {
    record.Proxy = state.Proxy;
    state.Enabled = false;
    return;
  }
  if (!state.Enabled)
  {
    ReadSurface(model, tip, tip, record);
    record.Proxy = tip;
    state.Enabled = true;
  }
  else if (model.Settings.Method == HapticMethod::ForceField)
  {
    StepForceField(model, state, record);
  }
  else
  {
    StepPaper(model, state, record);
  }
  state.Proxy = record.Proxy;
  state.PreviousTip = tip;

  const double limit = model.Settings.MaximumForce;
  const double norm = Norm(record.Force);
  if (limit > 0.0 && norm > limit)
  {
    record.Force = (limit / norm) * record.Force;
  }
}

void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state) noexcept
{
  state.Proxy = to.WorldToDevice(from.DeviceToWorld(state.Proxy));
}

} // namespace VolumeHaptics
