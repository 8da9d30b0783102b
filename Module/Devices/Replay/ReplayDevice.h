// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device whose stylus follows a recording, one position in each tick.
 */
#ifndef ReplayDevice_h
#define ReplayDevice_h

#include "Core/Safety/DeviceBackend.h"

#include <vector>

namespace VolumeHaptics
{

class ReplayDevice : public DeviceBackend
{
public:
  /**
   * Makes a device for a recording. `tips` are positions (m) in this device's space; after the last
   * one, the device is Finished. `name` is the recording's name. `orientations` contains one
   * orientation for each tip, or none. Orientations with a norm other than 1 are invalid.
   */
  ReplayDevice(
    std::vector<Vector3> tips, std::string name, std::vector<Quaternion> orientations = {});

  bool Open(std::string& error) override;
  void Close() override {}
  std::string GetName() const override { return this->Name; }
  DeviceLimits GetLimits() const override;
  DeviceState Read(double period, DeviceSample& sample) noexcept override;
  DeviceState Write(const Vector3& force) noexcept override;
  void Quench() noexcept override {}

private:
  const std::vector<Vector3> Tips;
  const std::vector<Quaternion> Orientations;
  const std::string Name;
  std::size_t Next = 0;
};

} // namespace VolumeHaptics

#endif
