// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Renders changes of the force through a VibrationService, on the device's own thread.
 *
 * The driver measures no position: VibrationDevice.h adds the tip. The device exerts no force
 * (Vibration.h).
 */
#ifndef VibrationDriver_h
#define VibrationDriver_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Pad/Vibration.h"
#include "Devices/Vibration/VibrationService.h"

#include <cstdint>
#include <memory>
#include <string>

namespace VolumeHaptics
{

class VibrationDriver final : public HardwareDriver
{
public:
  explicit VibrationDriver(std::unique_ptr<VibrationService> service);
  ~VibrationDriver() override { this->Disconnect(); }

  std::string GetName() const override;
  DeviceLimits GetLimits() const override;
  bool Connect(std::string& error) override { return this->Service->Connect(error); }
  bool Reconnect(const std::string& identity, const std::function<bool()>& mustStop,
    std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void SendLastZero() noexcept override { this->Service->StopAtCrash(); }
  void Disconnect() noexcept override { this->Service->Disconnect(); }

private:
  void Begin(HardwareExchange& exchange);
  void Round(HardwareExchange& exchange);

  const std::unique_ptr<VibrationService> Service;
  Vibration Levels;
  VibrationService::State State = VibrationService::State::Waiting;
  bool IsLost = false;
  std::string Told; ///< last request to the user
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
