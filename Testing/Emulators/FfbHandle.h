// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A handle on one or two axes with motors: the mechanics for the models of force-feedback
 * firmwares, OpenFfboardModel and ArduinoFfbModel.
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
  Garbage, ///< reports with random positions
  Silence,
  WriteError,
  NoBlockLoad, ///< an unreadable report about a new effect
  FullPool
};

class FfbHandle : public HidModel
{
public:
  static constexpr double FullScale = 4.0; ///< N, at each motor's full torque
  static constexpr double Travel = 0.05;   ///< m, position of the handle at the end of an axis

  int Output(const std::uint8_t* report, int size) override;
  int SetFeature(const std::uint8_t* report, int size) override;
  int GetFeature(std::uint8_t* report, int size) override;

  /** Advances by a millisecond of the device's time. */
  void Step();
  void PowerUp();
  /** Sets the goal (m) of the hand that holds the handle: to the right, and away from the user. */
  void SetGoal(double right, double away);
  /**
   * Returns the handle's position (m). Along an axis without a motor, only the hand or a pedal
   * moves the handle.
   */
  Triple GetTip() const;
  /** Returns the force (N) on the hand: to the right, and away from the user. */
  Triple GetForce() const;
  int CountPlaying() const;
  int CountEffects() const;
  /** Returns the last received report with this id. */
  std::vector<std::uint8_t> GetLast(std::uint8_t id) const;
  int GetResets() const { return this->Resets; }
  int CountOutputs() const { return this->Outputs; }
  /** Returns the time of the device's clock (ms since power-on). */
  int GetClock() const { return this->Time; }

  std::atomic<FfbFault> Fault{ FfbFault::None };
  ///@{
  /**
   * Deviations from the published firmware: report every millisecond; report only new values; check
   * for new values less often than every millisecond.
   */
  std::atomic<bool> Streams{ false };
  std::atomic<bool> OnlySaysNews{ false };
  std::atomic<int> ReportPeriod{ 1 }; ///< ms
  ///@}
  /** Sign of the second motor: -1 for reversed wiring. */
  std::atomic<double> SecondSign{ 1.0 };
  std::atomic<int> Buttons{ 0 };

protected:
  using Bytes = std::vector<std::uint8_t>;

  explicit FfbHandle(int motors)
    : Motors(motors)
  {
  }

  ///@{
  /**
   * Functions of the firmware, called with the mutex locked. Output and feature reports include
   * their id. Return sizes or -errno.
   */
  virtual int ReceiveOutput(const std::uint8_t* report, int size) = 0;
  virtual int ReceiveFeature(const std::uint8_t* report, int size) = 0;
  virtual int GiveFeature(std::uint8_t* report, int size) = 0;
  virtual void ForgetEffects() = 0;
  virtual int CountAll(bool onlyPlaying) const = 0;
  /**
   * Returns fractions of the full torque, positive towards the positive ends of HID's axes x and y.
   */
  virtual std::array<double, 2> ComputeTorques() const = 0;
  /** Returns the input report for a position (-1 to 1 on HID's axes). */
  virtual Bytes BuildReport(double x, double y) const = 0;
  /** Returns the time (ms) after which a report is repeated even without news. */
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
  int SinceSent = 0; ///< ms since the last report was sent
  std::map<std::uint8_t, Bytes> Last;
  std::atomic<int> Resets{ 0 };
  std::atomic<int> Outputs{ 0 };
  std::uint32_t Noise = 1;
};

} // namespace emulated

#endif
