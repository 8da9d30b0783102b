// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vendor/VendorDriver.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr int VendorRoundPause = 1; // ms, the longest between two rounds
constexpr int VendorLostPause = 10; // ms
constexpr double Farthest = 10.;    // m: a farther position is invalid
constexpr std::uint32_t AllAxes = 7;

bool IsLimit(double limit)
{
  return std::isfinite(limit) && limit >= 0.0;
}

} // namespace

VendorDriver::VendorDriver(std::string plugin, int number, std::string path)
  : Plugin(std::move(plugin))
  , Number(number)
  , Path(std::move(path))
  , Label("vendor:" + this->Plugin + ":" + std::to_string(number))
{
}

VendorDriver::~VendorDriver()
{
  this->Disconnect();
}

bool VendorDriver::Connect(std::string& error)
{
  this->Library = VendorLibrary::Load(this->Plugin, this->Path, error);
  if (!this->Library)
  {
    return false;
  }
  std::string reason;
  this->Device = this->Library->Open(this->Number, reason);
  if (!this->Device)
  {
    error = "vendor:" + this->Plugin + ":" + std::to_string(this->Number) + " " + reason;
    return false;
  }
  std::vector<VendorLibrary::Description> devices;
  char serial[128] = "";
  if (!this->TakeLimits(reason) || !this->Library->Describe(devices, reason) ||
    this->Library->Functions().GetSerial(this->Device, serial, sizeof(serial)) < 0 ||
    this->Write({}, {}) < 0)
  {
    error = "vendor:" + this->Plugin + ":" + std::to_string(this->Number) + " " +
      (reason.empty() ? this->Library->LastError(this->Device) : reason);
    this->Disconnect();
    return false;
  }
  serial[sizeof(serial) - 1] = '\0';
  this->Label = devices[static_cast<std::size_t>(this->Number)].Name + " (vendor:" + this->Plugin +
    ":" + std::to_string(this->Number) + ")";
  this->Identity = VendorLibrary::MakeIdentity(this->Plugin, this->Number, serial);
  this->HasSerial = serial[0] != '\0';
  return true;
}

bool VendorDriver::TakeLimits(std::string& error)
{
  VolumeHapticsVendorLimits limits{};
  if (this->Library->Functions().GetLimits(this->Device, &limits) < 0)
  {
    error = this->Library->LastError(this->Device);
    return false;
  }
  const bool isValid = IsLimit(limits.MaximumForce) && limits.MaximumForce > 0.0 &&
    IsLimit(limits.MaximumTorque) && IsLimit(limits.MaximumStiffness) &&
    IsLimit(limits.MaximumDamping) && IsLimit(limits.MaximumSpeed) && IsLimit(limits.OwnDamping) &&
    IsLimit(limits.WorkspaceRadius);
  const bool hasAxis = limits.ForceAxes == 0 || (limits.ForceAxes & AllAxes) != 0;
  if (!isValid || !hasAxis)
  {
    error = "does not say its largest force, has limits that are no numbers, or has no axis. Its "
            "plug-in has to be changed.";
    return false;
  }
  this->Limits = {};
  this->Limits.MaximumForce = limits.MaximumForce;
  this->Limits.MaximumStiffness = limits.MaximumStiffness;
  this->Limits.MaximumDamping = limits.MaximumDamping;
  this->Limits.MaximumSpeed = limits.MaximumSpeed;
  this->Limits.Damping = limits.OwnDamping;
  this->Limits.WorkspaceRadius = limits.WorkspaceRadius;
  this->Limits.ForceAxes = limits.ForceAxes == 0 ? AllAxes : limits.ForceAxes & AllAxes;
  this->Limits.MaximumTorque = limits.MaximumTorque;
  return true;
}

void VendorDriver::Disconnect() noexcept
{
  if (this->Device)
  {
    this->Write({}, {});
    this->Library->Close(this->Device, this->Number);
    this->Device = nullptr;
  }
}

int VendorDriver::Write(const Vector3& force, const Vector3& torque) noexcept
{
  const Vector3 f = ClampNorm(force, this->Limits.MaximumForce);
  const Vector3 t = ClampNorm(torque, this->Limits.MaximumTorque);
  const double newtons[3] = { f.X, f.Y, f.Z };
  const double newtonMetres[3] = { t.X, t.Y, t.Z };
  return this->Library->Functions().Write(this->Device, newtons, newtonMetres);
}

void VendorDriver::Serve(HardwareExchange& exchange)
{
  /** Runs also if something throws. */
  struct AtEnd
  {
    VendorDriver* Driver;
    ~AtEnd() { this->Driver->Write({}, {}); }
  };
  const AtEnd atEnd{ this };
  this->Lost = this->IsReady = false;
  while (!exchange.MustStop())
  {
    if (exchange.HasSlept())
    {
      this->Lost = true;
      this->IsReady = false;
      this->Write({}, {});
    }
    if (exchange.TakeHomeRequest())
    {
      this->Home(exchange);
    }
    if (this->Lost)
    {
      // Quench and Close wait for rounds of zero force.
      exchange.GetForce();
      exchange.WaitForWake(VendorLostPause);
      continue;
    }
    this->Round(exchange);
    exchange.WaitForWake(VendorRoundPause);
  }
}

void VendorDriver::Home(HardwareExchange& exchange)
{
  this->Lost = this->IsReady = false;
  const auto home = this->Library->Functions().Home;
  this->Write({}, {});
  if (home && home(this->Device) < 0)
  {
    this->Lose(exchange, this->Library->LastError(this->Device));
  }
}

void VendorDriver::Round(HardwareExchange& exchange)
{
  const std::int64_t begin = ServoClock::Now();
  VolumeHapticsVendorPose pose{};
  const int result = this->Library->Functions().Read(this->Device, &pose);
  if (result == VOLUME_HAPTICS_VENDOR_WAITS)
  {
    this->IsReady = false;
    this->Tell(exchange, DeviceStage::Homing, this->Library->LastError(this->Device));
    exchange.GetForce();
    this->Write({}, {});
    return;
  }
  if (result < 0)
  {
    this->Lose(exchange, this->Library->LastError(this->Device));
    return;
  }
  this->TakePose(exchange, pose, result == VOLUME_HAPTICS_VENDOR_NEWS);
  if (this->Lost)
  {
    return;
  }
  const DeviceCommand command = exchange.GetCommand();
  if (this->Write(command.Force, command.Torque) < 0)
  {
    this->Lose(exchange, this->Library->LastError(this->Device));
    return;
  }
  exchange.NoteTaken();
  const double time = ServoClock::SecondsSince(begin);
  if (time > LongestCall)
  {
    this->Lose(exchange,
      "did not answer for " + std::to_string(static_cast<int>(1000.0 * time)) +
        " ms. Look after its cable, then Home() and Arm() again.");
  }
}

void VendorDriver::TakePose(
  HardwareExchange& exchange, const VolumeHapticsVendorPose& pose, bool isNew)
{
  const Vector3 tip{ pose.Position[0], pose.Position[1], pose.Position[2] };
  if (!IsFinite(tip) || Norm(tip) > Farthest)
  {
    this->Lose(exchange,
      "told a position that can't be. Look after its cable, then Home() and Arm() again.");
    return;
  }
  if (isNew || !this->IsReady)
  {
    DeviceSample sample;
    sample.Tip = tip;
    sample.Buttons = pose.Buttons;
    sample.HasOrientation = pose.HasOrientation != 0;
    if (sample.HasOrientation)
    {
      const double* const q = pose.Orientation;
      sample.Orientation = { q[0], q[1], q[2], q[3] };
    }
    sample.Time = ServoClock::Now() - std::max<std::int64_t>(pose.Age, 0);
    exchange.Tell(sample);
  }
  else
  {
    exchange.Confirm();
  }
  if (!this->IsReady)
  {
    this->IsReady = true;
    this->Tell(exchange, DeviceStage::Ready, "");
  }
}

void VendorDriver::Lose(HardwareExchange& exchange, const std::string& text)
{
  this->Lost = true;
  this->IsReady = false;
  this->Tell(exchange, DeviceStage::Lost, text);
  this->Write({}, {});
}

void VendorDriver::Tell(
  HardwareExchange& exchange, DeviceStage stage, const std::string& text) const
{
  exchange.SetCondition(stage, this->Label.c_str(), text.c_str());
}

} // namespace VolumeHaptics
