// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkHapticDevice that leads the virtual device.
#include "vtkHapticDeviceInternals.h"

#include <algorithm>
#include <cmath>

using namespace VolumeHaptics;

namespace
{
/** The virtual device and where it is to go (m); nullptr, with an error, where it can't. */
VirtualDevice* FindVirtual(vtkHapticDevice* self, VirtualDevice* device, const Vector3& world)
{
  if (!device || !IsFinite(world))
  {
    vtkErrorWithObjectMacro(
      self, << (device ? "The virtual tip must be finite; it stays where it was."
                       : "There is no virtual device to lead: Open(\"virtual\") first."));
    return nullptr;
  }
  return device;
}
} // namespace

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualTip(double x, double y, double z)
{
  const Vector3 world{ x, y, z };
  if (auto* device = FindVirtual(this, this->Internals->Holder.GetVirtual(), world))
  {
    device->Lead(Inverse(this->Internals->GetPlacement())(world));
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::PlaceVirtualTip(double x, double y, double z)
{
  const Vector3 world{ x, y, z };
  if (auto* device = FindVirtual(this, this->Internals->Holder.GetVirtual(), world))
  {
    device->Place(Inverse(this->Internals->GetPlacement())(world));
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualTip(const double x[3])
{
  if (!x)
  {
    vtkErrorMacro(
      "SetVirtualTip() needs three numbers, but got a null pointer; the tip stays where it is.");
    return;
  }
  this->SetVirtualTip(x[0], x[1], x[2]);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualButtons(int buttons)
{
  if (VirtualDevice* device = this->Internals->Holder.GetVirtual())
  {
    device->SetButtons(static_cast<std::uint32_t>(buttons));
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualDynamics(
  double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay)
{
  VirtualDevice* const device = this->Internals->Holder.GetVirtual();
  if (!device || this->IsRunning())
  {
    vtkErrorMacro("Dynamics are set between Open(\"virtual\") and Start().");
    return;
  }
  VirtualDynamics dynamics;
  dynamics.Mass = std::max(0.0, mass);
  dynamics.Damping = std::max(0.0, damping);
  dynamics.HandStiffness = std::max(0.0, handStiffness);
  dynamics.EncoderQuantum = std::max(0.0, encoderQuantum);
  dynamics.ForceDelay = std::clamp(forceDelay, 0, VirtualDynamics::MaximumDelay);
  device->SetDynamics(dynamics);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualLimits(
  double maximumForce, double maximumStiffness, double maximumDamping, double friction)
{
  VirtualDevice* const device = this->Internals->Holder.GetVirtual();
  const double sum = maximumForce + maximumStiffness + maximumDamping + friction;
  if (!device || this->IsRunning() || !std::isfinite(sum) || !(maximumForce > 0.0))
  {
    vtkErrorMacro("Limits are finite, with a force above 0, and are set between Open(\"virtual\") "
                  "and Start().");
    return;
  }
  DeviceLimits limits = device->GetLimits();
  limits.MaximumForce = maximumForce;
  limits.MaximumStiffness = std::max(0.0, maximumStiffness);
  limits.MaximumDamping = std::max(0.0, maximumDamping);
  limits.Damping = std::max(0.0, friction);
  device->SetLimits(limits);
  this->TakeLimits();
}
