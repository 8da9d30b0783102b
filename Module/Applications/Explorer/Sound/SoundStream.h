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
/// Passes ticks from one thread to another, which plays them as sound, without waiting on either
/// side.
///
/// The ticks come in bursts, as often as the window is drawn, and are played at the pace of their
/// times. The sound is as late as the last burst was long, but at most 0.3 s: older ticks are
/// skipped. If no ticks come for 50 ms, the noise fades.
///
/// Sound begins, is muted and comes back over 10 ms.
class SoundStream
{
public:
  explicit SoundStream(double samplesPerSecond);
  SoundStream(const SoundStream&) = delete;
  SoundStream& operator=(const SoundStream&) = delete;

  /// Adds a tick, in order; for the thread with the ticks. If 4096 ticks wait already, the tick is
  /// lost.
  void Push(const SoundTick& tick) noexcept;

  /// Mutes the sound or lets it be heard; for any thread.
  void SetMuted(bool muted) noexcept { this->Muted.store(muted, std::memory_order_relaxed); }
  bool IsMuted() const noexcept { return this->Muted.load(std::memory_order_relaxed); }

  /// Writes the next samples, each in -0.9 ... 0.9; for the thread that plays.
  void Render(float* samples, std::size_t count) noexcept;
  double GetSampleRate() const noexcept { return this->SampleRate; }

private:
  void Advance(double seconds) noexcept;
  /// Plays a little faster as long as more ticks wait than bursts need.
  void UpdateBacklog(double backlog, double seconds) noexcept;

  const double SampleRate;
  std::atomic<bool> Muted{ false };
  std::atomic<double> Newest; // s, the time of the last pushed tick
  VolumeHaptics::TraceRing<SoundTick> Ticks;

  // Used by the thread that plays.
  ContactSound Sound;
  SoundTick Next;
  bool HasNext = false;
  bool HasBegun = false;
  double Position = 0.0; // time of the played sound, on the clock of the ticks (s)
  double Starved = 0.0;  // s without a tick
  double Pace = 1.0;
  double WindowTime = 0.0;   // s since the search for LeastBacklog began
  double LeastBacklog = 0.0; // least backlog in that time (s)
  double Gain = 0.0;
};
} // namespace Explore

#endif
