// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ContactSound_h
#define Explore_ContactSound_h

#include "Applications/Explorer/Sound/SoundTick.h"

#include <complex>
#include <cstddef>
#include <cstdint>

namespace Explore
{
constexpr int SAMPLES_PER_SECOND = 48000; // sample rate of files and loudspeakers (Hz)

/// The sound of a tip on surfaces: noise while it slides, a click where it touches one, and a click
/// with a burst of noise where it goes through.
///
///   ContactSound sound(48000.0);
///   sound.Feed(tick);         // each tick of the servo, in order
///   sound.Render(samples, 48) // samples until the next tick, -0.9 to 0.9
///
/// Pitch. Soft surfaces sound dull, hard ones bright. The presets give most tissues the same
/// stiffness k, and a hand distinguishes them by their strength T_N, so the pitch depends on both:
///
///   f = 500 Hz (k / 400 N/m)^(1/4) (T / 1 N)^(1/2),  T = min(T_N, 12 N),  60 Hz <= f <= 6000 Hz
///
/// Noise of friction. The power of friction, P = F v (F the friction force, v the speed of the
/// proxy), is smoothed by two low-passes of 20 ms, because a mouse moves the tip in about sixty
/// bursts a second. The root mean square of the noise is
///
///   a = 0.15 sqrt(p / (p + 20 mW)),  p = max(0, P - 1 uW)
///
/// and its spectrum is that of white noise after two equal band-passes H = 1 / (1 + j (x - 1/x)), x
/// = frequency / f.
///
/// Click of a first touch, after at least 50 ms without contact: a resonance
///
///   0.6 J / (J + 0.1 N) exp(-t / 15 ms) sin(2 pi f t)
///
/// where the impact J is the largest normal force of the first 5 ms. Click of a puncture: if, while
/// a surface is penetrated, the normal force falls below half of its peak (which decays with a time
/// constant of 50 ms), the same resonance follows, with the peak as J, and noise whose root mean
/// square begins at 0.25 J / (J + 0.1 N) and decays with 25 ms.
///
/// The sum x is limited to y = 0.9 tanh(x / 0.9). The output is exactly 0 in the air and at rest.
/// The root mean square of the noise changes by at most 1 per 5 ms, and resonances begin at zero,
/// so that there are no crackles.
///
/// Feed and Render allocate no memory, and must be called on the same thread.
class ContactSound
{
public:
  static constexpr double LOUDEST = 0.9;

  explicit ContactSound(double samplesPerSecond);

  /// Computes the pitch f (Hz) of a material from its stiffness (N/m) and strength (N).
  static double ComputePitch(double stiffness, double strength) noexcept;

  void Feed(const SoundTick& tick) noexcept;
  /// Lets the noise fade during a time (s) without ticks. Call this instead of Feed.
  void Rest(double seconds) noexcept;
  void Render(float* samples, std::size_t count) noexcept;

private:
  void UpdatePower(double watts, double seconds) noexcept;
  void UpdateTouch(const SoundTick& tick, double seconds) noexcept;
  void UpdatePuncture(const SoundTick& tick, double seconds) noexcept;
  /// Starts the resonance of a click. Returns J / (J + 0.1 N).
  double Strike(double impact) noexcept;
  void SetPitch(double pitch) noexcept;
  double NextNoise() noexcept;

  double SampleRate;
  double LastTime = 0.0;
  bool HasTime = false;

  // Updated once per tick.
  double Power[2] = { 0.0, 0.0 }; // W, output of the first and the second low-pass
  double Burst = 0.0;             // root mean square of the noise of a puncture
  double FreeTime = 0.0;          // s without contact
  // time (s) since the first touch, while its impact is measured; otherwise negative
  double TouchTime = -1.0;
  double Impact = 0.0; // largest normal force since the first touch (N)
  double Peak = 0.0;   // largest normal force (N) while a surface is penetrated
  SurfaceContact Contact = SurfaceContact::Free;
  double Pitch; // Hz, the pitch of the last surface

  // Updated once per sample.
  double Level = 0.0;  // root mean square of the noise
  double Wanted = 0.0; // target that Level approaches
  double MostStep;     // largest change of Level per sample
  std::uint32_t Seed = 0x9e3779b9u;
  struct BandPass
  {
    double Low = 0.0;
    double Band = 0.0;
  };
  BandPass Bands[2];
  double Warp = 0.0; // tan(pi f / sample rate)
  double Scale = 0.0;
  std::complex<double> Ring;
  std::complex<double> Turn; // complex factor that rotates Ring from one sample to the next
};
} // namespace Explore

#endif
