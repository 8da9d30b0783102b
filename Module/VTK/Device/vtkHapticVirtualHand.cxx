// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticVirtualHand.h"

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"
#include "Devices/Virtual/VirtualDevice.h"
#include "VTK/Device/DeviceParts.h"

#include "vtkHapticDevice.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

vtkStandardNewMacro(vtkHapticVirtualHand);

using namespace VolumeHaptics;

namespace
{
/**
 * Smallest usable norm: below it, the square of the norm or of its reciprocal is not finite or not
 * exact.
 */
constexpr double LeastNorm = 1e-100;

/** Normalises a quaternion. If it has no usable norm, leaves it unchanged and returns false. */
bool Normalize(Quaternion& q)
{
  const double norm = std::sqrt(SquaredNorm(q));
  const bool isGood = norm > LeastNorm && norm < 1.0 / LeastNorm;
  q = isGood ? (1.0 / norm) * q : q;
  return isGood;
}

/** Rotates an orientation from the world to the device's space. */
Quaternion ToDevice(const DeviceParts& parts, const Quaternion& world)
{
  return Conjugate(ToQuaternion(RotationOf(parts.Models.GetPlacement()))) * world;
}
} // namespace

//------------------------------------------------------------------------------
DeviceParts* vtkHapticVirtualHand::GetParts()
{
  if (!this->Parts)
  {
    vtkErrorMacro(
      "This hand has no device: take it from vtkHapticDevice::GetVirtualHand(), and keep "
      "the device as long as it is used.");
  }
  return this->Parts;
}

//------------------------------------------------------------------------------
VirtualDevice* vtkHapticVirtualHand::FindLed(double x, double y, double z)
{
  DeviceParts* const parts = this->GetParts();
  VirtualDevice* const device = parts ? parts->Session.GetVirtual() : nullptr;
  if (parts && !device)
  {
    parts->Orders.ReportError("There is no virtual device to lead: Open(\"virtual\") first.");
  }
  else if (device && !IsFinite(Vector3{ x, y, z }))
  {
    parts->Orders.ReportError("The virtual tip must be finite; it stays where it was.");
    return nullptr;
  }
  return device;
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetPosition(double x, double y, double z)
{
  if (VirtualDevice* const device = this->FindLed(x, y, z))
  {
    device->Lead(Inverse(this->Parts->Models.GetPlacement())({ x, y, z }));
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetPosition(const double x[3])
{
  DeviceParts* const parts = this->GetParts();
  if (parts && !x)
  {
    parts->Orders.ReportError(
      "SetPosition() needs three numbers, but got a null pointer; the tip stays where it is.");
  }
  else if (parts)
  {
    this->SetPosition(x[0], x[1], x[2]);
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::Place(double x, double y, double z)
{
  if (VirtualDevice* const device = this->FindLed(x, y, z))
  {
    device->Place(Inverse(this->Parts->Models.GetPlacement())({ x, y, z }));
  }
}

//------------------------------------------------------------------------------
bool vtkHapticVirtualHand::MayMouseLead()
{
  return this->Parts && this->Parts->Session.MayMouseLead();
}

//------------------------------------------------------------------------------
double vtkHapticVirtualHand::GetSpeed()
{
  return VirtualDynamics().HandSpeed;
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetButtons(int buttons)
{
  DeviceParts* const parts = this->GetParts();
  if (VirtualDevice* const device = parts ? parts->Session.GetVirtual() : nullptr)
  {
    device->SetButtons(static_cast<std::uint32_t>(buttons));
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetOrientation(double w, double x, double y, double z)
{
  DeviceParts* const parts = this->GetParts();
  VirtualDevice* const device = parts ? parts->Session.GetVirtual() : nullptr;
  Quaternion world{ w, x, y, z };
  if (parts && !device)
  {
    parts->Orders.ReportError("There is no virtual device to turn: Open(\"virtual\") first.");
  }
  else if (device && IsIdentical(world, NoOrientation))
  {
    device->ForgetTurn();
  }
  else if (device && !Normalize(world))
  {
    parts->Orders.ReportError(
      "The virtual tip's orientation must be a quaternion of finite numbers "
      "that are not all tiny; it stays as it was. Four zeros remove it.");
  }
  else if (device)
  {
    device->Turn(ToDevice(*parts, world));
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetOrientation(const double wxyz[4])
{
  DeviceParts* const parts = this->GetParts();
  if (parts && !wxyz)
  {
    parts->Orders.ReportError(
      "SetOrientation() needs four numbers, but got a null pointer; the stylus stays as it is.");
  }
  else if (parts)
  {
    this->SetOrientation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetToolOrientation(double w, double x, double y, double z)
{
  DeviceParts* const parts = this->GetParts();
  Quaternion world{ w, x, y, z };
  if (parts && IsIdentical(world, NoOrientation))
  {
    parts->Session.TurnHand(std::nullopt);
  }
  else if (parts && !Normalize(world))
  {
    parts->Orders.ReportError(
      "The tip's orientation must be a quaternion of finite numbers that are "
      "not all tiny; it stays as it was. Four zeros remove it.");
  }
  else if (parts)
  {
    parts->Session.TurnHand(ToDevice(*parts, world));
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetSpinning(bool spinning)
{
  if (DeviceParts* const parts = this->GetParts())
  {
    parts->Session.Spin(spinning);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticVirtualHand::GetSpinning()
{
  return this->Parts && this->Parts->Session.IsSpinOrdered();
}

//------------------------------------------------------------------------------
double vtkHapticVirtualHand::TakeVibration()
{
  return this->Parts ? this->Parts->Session.TakeVibration() : 0.0;
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetDynamics(
  double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay)
{
  DeviceParts* const parts = this->GetParts();
  VirtualDevice* const device = parts ? parts->Session.GetVirtual() : nullptr;
  if (parts && (!device || parts->Session.IsRunning()))
  {
    parts->Orders.ReportError("Dynamics are set between Open(\"virtual\") and Start().");
  }
  else if (device)
  {
    VirtualDynamics dynamics;
    dynamics.Mass = std::max(0.0, mass);
    dynamics.Damping = std::max(0.0, damping);
    dynamics.HandStiffness = std::max(0.0, handStiffness);
    dynamics.EncoderQuantum = std::max(0.0, encoderQuantum);
    dynamics.ForceDelay = std::clamp(forceDelay, 0, VirtualDynamics::MaximumDelay);
    device->SetDynamics(dynamics);
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::SetLimits(
  double maximumForce, double maximumStiffness, double maximumDamping, double friction)
{
  DeviceParts* const parts = this->GetParts();
  VirtualDevice* const device = parts ? parts->Session.GetVirtual() : nullptr;
  const double sum = maximumForce + maximumStiffness + maximumDamping + friction;
  if (parts &&
    (!device || parts->Session.IsRunning() || !std::isfinite(sum) || !(maximumForce > 0.0)))
  {
    parts->Orders.ReportError("Limits must be finite, with a force above 0, and be set between "
                              "Open(\"virtual\") and Start().");
  }
  else if (device)
  {
    DeviceLimits limits = device->GetLimits();
    limits.MaximumForce = maximumForce;
    limits.MaximumStiffness = std::max(0.0, maximumStiffness);
    limits.MaximumDamping = std::max(0.0, maximumDamping);
    limits.Damping = std::max(0.0, friction);
    device->SetLimits(limits);
    parts->Device->UpdateLimits();
  }
}

//------------------------------------------------------------------------------
void vtkHapticVirtualHand::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spinning: " << (this->GetSpinning() ? "On" : "Off") << "\n";
}
