// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/TorqueStage.h"

#include "Core/Safety/SafetyStage.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

void TorqueStage::UpdateTurn(const Quaternion& orientation) noexcept
{
  const Quaternion turn = orientation * Conjugate(this->Last);
  const Vector3 axis = std::copysign(1.0, turn.W) * Vector3{ turn.X, turn.Y, turn.Z };
  const double sine = Norm(axis); // sine of half the angle
  constexpr double small = 1e-6;
  const double length = sine > small ? 2.0 * std::asin(std::min(sine, 1.0)) / sine : 2.0;
  this->Turned += length * axis;
  this->Last = orientation;
}

Vector3 TorqueStage::Apply(
  const TorqueInput& input, const SafetyLimits& limits, const ForceGate& gate) noexcept
{
  this->UpdateTurn(input.Orientation);
  const Vector3 wanted = ClampNorm(input.Torque, limits.MaximumTorque);
  if (!gate.IsOpen() || gate.IsRetreating() || gate.IsUnconfirmed() || !IsFinite(wanted) ||
    !(limits.MaximumTorque > 0.0))
  {
    this->Growth.Reset();
    return {};
  }
  const double most = Norm(wanted);
  const double k = input.Stiffness;
  GrowthInput growth;
  growth.Wanted = wanted;
  growth.Tip = this->Turned;
  growth.IsMeasured = input.IsMeasured;
  growth.Share = gate.GetShare();
  growth.Growth = limits.MaximumTorqueRate * input.Period;
  // The energy that a spring with the computed torque can give back, if at most `most` of the
  // torque is felt.
  growth.Recoverable = k > 0.0 ? 0.5 * most * (2.0 * Norm(input.Torque) - most) / k : -1.0;
  return this->Growth.Apply(growth);
}

} // namespace VolumeHaptics
