// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * An arm with an hfab controller at a pseudo-terminal, written from its published firmware and host
 * program.
 *
 * The controller is the firmware of forsslund/woodenhaptics, firmware/woody_teensy_mini (commit
 * 86ecdba):
 * - It reads byte by byte up to a ']'.
 * - The answers 256, 512, 8, 128 and 1024 mean a rejected message, and repeat the previous counts.
 * - An accepted message feeds a watchdog, which switches the currents off after 100 ms.
 * - A current beyond the amplifiers' limit counts as zero for that motor alone.
 * - Its button sets all counts to 0, as power-on does.
 * - With the switch calibration_needed, it keeps the amplifiers off until its button is pressed.
 *   Until then, it answers with a slow sine as the first count, and with the requested current of
 *   the first motor as the second count.
 *
 * The arm is that of the published host, forsslund/hfabapi (commit cf00e97): tables of hfab_math.h,
 * positions of hfab_kinematics.cpp, and Polhem's linkage by the three angles of hfab_polhem.h.
 * Slopes are differences of these positions, as in the host for Polhem.
 */
#ifndef HfabEmulator_h
#define HfabEmulator_h

#include "EmulatedHand.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>

namespace emulated
{

enum class HfabFault
{
  None,
  Silence,
  Junk,     ///< sends bytes that are not an answer
  Late,     ///< answers after 30 ms
  OtherArm, ///< reports another model
  Refusal,  ///< rejects messages, as if each were followed by another one
  Jump      ///< an encoder jumps by 1000 counts
};

class HfabEmulator
{
public:
  /** Plugs in an arm of a model: 1 Polhem, 2 PHANToM, 3 WoodenHaptics. */
  explicit HfabEmulator(int model);
  ~HfabEmulator();
  HfabEmulator(const HfabEmulator&) = delete;
  HfabEmulator& operator=(const HfabEmulator&) = delete;

  /** The port's node. */
  const std::string& GetPort() const { return this->Port; }
  void Unplug();
  /** Moves the arm into its calibration pose at once. */
  void PlaceAtHome();
  void PressButton();
  /** Requires that the button is pressed first, like the firmware with calibration_needed. */
  void NeedButton() { this->NeedsButton = true; }
  void SetGoal(const Triple& goal);
  /** Turns the handle until its encoders have these counts. */
  void SetHandle(const std::array<int, 3>& counts);
  Triple GetTip() const;
  /** Returns the force (N) of the currents on the hand. */
  Triple GetForce() const;
  std::array<int, 3> GetCurrents() const;
  int GetMessages() const { return this->Messages; }
  /**
   * GetWatchdogs() returns how often the watchdog has switched the currents off. GetErrors()
   * returns the bits of errors in messages.
   */
  int GetWatchdogs() const { return this->Watchdogs; }
  int GetErrors() const { return this->Errors; }
  /** Returns the longest time (s) between two messages since the last call. */
  double DrainLongestPause();
  /** Returns whether the port was opened for raw bytes. */
  bool IsRaw() const;

  ///@{
  /** The published arithmetic, for calibrated counts. */
  static Triple TipOf(int model, const Triple& angles);
  static Triple AnglesOf(int model, const std::array<int, 3>& counts);
  static std::array<int, 3> HomeOf(int model);
  /** Returns the currents (mA) of the motors for a force (N). */
  static Triple CurrentsOf(int model, const Triple& angles, const Triple& force);
  ///@}

  std::atomic<HfabFault> Fault{ HfabFault::None };

private:
  void Run();
  void Take(char byte, bool isTrailed);
  void Answer(int error);
  void ReceiveCurrents(const std::array<int, 3>& milliamperes);
  void Move();

  const int Model;
  int Master = -1;
  std::string Port;
  mutable std::mutex Guard;
  EmulatedHand Hand;
  Triple Angles{};
  std::array<int, 3> Offset{}; ///< counts at home, relative to the encoders' zero
  std::array<int, 3> Counts{};
  std::array<int, 3> Handle{};
  std::array<int, 3> Currents{};
  std::string Line;
  std::chrono::steady_clock::time_point LastBytes;
  std::chrono::steady_clock::time_point HeldUpUntil;
  std::chrono::steady_clock::time_point LastMessage;
  std::chrono::steady_clock::duration LongestPause{};
  std::chrono::steady_clock::time_point LastMove;
  std::atomic<int> Messages{ 0 };
  std::atomic<int> Watchdogs{ 0 };
  std::atomic<int> Errors{ 0 };
  std::atomic<bool> Stop{ false };
  std::atomic<bool> NeedsButton{ false };
  int Pretended = 0; ///< number of remaining answers whose counts are not positions
  std::thread Thread;
};

} // namespace emulated

#endif
