// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sequence of messages between the host and a force-feedback stick or wheel, without a
 * transport.
 *
 * PidDialogue makes the device ready: it resets the device twice, stops all effects, enables the
 * actuators, reads the pool until the device has filled it in, and sets full gain. Then it makes
 * the constant effects (PidDevice::GetNumberOfEffects): it creates one, waits for its block, sets
 * it with a short duration and without a force, and starts it. If the first effect gets the second
 * block, the first block contains the device's own centring spring, which is stopped (Linux'
 * hid-pidff.c detects the spring in the same way). Afterwards PidStream makes the reports. An
 * effect ends by itself after its duration unless it is restarted, so the device's force becomes
 * zero if the host stops.
 */
#ifndef PidDialogue_h
#define PidDialogue_h

#include "Devices/Pid/PidDevice.h"

namespace VolumeHaptics
{

enum class PidStep : std::uint8_t
{
  Send,  ///< send the report unchanged, then call Sent()
  Fetch, ///< fetch a feature report with this id and size, then call Fetched()
  Ready, ///< all effects run
  Failed ///< GetError() returns the reason
};

class PidDialogue
{
public:
  /** Largest number of times that the device may report that an effect does not exist yet. */
  static constexpr int MaximumPolls = 60;
  static constexpr double PollPause = 0.005; ///< pause (s) between two such requests
  /**
   * Largest number of times that the pool is read until it has room for all effects, as in Linux.
   */
  static constexpr int MaximumPoolPolls = 20;

  /** Starts the dialogue. The device must outlive it. */
  PidDialogue(const PidDevice& device, const PidSettings& settings);

  /** Returns the next step, which stays the same until Sent() or Fetched() is called. */
  PidStep GetStep(HidReport& report) const;

  ///@{
  /** Report the result of the step. An empty payload means that the device has not sent one. */
  void Sent(bool went);
  void Fetched(const std::uint8_t* payload, std::size_t size);
  ///@}

  const std::string& GetError() const { return this->Error; }
  /** Returns the blocks of the effects when the dialogue is ready. */
  const std::array<std::int64_t, PidDevice::MostEffects>& GetBlocks() const noexcept
  {
    return this->Blocks;
  }

private:
  enum class Stage : std::uint8_t
  {
    FirstReset,
    SecondReset,
    StopAll,
    Enable,
    Pool,
    Gain,
    Create,
    BlockLoad,
    CentreOff,
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
  int Effect = 0;
  int Polls = 0;
  std::array<std::int64_t, PidDevice::MostEffects> Blocks{};
  std::string Error;
};

/**
 * Makes the servo's reports in order: each effect is restarted before it ends, and receives a new
 * magnitude if it has changed. After SignTime without a report, a magnitude is sent again: its
 * acknowledgement shows that the device is still connected. Neither allocates nor throws.
 */
class PidStream
{
public:
  static constexpr double SignTime = 0.01; ///< silence (s) after which a magnitude is sent again

  /** Starts the stream. The device must outlive it, and the dialogue must be ready. */
  PidStream(const PidDevice& device, const PidSettings& settings, const PidDialogue& dialogue);

  /**
   * Writes the next report to `report`. `elapsed` (s) is the time since the last call, and `force`
   * (N) acts on the hand. Returns false if nothing needs to be sent.
   */
  bool Next(double elapsed, const std::array<double, 2>& force, HidReport& report) noexcept;

private:
  const PidDevice& Device;
  const PidSettings Settings;
  std::array<std::int64_t, PidDevice::MostEffects> Blocks{};
  std::array<double, PidDevice::MostEffects> Ages{}; ///< time since the last start (s)
  /** Magnitudes as last sent. */
  std::array<std::array<std::uint8_t, HidReport::Capacity + 1>, PidDevice::MostEffects> Last{};
  double Silence = 0.0; ///< time since a report was sent (s)
  int Turn = 0;         ///< index of the effect that is served next
};

} // namespace VolumeHaptics

#endif
