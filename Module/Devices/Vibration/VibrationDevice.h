// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device that vibrates and measures no position: the program or the mouse moves its tip.
 *
 * The tip is that of the virtual device. After the gate and the safety stage, the force is passed
 * to a second back end, whose thread or guard renders it as vibration (VibrationDriver.h).
 */
#ifndef VibrationDevice_h
#define VibrationDevice_h

#include "Devices/Virtual/VirtualDevice.h"

#include <memory>

namespace VolumeHaptics
{

class VibrationDevice final : public VirtualDevice
{
public:
  /** @param shower the back end that renders the force; its position is ignored */
  explicit VibrationDevice(std::unique_ptr<DeviceBackend> shower);

  bool Open(std::string& error) override;
  void Close() override;
  std::string GetName() const override { return this->Shower->GetName(); }
  DeviceCondition GetCondition() override { return this->Shower->GetCondition(); }
  void Home() noexcept override { this->Shower->Home(); }
  DeviceState Read(double period, DeviceSample& sample) noexcept override;
  DeviceState Write(const Vector3& force) noexcept override;
  void Quench() noexcept override;
  bool IsAtRest() const noexcept override { return this->Shower->IsAtRest(); }

private:
  const std::unique_ptr<DeviceBackend> Shower;
  // Members that only the servo uses.
  DeviceSample Shown;   ///< last sample of the second back end
  double Silence = 0.0; ///< time (s) since the second back end last responded
};

} // namespace VolumeHaptics

#endif
