// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A WoodenHaptics of 2015 as its firmware and its mechanics show it, written from what is published.
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
  Jump,    ///< an encoder counts 2000 more at once
  LostZero ///< the controller restarted: its encoders begin anew
};

/** A millisecond of its time goes by with each packet that it gets, which it answers with one of its own. */
class WoodenModel : public HidModel
{
public:
  explicit WoodenModel(std::string name = "PolhemHaptics");

  std::uint16_t GetVendor() const override { return 0x16C0; }
  std::uint16_t GetProduct() const override { return 0x0486; }
  std::string GetName() const override { return this->Name; }
  std::vector<std::uint8_t> GetReportDescriptor() const override;
  int Output(const std::uint8_t* report, int size) override;
  int GetFeature(std::uint8_t*, int) override { return -EPIPE; }

  /** Power comes: the arm is in its rest pose, and the encoders know nothing of it. */
  void PowerUp();
  void SetGoal(const Triple& goal);
  Triple GetTip() const;
  /** N on the hand, of the currents that flow. */
  Triple GetForce() const;
  std::vector<std::uint8_t> GetLastPacket() const;
  std::vector<std::uint8_t> GetLastPreset() const;
  /** Time (s) without a packet: after half a second the firmware takes the currents away. */
  void PassTime(double time);
  int GetPresets() const { return this->Presets; }
  int GetPackets() const { return this->Packets; }
  std::atomic<WoodenFault> Fault{ WoodenFault::None };
  std::atomic<bool> IgnoresPresets{ false };

private:
  Triple ComputeForce() const;
  void SendCounts();

  const std::string Name;
  mutable std::mutex Guard;
  EmulatedHand Hand;
  Triple Angles{};             ///< rad
  std::array<int, 3> Offset{}; ///< counts, of the encoders' zero
  std::array<int, 3> Currents{};
  bool IsCalibrated = false;
  std::vector<std::uint8_t> Last;
  std::vector<std::uint8_t> LastPreset;
  std::chrono::steady_clock::time_point Next;
  std::atomic<int> Presets{ 0 };
  std::atomic<int> Packets{ 0 };
};

} // namespace emulated

#endif
