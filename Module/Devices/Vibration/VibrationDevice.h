// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device that vibrates and has no position: the program, or the mouse, leads its tip.
 *
 * The tip is that of the virtual device. The force goes, after the gate and the safety stage, to a
 * second back end, whose thread or guard shows it (VibrationDriver.h).
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
  /** @param shower the back end that shows the force; its position does not count */
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
  DeviceSample Shown;   ///< the last sample of the shower
  double Silence = 0.0; ///< time (s) since the last sign of life of the shower
};

} // namespace VolumeHaptics

#endif
