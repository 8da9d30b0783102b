// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device behind a plug-in for its vendor's library (VendorPlugin.h).
 *
 * In each round it reads the pose and writes the force; a round follows each force of the servo, or
 * the last round by a millisecond. If a call of the plug-in does not return, the servo's force is
 * zero after 30 ms, as there are no positions, but the device does not get it: then only the
 * vendor's watchdog ends the force.
 */
#ifndef VendorDriver_h
#define VendorDriver_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Vendor/VendorLibrary.h"

namespace VolumeHaptics
{

class VendorDriver final : public HardwareDriver
{
public:
  /** s. A longer call is a fault: the device was not observed meanwhile. */
  static constexpr double LongestCall = 0.5;

  /** `path` as in VendorFolder::Split. */
  VendorDriver(std::string plugin, int number, std::string path);
  ~VendorDriver() override;

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override { return this->Limits; }
  std::string GetIdentity() const override { return this->Identity; }
  bool KeepsIdentity() const override { return this->HasSerial; }
  bool Connect(std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void Disconnect() noexcept override;

private:
  bool TakeLimits(std::string& error);
  void Round(HardwareExchange& exchange);
  void TakePose(HardwareExchange& exchange, const VolumeHapticsVendorPose& pose, bool isNew);
  void Home(HardwareExchange& exchange);
  void Lose(HardwareExchange& exchange, const std::string& text);
  void Tell(HardwareExchange& exchange, DeviceStage stage, const std::string& text) const;
  int Write(const Vector3& force, const Vector3& torque) noexcept;

  const std::string Plugin;
  const int Number;
  const std::string Path;
  std::string Label;
  std::string Identity;
  bool HasSerial = false; ///< without it, a plug-in's devices may change their numbers
  DeviceLimits Limits;
  std::shared_ptr<VendorLibrary> Library;
  void* Device = nullptr;
  bool Lost = false;
  bool IsReady = false;
};

} // namespace VolumeHaptics

#endif
