// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Virtual/VirtualDevice.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

bool VirtualDevice::Open(std::string&)
{
  this->Unplugged.store(false);
  this->Frozen.store(false);
  this->Velocity = {};
  this->Queue = {};
  this->Time = ServoClock::Now();
  return true;
}

void VirtualDevice::Close()
{
  this->Write({});
}

DeviceLimits VirtualDevice::StrongDesktopDevice()
{
  // Leave stiffness and damping unlimited, so that all values can be simulated.
  DeviceLimits limits;
  limits.MaximumForce = 20.0;
  limits.MaximumTorque = 0.5;
  limits.MaximumSpeed = 2.5;
  limits.WorkspaceRadius = 0.2;
  return limits;
}

void VirtualDevice::Lead(const Vector3& target) noexcept
{
  this->Wanted.Target = target;
  this->Wanted.Places = std::max<std::uint64_t>(this->Wanted.Places, 1);
  this->Orders.Write(this->Wanted);
}

void VirtualDevice::Place(const Vector3& position) noexcept
{
  this->Wanted.Target = position;
  ++this->Wanted.Places;
  this->Orders.Write(this->Wanted);
}

void VirtualDevice::Turn(const Quaternion& orientation) noexcept
{
  this->Wanted.Orientation = orientation;
  this->Wanted.HasOrientation = true;
  this->Orders.Write(this->Wanted);
}

void VirtualDevice::ForgetTurn() noexcept
{
  this->Wanted.HasOrientation = false;
  this->Orders.Write(this->Wanted);
}

void VirtualDevice::Update(double period) noexcept
{
  const Vector3 way = this->Target - this->Position;
  const double distance = Norm(way);
  const double most = this->Dynamics.HandSpeed * period;
  // Stop the tip exactly at the target if it is within reach.
  this->Position = distance <= most ? this->Target : this->Position + (most / distance) * way;
}

void VirtualDevice::Integrate(double period, const Vector3& force) noexcept
{
  // Integrate with the fourth-order Runge-Kutta method. The acceleration is smooth, because the
  // force is constant during the period.
  constexpr int steps = 8;
  const double h = period / steps;
  const double m = this->Dynamics.Mass;
  const Vector3 target = this->Target;
  const auto acceleration = [&](const Vector3& x, const Vector3& v)
  {
    return (1.0 / m) *
      (force + this->Dynamics.HandStiffness * (target - x) - this->Dynamics.Damping * v);
  };
  for (int i = 0; i < steps; ++i)
  {
    const Vector3 x = this->Position;
    const Vector3 v = this->Velocity;
    const Vector3 a1 = acceleration(x, v);
    const Vector3 v2 = v + 0.5 * h * a1;
    const Vector3 a2 = acceleration(x + 0.5 * h * v, v2);
    const Vector3 v3 = v + 0.5 * h * a2;
    const Vector3 a3 = acceleration(x + 0.5 * h * v2, v3);
    const Vector3 v4 = v + h * a3;
    const Vector3 a4 = acceleration(x + h * v3, v4);
    this->Position += (h / 6.0) * (v + 2.0 * v2 + 2.0 * v3 + v4);
    this->Velocity += (h / 6.0) * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
}

DeviceState VirtualDevice::Read(double period, DeviceSample& sample) noexcept
{
  this->Period = std::llround(period * ServoClock::NanosecondsPerSecond);
  this->Time += this->Period;
  sample.Taken = this->Taken;
  if (this->Orders.Update())
  {
    this->Target = this->Orders.Read().Target;
  }
  sample.Begins = this->Orders.Read().Places != this->PlacesDone;
  if (sample.Begins)
  {
    this->PlacesDone = this->Orders.Read().Places;
    this->Position = this->Target;
    this->Velocity = {};
  }
  else if (this->Dynamics.Mass > 0.0)
  {
    const bool quenched = this->Quenched.load(std::memory_order_acquire);
    this->Integrate(period, quenched ? Vector3{} : this->Queue[this->QueueHead]);
  }
  else
  {
    this->Update(period);
  }
  if (this->Unplugged.load())
  {
    return DeviceState::Lost;
  }
  if (this->Frozen.load() || this->PlacesDone == 0)
  {
    return DeviceState::Running;
  }
  const double q = this->Dynamics.EncoderQuantum;
  const auto measure = [q](double x) { return q > 0.0 ? q * std::round(x / q) : x; };
  sample.Tip = { measure(this->Position.X), measure(this->Position.Y), measure(this->Position.Z) };
  sample.Orientation = this->Orders.Read().Orientation;
  sample.HasOrientation = this->Orders.Read().HasOrientation;
  sample.Buttons = this->Buttons.load(std::memory_order_relaxed);
  sample.Fresh = true;
  sample.Time = this->Time;
  return DeviceState::Running;
}

DeviceState VirtualDevice::Write(const Vector3& force) noexcept
{
  // Apply the oldest of ForceDelay + 1 forces. Without a delay, this is the current force.
  const int length = std::clamp(this->Dynamics.ForceDelay, 0, VirtualDynamics::MaximumDelay) + 1;
  this->Queue[this->QueueHead % length] = force;
  this->QueueHead = (this->QueueHead + 1) % length;
  const Vector3& acting = this->Queue[this->QueueHead];
  this->Taken = { this->Time - (length - 1) * this->Period, this->Time };
  this->Acting[0].store(acting.X, std::memory_order_relaxed);
  this->Acting[1].store(acting.Y, std::memory_order_relaxed);
  this->Acting[2].store(acting.Z, std::memory_order_relaxed);
  this->Quenched.store(false, std::memory_order_release);
  return this->Unplugged.load() ? DeviceState::Lost : DeviceState::Running;
}

} // namespace VolumeHaptics
