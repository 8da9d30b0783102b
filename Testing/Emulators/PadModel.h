// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A gamepad or a wheel with its kernel driver, as programs access them through evdev.
 *
 * Written from the kernel's sources and documentation, independently of this library's driver:
 * - linux/input.h: structures and requests; ff.rst and gamepad.rst of the kernel's documentation;
 * - drivers/input/ff-core.c: the owners of effects; closing a file removes its effects;
 * - drivers/input/ff-memless.c: when effects begin, end and add up. An effect that is changed while
 *   it plays does not count as playing until the timer's next tick. If it is stopped before that
 *   tick, the motors stay on;
 * - drivers/input/evdev.c: grabs and lost events;
 * - drivers/input/joystick/xpad.c and drivers/hid/hid-playstation.c: the axes.
 * A jiffy is 4 ms, as in Debian's kernels.
 *
 * The wheel is a Logitech G29 with the kernel's drivers/hid/hid-lg4ff.c, held by a hand. ff-memless
 * combines its constant forces as x = sin(direction) level: an effect pulls in its direction, and
 * 0x4000 is left (linux/input.h). The device gets one byte, in which 0x80 means no force. The wheel
 * also has a centring spring, and a gain.
 */
#ifndef PadModel_h
#define PadModel_h

#include "EmulatedHand.h"

#include <linux/input.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace emulated
{

class PadModel
{
public:
  enum class Kind : std::uint8_t
  {
    Xbox,        ///< sticks from -32768 to 32767, triggers at Z and RZ
    PlayStation, ///< sticks from 0 to 255, triggers at Z and RZ
    Older,       ///< right stick at Z and RZ, no rumble
    Wheel        ///< a wheel at X, pedals at Y, Z and RZ; constant forces
  };

  /** Speeds of the motors from a point in time on, from 0 to 65535. */
  struct Change
  {
    double Time = 0.0; ///< s since the model was created
    int Strong = 0;
    int Weak = 0;
  };

  explicit PadModel(Kind kind);

  ///@{
  /** Entries of the pad in sysfs. */
  std::string GetName() const;
  int GetVendor() const;
  int GetProduct() const;
  bool Rumbles() const { return this->Model != Kind::Older && this->Model != Kind::Wheel; }
  bool HasForce() const { return this->Model != Kind::Older; }
  const std::map<unsigned, input_absinfo>& GetAxes() const { return this->Axes; }
  std::set<unsigned> GetButtons() const;
  ///@}

  ///@{
  /**
   * Moves a stick or trigger to a fraction of its range (-1 to 1, or 0 to 1), or presses a button.
   */
  void Move(unsigned axis, double share);
  void Press(unsigned button, bool isHeld);
  /** Moves an axis, but loses the event, as if the kernel's buffer were full. */
  void MoveUnheard(unsigned axis, double share);
  ///@}

  ///@{
  /**
   * Requests from a program's file. Any pointer may identify the file. Return nonnegative results,
   * or -errno.
   */
  int Grab(const void* file, bool isOn);
  int Upload(const void* file, ff_effect& effect);
  int Erase(const void* file, int id);
  int Write(const input_event& event);
  /** Closes the program's files, like the kernel when a program ends. */
  void CloseFiles();
  input_absinfo GetAxis(unsigned code);
  bool IsPressed(unsigned button);
  int GetSlots() const { return this->HasForce() ? 16 : 0; }
  ///@}

  /** Runs the kernel's timer and the hand on a wheel. Call it every millisecond. */
  void Step();
  /** Pushes the right stick forward and then pulls it back, for half a second each. */
  void StepInAndOut();

  ///@{
  /**
   * For a wheel: the full force, the goal of its hand, its position (m to the right), and the force
   * (N) on the hand.
   */
  static constexpr double FullScale = 4.0; ///< N
  static constexpr double Travel = 0.05;   ///< m, position at the end of the axis
  void SetGoal(double right);
  double GetPlace();
  double GetForce();
  int GetAutocentre();
  /** Whether the next program's effects are refused, as by an unresponsive device. */
  std::atomic<bool> Refuses{ false };
  std::string Serial; ///< serial number that the driver reports; may be empty
  ///@}

  ///@{
  Change GetMotors();
  bool IsStill();
  std::vector<Change> GetHistory();
  void ForgetHistory();
  double GetTime() const;
  int CountEffects();
  /** Returns the length (ms) of the longest requested effect; 0 stands for an endless effect. */
  int GetLongestReplay();
  ///@}

  /** A function that the carrier sets, which passes events to the reading program. */
  std::function<void(const std::vector<input_event>&)> Input = [](const auto&) {};

private:
  struct Effect
  {
    const void* Owner = nullptr;
    ff_effect What{};
    bool Started = false;
    bool Playing = false;
    bool Aborting = false;
    int Count = 0;
    long PlayAt = 0;
    long StopAt = 0;
  };
  long Jiffies() const;
  long Ticks(int milliseconds) const;
  void Playback(int id, int value);
  void PlayEffects();
  double ComputeForce() const;
  void Schedule();
  int ValueAt(unsigned axis, double share) const;
  void Send(unsigned type, unsigned code, int value);

  const Kind Model;
  const std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::map<unsigned, input_absinfo> Axes;
  std::recursive_mutex Guard;
  std::set<unsigned> Pressed;
  const void* Holder = nullptr;
  std::array<Effect, 16> Effects{};
  long TimerAt = -1;
  int Gain = 0xFFFF;
  int Autocentre = 0x8000; ///< strength of the centring spring, as left by another program
  int Force = 0x80;        ///< byte sent to the wheel; above 0x80, it pushes to the left
  EmulatedHand Hand;
  int LongestReplay = 1;
  Change Motors;
  std::vector<Change> History;
};

} // namespace emulated

#endif
