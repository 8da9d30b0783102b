// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Sound/ContactSound.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double PI = 3.14159265358979323846;

// Constants in the formulas of the class documentation.
constexpr double PITCH = 500.0;           // Hz
constexpr double PITCH_STIFFNESS = 400.0; // N/m
constexpr double PITCH_STRENGTH = 1.0;    // N
constexpr double MOST_STRENGTH = 12.0;    // N
constexpr double LOWEST = 60.0;           // Hz
constexpr double HIGHEST = 6000.0;        // Hz
// s in which the pitch glides from one surface's value to the next one's
constexpr double GLIDE_TIME = 0.02;
constexpr double LOUDEST_NOISE = 0.15; // root mean square
constexpr double MIDDLE_POWER = 0.02;  // W
constexpr double SILENT_POWER = 1e-6;  // W
constexpr double POWER_TIME = 0.02;    // s
constexpr double LEVEL_TIME = 0.005;   // shortest time (s) in which the noise rises from 0 to 1
constexpr double LOUDEST_CLICK = 0.6;
constexpr double MIDDLE_IMPACT = 0.1;  // N
constexpr double IMPACT_TIME = 0.005;  // s
constexpr double RING_TIME = 0.015;    // s
constexpr double AIR_TIME = 0.05;      // s
constexpr double PEAK_TIME = 0.05;     // s
constexpr double LEAST_PEAK = 0.05;    // N, smallest peak that counts as a puncture
constexpr double LOUDEST_BURST = 0.25; // root mean square
constexpr double BURST_TIME = 0.025;   // s
// fraction of full scale below which samples become 0; less than half a step of 16 bits
constexpr double INAUDIBLE = 1e-5;
constexpr double LARGEST = 1e9;              // largest accepted magnitude of a number in a tick
constexpr double LONGEST_STEP = 0.1;         // s, longest time between ticks that counts
constexpr double WHITE_VARIANCE = 1.0 / 3.0; // variance of a uniform random number between -1 and 1

double Saturate(double x, double middle)
{
  return x > 0.0 ? x / (x + middle) : 0.0;
}
} // namespace

namespace Explore
{
ContactSound::ContactSound(double samplesPerSecond)
  : SampleRate(samplesPerSecond)
  , Pitch(PITCH)
  , MostStep(1.0 / (LEVEL_TIME * samplesPerSecond))
{
  this->SetPitch(PITCH);
}

double ContactSound::ComputePitch(double stiffness, double strength) noexcept
{
  const double k = std::max(stiffness, 0.0) / PITCH_STIFFNESS;
  const double t = std::clamp(strength, 0.0, MOST_STRENGTH) / PITCH_STRENGTH;
  return std::clamp(PITCH * std::sqrt(std::sqrt(k) * t), LOWEST, HIGHEST);
}

void ContactSound::Feed(const SoundTick& raw) noexcept
{
  SoundTick tick = raw;
  for (double* number :
    { &tick.NormalForce, &tick.FrictionForce, &tick.Speed, &tick.Stiffness, &tick.Strength })
  {
    *number = std::isfinite(*number) ? std::clamp(*number, 0.0, LARGEST) : 0.0;
  }
  tick.Time = std::isfinite(tick.Time) ? tick.Time : this->LastTime;
  const double seconds =
    this->HasTime ? std::clamp(tick.Time - this->LastTime, 0.0, LONGEST_STEP) : 0.0;
  this->LastTime = tick.Time;
  this->HasTime = true;
  if (tick.Contact != SurfaceContact::Free)
  {
    const double pitch = ComputePitch(tick.Stiffness, tick.Strength);
    const double share =
      this->Contact == SurfaceContact::Free ? 1.0 : -std::expm1(-seconds / GLIDE_TIME);
    this->SetPitch(this->Pitch * std::pow(pitch / this->Pitch, share));
  }
  this->UpdateTouch(tick, seconds);
  this->UpdatePuncture(tick, seconds);
  this->Contact = tick.Contact;
  this->UpdatePower(tick.FrictionForce * tick.Speed, seconds);
}

void ContactSound::Rest(double seconds) noexcept
{
  this->UpdatePower(0.0, seconds);
}

void ContactSound::UpdatePower(double watts, double seconds) noexcept
{
  const double share = -std::expm1(-seconds / POWER_TIME);
  this->Power[0] += share * (watts - this->Power[0]);
  this->Power[1] += share * (this->Power[0] - this->Power[1]);
  this->Burst *= std::exp(-seconds / BURST_TIME);
  this->Burst = this->Burst < INAUDIBLE ? 0.0 : this->Burst;
  const double power = std::max(0.0, this->Power[1] - SILENT_POWER);
  this->Wanted = LOUDEST_NOISE * std::sqrt(Saturate(power, MIDDLE_POWER)) + this->Burst;
}

void ContactSound::UpdateTouch(const SoundTick& tick, double seconds) noexcept
{
  const bool isHeld = tick.Contact != SurfaceContact::Free;
  if (isHeld && this->FreeTime >= AIR_TIME)
  {
    this->TouchTime = 0.0;
    this->Impact = 0.0;
  }
  else if (this->TouchTime >= 0.0)
  {
    this->TouchTime += seconds;
  }
  this->FreeTime = isHeld ? 0.0 : this->FreeTime + seconds;
  if (this->TouchTime >= 0.0)
  {
    this->Impact = std::max(this->Impact, tick.NormalForce);
    if (this->TouchTime >= IMPACT_TIME || !isHeld)
    {
      this->Strike(this->Impact);
      this->TouchTime = -1.0;
    }
  }
}

void ContactSound::UpdatePuncture(const SoundTick& tick, double seconds) noexcept
{
  const bool penetrates = tick.Contact == SurfaceContact::Penetrating ||
    (tick.Contact == SurfaceContact::Free && this->Contact == SurfaceContact::Penetrating);
  if (!penetrates)
  {
    this->Peak = tick.NormalForce;
    return;
  }
  this->Peak = std::max(tick.NormalForce, this->Peak * std::exp(-seconds / PEAK_TIME));
  if (this->Peak >= LEAST_PEAK && tick.NormalForce < 0.5 * this->Peak)
  {
    this->Burst = std::max(this->Burst, LOUDEST_BURST * this->Strike(this->Peak));
    this->Peak = tick.NormalForce;
  }
}

double ContactSound::Strike(double impact) noexcept
{
  const double share = Saturate(impact, MIDDLE_IMPACT);
  this->Turn = std::polar(
    std::exp(-1.0 / (RING_TIME * this->SampleRate)), 2.0 * PI * this->Pitch / this->SampleRate);
  // Add to the real part, so that the imaginary part, which is the sound, continues without a step.
  this->Ring += LOUDEST_CLICK * share;
  return share;
}

void ContactSound::SetPitch(double pitch) noexcept
{
  this->Pitch = pitch;
  this->Warp = std::tan(PI * pitch / this->SampleRate);
  // White noise of variance V has the power density 2 V / sample rate, of which the two band-passes
  // let the width pi f / 4 pass.
  this->Scale = std::sqrt(2.0 * this->SampleRate / (PI * pitch * WHITE_VARIANCE));
}

/// Computes the next noise sample. The two band-passes are state-variable filters with the
/// trapezoidal rule, which stay stable while their frequency changes (V. Zavalishin, The Art of VA
/// Filter Design, 2012).
double ContactSound::NextNoise() noexcept
{
  // Xorshift (G. Marsaglia, Xorshift RNGs, 2003) generates the same sequence in every run.
  this->Seed ^= this->Seed << 13;
  this->Seed ^= this->Seed >> 17;
  this->Seed ^= this->Seed << 5;
  double value = static_cast<double>(this->Seed) / 2147483648.0 - 1.0;
  const double g = this->Warp;
  const double all = 1.0 / (1.0 + g * (g + 1.0));
  for (BandPass& band : this->Bands)
  {
    const double pass = all * (band.Band + g * (value - band.Low));
    const double low = band.Low + g * pass;
    band.Band = 2.0 * pass - band.Band;
    band.Low = 2.0 * low - band.Low;
    value = pass;
  }
  return this->Scale * value;
}

void ContactSound::Render(float* samples, std::size_t count) noexcept
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double step = std::clamp(this->Wanted - this->Level, -this->MostStep, this->MostStep);
    this->Level = std::abs(step) < this->MostStep ? this->Wanted : this->Level + step;
    double sum = this->Ring.imag();
    this->Ring *= this->Turn;
    if (std::norm(this->Ring) < INAUDIBLE * INAUDIBLE)
    {
      this->Ring = 0.0;
    }
    if (this->Level > 0.0)
    {
      sum += this->Level * this->NextNoise();
    }
    samples[i] = static_cast<float>(LOUDEST * std::tanh(sum / LOUDEST));
  }
}
} // namespace Explore
