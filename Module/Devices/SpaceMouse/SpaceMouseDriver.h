// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * 3Dconnexion's six-axis mice through hidapi.
 *
 * Their cap hardly moves: the push is the speed of a virtual tip, and the turn is the speed at
 * which the view turns. No force can be felt. In the tip's frame x is to the right, y up and z
 * towards the hand. The devices' own axes are taken to be x to the right, y towards the hand and z
 * down, with right-handed turns about them, as commonly described but not verified on a device.
 *
 * A cap that is held off its rest repeats its packet every 16 ms or less; a cap that is released
 * sends zero once, then nothing. If that zero is lost, the tip stops after half a second without a
 * packet.
 */
#ifndef SpaceMouseDriver_h
#define SpaceMouseDriver_h

#include "Devices/Common/RateTip.h"
#include "Devices/SpaceMouse/SpaceMouse.h"
#include "Devices/Transport/Hid/HidDriver.h"

namespace VolumeHaptics
{

class SpaceMouseDriver final : public HidDriver
{
public:
  static constexpr double HoldTime = 0.5; ///< s; how long a push counts if it is not repeated

  explicit SpaceMouseDriver(int number);

  static bool IsSpaceMouse(const HidDeviceInfo& info);
  DeviceLimits GetLimits() const override
  {
    DeviceLimits limits;
    limits.WorkspaceRadius = RateTip::Radius;
    limits.MovesTip = false;
    return limits;
  }

private:
  std::vector<HidDeviceInfo> Choose(std::string& error) const override;
  bool Prepare(const HidDeviceInfo& info, std::string& error) override;
  void Begin(HardwareExchange& exchange, bool isAnew) override;
  void Work(HardwareExchange& exchange) override;
  void Rest() noexcept override {}
  void End() noexcept override;

  void Listen(HardwareExchange& exchange);
  void Move(HardwareExchange& exchange);
  void Light(bool on) noexcept;

  const int Number;
  std::size_t LightSize = 0; ///< bytes of the light's report; 0: no light
  bool IsLit = false;
  bool IsAxisUp = false; ///< whether the device's y axis points up; otherwise its z axis points
                         ///< down
  SpaceMouse::State State;
  RateTip Tip;
  std::int64_t LastMotion = 0;
};

} // namespace VolumeHaptics

#endif
