// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The dialogue between the host and a force-feedback stick or wheel, without a transport.
 *
 * PidDialogue makes the device ready: it resets twice, enables the actuators, reads the pool and
 * sets full gain. Then for each axis it creates a constant effect, waits for its block, sets it
 * with a short duration and no force, and starts it. From then on PidStream makes the reports. An
 * effect ends by itself after its duration unless it is started again, so the device's force goes
 * to zero if the host dies.
 */
#ifndef PidDialogue_h
#define PidDialogue_h

#include "Devices/Pid/PidDevice.h"

namespace VolumeHaptics
{

enum class PidStep : std::uint8_t
{
  Send,  ///< send the report unchanged, then call Sent
  Fetch, ///< get a feature report of this id and size, then call Fetched
  Ready, ///< all effects run
  Failed ///< see GetError
};

class PidDialogue
{
public:
  /**
   * How often the device may report that it has not made an effect yet; there is a pause between
   * two polls.
   */
  static constexpr int MaximumPolls = 60;
  static constexpr double PollPause = 0.005; ///< s, the pause before the next poll

  /** The device has to outlive the dialogue. */
  PidDialogue(const PidDevice& device, const PidSettings& settings);

  /** Returns the next step; the same step until Sent or Fetched is called. */
  PidStep GetStep(HidReport& report) const;

  ///@{
  /** Report the result of the step. An empty payload means that the device gave none. */
  void Sent(bool went);
  void Fetched(const std::uint8_t* payload, std::size_t size);
  ///@}

  const std::string& GetError() const { return this->Error; }
  /** Returns the block of an axis' effect, once the dialogue is ready. */
  std::int64_t GetBlock(int axis) const noexcept { return this->Blocks[axis]; }

private:
  enum class Stage : std::uint8_t
  {
    FirstReset,
    SecondReset,
    Enable,
    Pool,
    Gain,
    Create,
    BlockLoad,
    SetEffect,
    NoForce,
    Start,
    Ready,
    Failed
  };

  void Advance();
  void Fail(std::string error);

  const PidDevice& Device;
  const PidSettings Settings;
  Stage Now = Stage::FirstReset;
  int Axis = 0;
  int Polls = 0;
  std::array<std::int64_t, 2> Blocks{};
  std::string Error;
};

/**
 * The reports of the servo, in order: each axis is restarted before its effect ends, and gets a new
 * magnitude if it has changed. If nothing else was sent for SignTime, a magnitude is sent again: by
 * taking it, the device shows that it is connected. No allocation, no exception.
 */
class PidStream
{
public:
  static constexpr double SignTime = 0.01; ///< s

  /** The device has to outlive the stream, and the dialogue has to be ready. */
  PidStream(const PidDevice& device, const PidSettings& settings, const PidDialogue& dialogue);

  /**
   * Adds the time (s) since the last call, takes the force on the hand (N), and writes the next
   * report to `report`. Returns false if nothing needs to be sent.
   */
  bool Next(double elapsed, const std::array<double, 2>& force, HidReport& report) noexcept;

private:
  const PidDevice& Device;
  const PidSettings Settings;
  std::array<std::int64_t, 2> Blocks{};
  std::array<double, 2> Ages{}; ///< s since the last start
  std::array<std::array<std::uint8_t, HidReport::Capacity + 1>, 2> Last{}; ///< magnitudes sent
  double Silence = 0.0; ///< s since anything was sent
  int Turn = 0;         ///< the axis whose turn is next
};

} // namespace VolumeHaptics

#endif
