// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/ContactTransient.h"

#include "Core/Safety/UnseenMotion.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double TwoPi = 6.283185307179586;
/** Shortest time (s) over which the velocity is averaged. */
constexpr double ApproachTime = 3e-3;
/** Frequency (Hz) for a surface with 400 N/m and 1 N, and the limits of all frequencies. */
constexpr double MiddleFrequency = 120.0;
constexpr double LowestFrequency = 50.0;
constexpr double HighestFrequency = 300.0;
/** Strengths (N) above this limit do not raise the frequency. */
constexpr double MostStrength = 12.0;
/** The pulse ends after this number of periods, when it has decayed to 0.2 %. */
constexpr double LastPeriod = 6.0;

/** Integral of exp(-x) sin(2 pi x) from 0 to x. */
double Integrate(double x) noexcept
{
  const double wave = std::exp(-x) * (std::sin(TwoPi * x) + TwoPi * std::cos(TwoPi * x));
  return (TwoPi - wave) / (1.0 + TwoPi * TwoPi);
}

} // namespace

double ContactTransient::ComputeFrequency(double stiffness, double strength) noexcept
{
  const double held = std::clamp(strength, 0.0, MostStrength);
  const double f = MiddleFrequency * std::pow(stiffness / 400.0, 0.25) * std::sqrt(held);
  return stiffness > 0.0 && held > 0.0 ? std::clamp(f, LowestFrequency, HighestFrequency) : 0.0;
}

void ContactTransient::Observe(const Vector3& tip, double time, double late, double period) noexcept
{
  const Vector3 motion = tip - this->Tip;
  const bool isKnown = this->HasTip && time > 0.0 && !IsUnseenMotion(motion, time);
  this->HasTip = true;
  this->Tip = tip;
  this->Late = late;
  this->Time += time;
  this->Rested = 0.0;
  if (!isKnown)
  {
    this->Count = 0;
    this->Velocity = {};
    this->Height = 0.0;
    this->Account = std::min(this->Account, 0.0);
  }
  else
  {
    const auto before = static_cast<std::size_t>(std::ceil(late / period - 0.01));
    const std::size_t acted = std::min({ this->SentSince + before, this->Sent, Kept });
    double given = acted > 0 ? Dot(this->Pulses[(this->Sent - 1) % Kept], motion) : 0.0;
    for (std::size_t i = 2; i <= acted; ++i)
    {
      given = std::max(given, Dot(this->Pulses[(this->Sent - i) % Kept], motion));
    }
    this->Account -= given;
    this->Between = time;
  }
  this->SentSince = 0;
  this->Measurements[this->Count % Kept] = { this->Time, tip };
  ++this->Count;
  const std::size_t kept = std::min(this->Count, Kept);
  for (std::size_t n = 1; n < kept; ++n)
  {
    const Measurement& first = this->Measurements[(this->Count - 1 - n) % Kept];
    const double span = this->Time - first.Time;
    this->Velocity = span > 0.0 ? (1.0 / span) * (tip - first.Tip) : Vector3{};
    if (span >= ApproachTime * (1.0 - 1e-9))
    {
      break;
    }
  }
}

void ContactTransient::Rest(double time) noexcept
{
  this->Rested += time;
  this->Velocity = ClampNorm(this->Velocity, StepSize / this->Rested);
}

void ContactTransient::RecordSent(const Vector3& pulse) noexcept
{
  this->Pulses[this->Sent % Kept] = pulse;
  ++this->Sent;
  ++this->SentSince;
}

void ContactTransient::Begin(const TransientInput& input) noexcept
{
  const Vector3 out = (1.0 / Norm(input.Wall)) * input.Wall;
  const double approach = std::max(0.0, -Dot(this->Velocity, out));
  this->Frequency = input.Frequency;
  this->Height = input.Gain * TouchMass * approach * input.Frequency / Integrate(0.5);
  this->Played = 0.0;
  this->Account = std::min(this->Account, 0.0);
}

/** Returns the pulse (N) of (1), averaged over the next tick. */
double ContactTransient::ComputePulse(double period) const noexcept
{
  const double from = this->Frequency * this->Played;
  const double way = this->Frequency * period;
  return this->Height * (Integrate(from + way) - Integrate(from)) / way;
}

/** Reduces a pulse along `out` so that (3) holds. `wall` (N) is the force of the wall. */
double ContactTransient::Limit(
  double pulse, double wall, const Vector3& out, double period) const noexcept
{
  const double time = std::max(this->Between, period) + this->Late;
  const double yield = 0.5 * time * time / LightMass;
  const double along = time * Dot(this->Velocity, out);
  const double way = pulse < 0.0 ? -along : along + yield * wall;
  const double root = way * way + 4.0 * yield * this->Account;
  const double most = root > 0.0 ? std::max(0.0, (std::sqrt(root) - way) / (2.0 * yield)) : 0.0;
  return std::clamp(pulse, -most, most);
}

Vector3 ContactTransient::Apply(const TransientInput& input) noexcept
{
  const double wall = Norm(input.Wall);
  if (!(input.Frequency > 0.0))
  {
    this->Free += input.Period;
    this->Account = this->Free < RestTime ? this->Account : 0.0;
    this->Height = 0.0;
    return input.Wall;
  }
  if (!(wall > 0.0))
  {
    this->Free = 0.0;
    this->Height = 0.0;
    return input.Wall;
  }
  if (this->Free >= FreeTime)
  {
    this->Begin(input);
  }
  this->Free = 0.0;
  if (!(this->Height > 0.0))
  {
    return input.Wall;
  }
  const Vector3 out = (1.0 / wall) * input.Wall;
  double pulse = input.Share * this->ComputePulse(input.Period);
  this->Played += input.Period;
  if (this->Played * this->Frequency > LastPeriod)
  {
    this->Height = 0.0;
  }
  pulse = input.MovesTip ? this->Limit(pulse, wall, out, input.Period) : pulse;
  const double least = std::min(wall, input.Least);
  return std::min(std::max(wall + pulse, least), input.Most) * out;
}

} // namespace VolumeHaptics
