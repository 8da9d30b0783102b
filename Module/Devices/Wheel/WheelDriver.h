// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A force-feedback wheel without HID-PID, such as Logitech's, Thrustmaster's and Fanatec's, through
 * its driver in Linux (evdev).
 *
 * The wheel moves the tip along x, at most 5 cm to each side, as in PidDriver. The kernel's driver
 * plays a constant effect (FF_CONSTANT). In Linux, an effect pulls in its direction
 * (linux/input.h), so a positive level with the direction 0x4000 pushes to the left. Some drivers
 * deviate from this: the first Arm() checks the sign, and a negative NewtonsPerFullScale reverses
 * it.
 *
 * The effect lasts ReplayLength, and is renewed at least every RenewTime: the kernel ends it if
 * this process hangs, and erases it if the process ends. The kernel's centring spring is switched
 * off. Many drivers renew forces only with the kernel's timer, every 4 ms, which limits the
 * stiffness. Not verified on hardware.
 */
#ifndef WheelDriver_h
#define WheelDriver_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Transport/Evdev/EvdevNode.h"

namespace VolumeHaptics
{

/** Lists the wheels that do not use HID-PID and whose drivers play constant effects. */
std::vector<EvdevNode> ListWheels();

class WheelDriver final : public HardwareDriver
{
public:
  static constexpr double Travel = 0.05;       ///< position of the tip (m) at the end of the axis
  static constexpr double FastestWheel = 5.0;  ///< m/s, as in PidDriver
  static constexpr int ReplayLength = 100;     ///< ms
  static constexpr double RenewTime = 0.01;    ///< s
  static constexpr double ShortestTime = 4e-3; ///< shortest time (s) between two nonzero forces

  /**
   * @param number index of the wheel in ListWheels
   * @param newtons force (N) at full scale; a negative value reverses the force
   */
  WheelDriver(int number, double newtons);
  ~WheelDriver() override { this->Disconnect(); }

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override;
  /** Returns an identity that includes whether the user has reversed the force. */
  std::string GetIdentity() const override;
  bool KeepsIdentity() const override { return !this->Info.Serial.empty() && !this->HasTwin; }
  bool Connect(std::string& error) override;
  bool Reconnect(const std::string& identity, const std::function<bool()>& mustStop,
    std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void SendLastZero() noexcept override { this->Rest(); }
  void Disconnect() noexcept override;

  static std::string MakeIdentity(const EvdevNode& node);
  static std::string MakeLabel(const EvdevNode& node);

private:
  bool Take(const EvdevNode& node, std::string& error);
  /**
   * Returns the message for an unplugged wheel: whether it will be reopened automatically or has to
   * be opened by the user. To decide, searches other wheels with its serial number; if there is
   * one, the wheel can't be reopened automatically.
   */
  const char* FindUnpluggedText();
  void Begin(HardwareExchange& exchange);
  void Round(HardwareExchange& exchange);
  /** Reads events. Returns false if the wheel is gone. */
  bool Listen(const HardwareExchange& exchange) noexcept;
  /** Reads axis and buttons. Returns false if the wheel is gone. */
  bool ReadAll() noexcept;
  /** Sends a level, -32767 to 32767, if it is due. Returns false if the driver refuses it. */
  bool Show(int level) noexcept;
  bool Play(int level) noexcept;
  /** Ends the force and erases the effect. */
  void Rest() noexcept;
  void Lose(HardwareExchange& exchange, const char* text) noexcept;
  void Report(HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept;

  const int Number;
  const double Newtons;
  std::string Label = "A wheel";
  EvdevNode Info; ///< the wheel that was connected last
  int Node = -1;
  int Effect = -1; ///< number of the effect in the kernel; -1 if there is none yet
  int Level = 0;   ///< last level sent
  std::int64_t SentAt = 0;
  int Value = 0; ///< value of the axis
  int Least = 0;
  int Most = 1;
  std::uint32_t Buttons = 0;
  bool IsDropping = false; ///< whether events were lost, so that the rest of the report is dropped
  bool HasNews = false;
  bool IsReady = false;
  bool HasTwin = false; ///< whether another wheel with the same serial number was plugged in
  bool Lost = false;
  bool Gone = false;
};

} // namespace VolumeHaptics

#endif
