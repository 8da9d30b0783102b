// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/VirtualTip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace VolumeHaptics
{
namespace
{

/**
 * Smallest norm: the squares of smaller numbers, and of their reciprocals, are not exact or not
 * finite.
 */
constexpr double LeastNorm = 1e-100;

/** Normalises a quaternion. False, and unchanged, if it has no usable norm. */
bool Normalize(Quaternion& q)
{
  const double norm = std::sqrt(SquaredNorm(q));
  const bool isGood = norm > LeastNorm && norm < 1.0 / LeastNorm;
  q = isGood ? (1.0 / norm) * q : q;
  return isGood;
}

} // namespace

std::string VirtualTip::Check(const Vector3& world) const
{
  return !this->Session.GetVirtual()
    ? "There is no virtual device to lead: Open(\"virtual\") first."
    : !IsFinite(world) ? "The virtual tip must be finite; it stays where it was."
                       : "";
}

std::string VirtualTip::Lead(const Vector3& world, const Affine3& deviceToWorld)
{
  std::string error = this->Check(world);
  if (error.empty())
  {
    this->Session.GetVirtual()->Lead(Inverse(deviceToWorld)(world));
  }
  return error;
}

std::string VirtualTip::Place(const Vector3& world, const Affine3& deviceToWorld)
{
  std::string error = this->Check(world);
  if (error.empty())
  {
    this->Session.GetVirtual()->Place(Inverse(deviceToWorld)(world));
  }
  return error;
}

std::string VirtualTip::TurnHand(Quaternion world, const Affine3& deviceToWorld)
{
  if (IsIdentical(world, NoOrientation))
  {
    this->Session.TurnHand(std::nullopt);
    return "";
  }
  if (!Normalize(world))
  {
    return "The tip's orientation must be a quaternion of finite numbers that are not all tiny; it "
           "stays as it was. Four zeros take it away.";
  }
  this->Session.TurnHand(Conjugate(ToQuaternion(RotationOf(deviceToWorld))) * world);
  return "";
}

std::string VirtualTip::Turn(Quaternion world, const Affine3& deviceToWorld)
{
  VirtualDevice* const device = this->Session.GetVirtual();
  if (!device)
  {
    return "There is no virtual device to turn: Open(\"virtual\") first.";
  }
  if (IsIdentical(world, NoOrientation))
  {
    device->ForgetTurn();
    return "";
  }
  if (!Normalize(world))
  {
    return "The virtual tip's orientation must be a quaternion of finite numbers that are not all "
           "tiny; it stays as it was. Four zeros take it away.";
  }
  device->Turn(Conjugate(ToQuaternion(RotationOf(deviceToWorld))) * world);
  return "";
}

void VirtualTip::SetButtons(int buttons)
{
  if (VirtualDevice* device = this->Session.GetVirtual())
  {
    device->SetButtons(static_cast<std::uint32_t>(buttons));
  }
}

std::string VirtualTip::SetDynamics(
  double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay)
{
  VirtualDevice* const device = this->Session.GetVirtual();
  if (!device || this->Session.IsRunning())
  {
    return "Dynamics are set between Open(\"virtual\") and Start().";
  }
  VirtualDynamics dynamics;
  dynamics.Mass = std::max(0.0, mass);
  dynamics.Damping = std::max(0.0, damping);
  dynamics.HandStiffness = std::max(0.0, handStiffness);
  dynamics.EncoderQuantum = std::max(0.0, encoderQuantum);
  dynamics.ForceDelay = std::clamp(forceDelay, 0, VirtualDynamics::MaximumDelay);
  device->SetDynamics(dynamics);
  return "";
}

std::string VirtualTip::SetLimits(
  double maximumForce, double maximumStiffness, double maximumDamping, double friction)
{
  VirtualDevice* const device = this->Session.GetVirtual();
  const double sum = maximumForce + maximumStiffness + maximumDamping + friction;
  if (!device || this->Session.IsRunning() || !std::isfinite(sum) || !(maximumForce > 0.0))
  {
    return "Limits are finite, with a force above 0, and are set between Open(\"virtual\") and "
           "Start().";
  }
  DeviceLimits limits = device->GetLimits();
  limits.MaximumForce = maximumForce;
  limits.MaximumStiffness = std::max(0.0, maximumStiffness);
  limits.MaximumDamping = std::max(0.0, maximumDamping);
  limits.Damping = std::max(0.0, friction);
  device->SetLimits(limits);
  return "";
}

} // namespace VolumeHaptics
