// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SoundStream_h
#define Explore_SoundStream_h

#include "Applications/Explorer/Sound/ContactSound.h"
#include "Core/Servo/TraceRing.h"

#include <atomic>
#include <cstddef>

namespace Explore
{
/// Transfers ticks from one thread to another, which plays them as sound. Neither thread waits.
///
/// The ticks arrive in bursts, one for each frame of the window, and are played at the rate of
/// their times. The delay of the sound equals the duration of the last burst, but at most 0.3 s:
/// older ticks are skipped. If no tick arrives for 50 ms, the noise fades.
///
/// The sound fades in and out within 10 ms.
class SoundStream
{
public:
  explicit SoundStream(double samplesPerSecond);
  SoundStream(const SoundStream&) = delete;
  SoundStream& operator=(const SoundStream&) = delete;

  /// Adds a tick. Ticks must be in the order of time. Called on the thread that produces the ticks.
  /// If 4096 ticks are waiting, the new tick is lost.
  void Push(const SoundTick& tick) noexcept;

  /// Mutes or unmutes the sound. Any thread may call it.
  void SetMuted(bool muted) noexcept { this->Muted.store(muted, std::memory_order_relaxed); }
  bool IsMuted() const noexcept { return this->Muted.load(std::memory_order_relaxed); }

  /// Writes the next samples, each from -0.9 to 0.9. Called on the thread that plays.
  void Render(float* samples, std::size_t count) noexcept;
  double GetSampleRate() const noexcept { return this->SampleRate; }

private:
  void Advance(double seconds) noexcept;
  /// Plays slightly faster while more ticks are waiting than a burst contains.
  void UpdateBacklog(double backlog, double seconds) noexcept;

  const double SampleRate;
  std::atomic<bool> Muted{ false };
  std::atomic<double> Newest; // time of the latest tick (s)
  VolumeHaptics::TraceRing<SoundTick> Ticks;

  // Used only by the thread that plays.
  ContactSound Sound;
  SoundTick Next;
  bool HasNext = false;
  bool HasBegun = false;
  double Position = 0.0; // current time of the playback (s), on the clock of the ticks
  double Starved = 0.0;  // time since the last tick (s)
  double Pace = 1.0;
  double WindowTime = 0.0;   // time (s) since the search for LeastBacklog began
  double LeastBacklog = 0.0; // least backlog during that search (s)
  double Gain = 0.0;
};
} // namespace Explore

#endif
