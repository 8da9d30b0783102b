// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A gamepad through Linux' evdev: its sticks move a tip, and its motors render changes of the
 * force.
 *
 * The pad vibrates, but exerts no force (Vibration.h, PadState.h). Its node is grabbed, so that no
 * other program receives the sticks at the same time. A stick at rest sends nothing, so silence is
 * not an error. The node disappears when the pad is disconnected. Not verified on hardware.
 */
#ifndef EvdevPadDriver_h
#define EvdevPadDriver_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Common/RateTip.h"
#include "Devices/Pad/EvdevReader.h"
#include "Devices/Pad/EvdevRumble.h"
#include "Devices/Pad/PadLimits.h"
#include "Devices/Transport/Evdev/EvdevNode.h"

#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A gamepad for which Linux has a driver. */
struct EvdevPad : public EvdevNode
{
  EvdevPad() = default;
  EvdevPad(const EvdevNode& node, bool vibrates)
    : EvdevNode(node)
    , Vibrates(vibrates)
  {
  }
  bool Vibrates = false; ///< whether the pad's driver supports FF_RUMBLE

  /** Returns name and path, as shown to the user. */
  std::string GetLabel() const;
  /** Returns "available", "in use", or the obstacle and its cure. */
  std::string GetState() const;
};

/**
 * Lists all pads that have a first button and a stick with two axes, in the order of their numbers.
 */
std::vector<EvdevPad> ListEvdevPads();

/** Text with the obstacle and the cure for a pad whose driver does not support vibration. */
extern const char* const NoRumbleText;

class EvdevPadDriver final : public HardwareDriver
{
public:
  /** @param number index of the pad in ListEvdevPads; negative: the first free pad that vibrates */
  explicit EvdevPadDriver(int number);
  ~EvdevPadDriver() override { this->Disconnect(); }

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override { return MakePadLimits(); }
  bool Connect(std::string& error) override;
  bool Reconnect(const std::string& identity, const std::function<bool()>& mustStop,
    std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void SendLastZero() noexcept override { this->Rumble.Silence(); }
  void Disconnect() noexcept override;

private:
  bool Own(const EvdevPad& pad, std::string& error);
  /** Reads all axes and buttons. */
  void ReadAll() noexcept;
  void Begin(HardwareExchange& exchange);
  void Round(HardwareExchange& exchange);
  /** Waits briefly for events. Returns false if the pad was disconnected. */
  bool Listen(const HardwareExchange& exchange) noexcept;
  void Lose(HardwareExchange& exchange, const char* text) noexcept;
  void Report(HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept;

  const int Number;
  EvdevPad Pad; ///< pad that was opened last
  std::string Label = "A gamepad";
  int Node = -1;
  bool Lost = false;
  bool Gone = false; ///< whether the pad was disconnected or switched off
  EvdevReader Reader;
  RateTip Tip;
  Vibration Levels;
  EvdevRumble Rumble;
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
