// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A handle on one or two axes that motors push: what is around a force-feedback firmware. The
 * firmwares are OpenFfboardModel and ArduinoFfbModel.
 */
#ifndef FfbHandle_h
#define FfbHandle_h

#include "DeviceModels.h"
#include "EmulatedHand.h"

#include <atomic>
#include <map>
#include <mutex>

namespace emulated
{

enum class FfbFault
{
  None,
  ShortReport,
  Garbage, ///< reports of random places
  Silence,
  WriteError,
  NoBlockLoad, ///< the report about the new effect can't be fetched
  FullPool
};

class FfbHandle : public HidModel
{
public:
  static constexpr double FullScale = 4.0; ///< N, of each motor's full torque
  static constexpr double Travel = 0.05;   ///< m, of the handle at the end of an axis

  int Output(const std::uint8_t* report, int size) override;
  int SetFeature(const std::uint8_t* report, int size) override;
  int GetFeature(std::uint8_t* report, int size) override;

  /** A millisecond goes by. */
  void Step();
  void PowerUp();
  /** Where the hand leads the handle to (m): to the right, and away from itself. */
  void SetGoal(double right, double away);
  /** m. Along an axis without a motor it is the hand alone that moves the handle, or a pedal. */
  Triple GetTip() const;
  /** N on the hand: to the right, and away from it. */
  Triple GetForce() const;
  int CountPlaying() const;
  int CountEffects() const;
  /** The last report of an id. */
  std::vector<std::uint8_t> GetLast(std::uint8_t id) const;
  int GetResets() const { return this->Resets; }
  int CountOutputs() const { return this->Outputs; }
  /** ms since power came, by the device's clock. */
  int GetClock() const { return this->Time; }

  std::atomic<FfbFault> Fault{ FfbFault::None };
  ///@{
  /**
   * Unlike the published firmware: it reports in every millisecond, or only what is new, or it
   * looks for news less often than in every millisecond.
   */
  std::atomic<bool> Streams{ false };
  std::atomic<bool> OnlySaysNews{ false };
  std::atomic<int> ReportPeriod{ 1 }; ///< ms
  ///@}
  /** -1: its second motor is wired the other way round. */
  std::atomic<double> SecondSign{ 1.0 };
  std::atomic<int> Buttons{ 0 };

protected:
  using Bytes = std::vector<std::uint8_t>;

  explicit FfbHandle(int motors)
    : Motors(motors)
  {
  }

  ///@{
  /** The firmware, under the lock. Outputs and features with their id; sizes or -errno. */
  virtual int TakeOutput(const std::uint8_t* report, int size) = 0;
  virtual int TakeFeature(const std::uint8_t* report, int size) = 0;
  virtual int GiveFeature(std::uint8_t* report, int size) = 0;
  virtual void ForgetEffects() = 0;
  virtual int CountAll(bool onlyPlaying) const = 0;
  /** Parts of the full torque, towards the positive ends of HID's axes x and y. */
  virtual std::array<double, 2> ComputeTorques() const = 0;
  /** The input report for a place, -1 to 1 on HID's axes. */
  virtual Bytes BuildReport(double x, double y) const = 0;
  /** After how long (ms) a report goes out although nothing is new. */
  virtual int GetReminderTime() const = 0;
  ///@}

  void CountReset() { ++this->Resets; }
  bool IsFull() const { return this->Fault == FfbFault::FullPool; }

  static int Word(const std::uint8_t* bytes)
  {
    return static_cast<std::int16_t>(bytes[0] | bytes[1] << 8);
  }
  static void Append(Bytes& bytes, int word)
  {
    bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(word >> 8 & 0xFF));
  }

private:
  Triple Push() const;
  void Report();

  const int Motors;
  mutable std::mutex Guard;
  EmulatedHand Hand;
  Bytes Sent;
  std::atomic<int> Time{ 0 };
  int SinceSent = 0; ///< ms
  std::map<std::uint8_t, Bytes> Last;
  std::atomic<int> Resets{ 0 };
  std::atomic<int> Outputs{ 0 };
  std::uint32_t Noise = 1;
};

} // namespace emulated

#endif
