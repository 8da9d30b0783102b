// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * 3Dconnexion's six-axis mice through hidapi.
 *
 * The cap of these devices hardly moves: pushing it sets the speed of a virtual tip, and turning it
 * the speed at which the view rotates. The devices exert no force. In the tip's frame, x points to
 * the right, y up and z towards the hand. The devices' own axes are assumed to be x to the right, y
 * towards the hand and z down, with right-handed rotations about them, as they are commonly
 * described; this was not verified on a device.
 *
 * While the cap is deflected, the device repeats its packet at least every 16 ms. When the cap is
 * released, the device sends zero once, and then nothing. If that zero is lost, the tip stops after
 * half a second without a packet.
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
  /** Time (s) for which a push remains valid without being repeated. */
  static constexpr double HoldTime = 0.5;

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
  std::size_t LightSize = 0; ///< number of bytes of the light's report; 0 if there is no light
  bool IsLit = false;
  /** Whether the device's y axis points up; otherwise, its z axis points down. */
  bool IsAxisUp = false;
  SpaceMouse::State State;
  RateTip Tip;
  std::int64_t LastMotion = 0;
};

} // namespace VolumeHaptics

#endif
