// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A WoodenHaptics of 2015 with its firmware and its mechanics, written from published source.
 *
 * The packets of 14 bytes, the watchdog and the calibration button are those of the mbed firmware
 * (Forsslund Systems, 2019-09-10, "Polhem USB HID interface based on the woodenhapitcs hid";
 * forsslund/haptikfabrikenapi, firmware/main.cpp, commit a72d87e):
 * - After power-on, all counts are 0.
 * - `info` is the flag of the calibration button: 0 until the button is pressed. Command 1 clears
 *   it.
 * - Command 1 sets the first three counts to the attributes, and the other counts to the currents,
 *   while no current flows.
 * - The firmware processes only the last of several waiting packets, and answers each processed
 *   packet with a packet.
 * - After 0.5 s without a packet, the motors are off.
 *
 * Name, numbers and report descriptor are mbed's defaults (WoodenHaptics/woody-experimental, commit
 * 726e186, mbed-code/WoodenHapticsHID/USBDevice/USBHID/USBHID.h and USBHID.cpp), or those of PJRC's
 * raw HID for Teensy, with packets of 64 bytes. No firmware for a Teensy with these packets is
 * public, so the rest is an assumption for that board.
 */
#ifndef WoodenModel_h
#define WoodenModel_h

#include "DeviceModels.h"
#include "EmulatedHand.h"

#include <atomic>
#include <chrono>
#include <mutex>

namespace emulated
{

enum class WoodenFault
{
  None,
  ShortReport,
  Silence,
  WriteError,
  Jump,    ///< an encoder jumps by 2000 counts
  LostZero ///< the controller restarts unnoticed, and its encoders begin at 0
};

/**
 * The emulated device. Each received packet advances its time by a millisecond, and is answered by
 * a packet.
 */
class WoodenModel : public HidModel
{
public:
  enum class Board : std::uint8_t
  {
    Mbed,
    Teensy
  };
  explicit WoodenModel(Board board = Board::Mbed)
    : WoodenModel(board, board == Board::Mbed ? "HID DEVICE" : "Teensyduino RawHID")
  {
  }
  WoodenModel(Board board, std::string name);

  std::uint16_t GetVendor() const override { return this->IsMbed() ? 0x1234 : 0x16C0; }
  std::uint16_t GetProduct() const override { return this->IsMbed() ? 0x0006 : 0x0486; }
  std::string GetName() const override { return this->Name; }
  std::vector<std::uint8_t> GetReportDescriptor() const override;
  int Output(const std::uint8_t* report, int size) override;
  int GetFeature(std::uint8_t*, int) override { return -EPIPE; }

  /** Switches the power on. The arm is in its rest pose, which the encoders can't detect. */
  void PowerUp();
  void SetGoal(const Triple& goal);
  Triple GetTip() const;
  /** Returns the force (N) of the currents on the hand. */
  Triple GetForce() const;
  std::vector<std::uint8_t> GetLastPacket() const;
  std::vector<std::uint8_t> GetLastPreset() const;
  /** Simulates a time (s) without a packet. After 0.5 s, the firmware switches the currents off. */
  void PassTime(double time);
  int GetPresets() const { return this->Presets; }
  int GetPackets() const { return this->Packets; }
  std::atomic<WoodenFault> Fault{ WoodenFault::None };
  std::atomic<bool> IgnoresPresets{ false };
  /// number of presets that are ignored, as if another packet had followed at once
  std::atomic<int> MissedPresets{ 0 };
  std::atomic<bool> Button{ false }; ///< whether the button was pressed after the last preset

private:
  bool IsMbed() const { return this->Controller == Board::Mbed; }
  int GetPacketSize() const { return this->IsMbed() ? 14 : 64; }
  Triple ComputeForce() const;
  void SendCounts();

  const Board Controller;
  const std::string Name;
  mutable std::mutex Guard;
  EmulatedHand Hand;
  Triple Angles{};             ///< rad
  std::array<int, 3> Offset{}; ///< counts of the encoders at their zero
  std::array<int, 3> Currents{};
  std::vector<std::uint8_t> Last;
  std::vector<std::uint8_t> LastPreset;
  std::chrono::steady_clock::time_point Next;
  std::atomic<int> Presets{ 0 };
  std::atomic<int> Packets{ 0 };
};

} // namespace emulated

#endif
