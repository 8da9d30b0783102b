// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the pulse at touch-down has the specified impulse and frequency, makes walls feel
 * stiffer to a tap, and adds no energy.
 */

#include "Rigs/Taps.h"

#include <gtest/gtest.h>

#include <random>

using namespace rigs;
using namespace VolumeHaptics;

namespace
{
constexpr double Speed = 0.2;        // speed of the approach (m/s)
constexpr double Period = 1e-3;      // s
constexpr double Stiffness = 2000.0; // N/m

SafetyInput MakeInput()
{
  SafetyInput input;
  input.Elapsed = input.Period = input.MotionTime = input.RoundTrip = Period;
  input.Fresh = true;
  input.Stiffness = Stiffness;
  return input;
}

SafetyLimits MakeLimits(double gain, bool movesTip)
{
  SafetyLimits limits;
  limits.MaximumForce = 100.0;
  limits.MaximumForceRate = 1e6;
  limits.RampTime = 0.0;
  limits.MovesTip = movesTip;
  limits.TransientGain = gain;
  return limits;
}

/**
 * Returns the pulse (N) in each tick after the touch. The tip approaches independently of the
 * force, and rests as soon as it has touched. The wall pushes with 50 N, so that no pulse is cut
 * off at zero.
 */
std::vector<double> Play(double frequency, double gain, int ticks)
{
  GatedStage stage;
  stage.Arm();
  SafetyInput input = MakeInput();
  const SafetyLimits limits = MakeLimits(gain, false);
  for (int i = 30; i > 0; --i)
  {
    input.Tip.Z = Speed * Period * i;
    stage.Apply(input, limits);
  }
  input.Tip.Z = 0.0;
  input.Force.Z = 50.0;
  input.Frequency = frequency;
  std::vector<double> pulses;
  for (int i = 0; i < ticks; ++i)
  {
    pulses.push_back(stage.Apply(input, limits).Z - 50.0);
  }
  return pulses;
}

double Sum(const std::vector<double>& values, int from, int to)
{
  double sum = 0.0;
  for (int i = from; i < to; ++i)
  {
    sum += values[static_cast<std::size_t>(i)];
  }
  return sum;
}
} // namespace

TEST(ContactTransient, StopsAnArmInItsFirstHalfWaveAndDecays)
{
  // At 100 Hz, a half wave takes five ticks. Each half wave is smaller than the previous one by the
  // factor exp(-1/2).
  const std::vector<double> pulses = Play(100.0, 1.0, 40);
  const double momentum = ContactTransient::TouchMass * Speed;
  const double first = Period * Sum(pulses, 0, 5);
  EXPECT_NEAR(first, momentum, 1e-9 * momentum);
  for (int wave = 1; wave < 8; ++wave)
  {
    const double expected = momentum * std::pow(-std::exp(-0.5), wave);
    EXPECT_NEAR(Period * Sum(pulses, 5 * wave, 5 * wave + 5), expected, 1e-9 * momentum) << wave;
  }
  EXPECT_NEAR(Period * Sum(Play(100.0, 0.5, 5), 0, 5), 0.5 * momentum, 1e-9 * momentum);
}

TEST(ContactTransient, TellsMaterialsOfOneStiffnessApart)
{
  // A wall of 400 N/m gives a pulse of 120 Hz if it holds 1 N, and of 240 Hz if it holds 4 N.
  EXPECT_NEAR(ContactTransient::ComputeFrequency(400.0, 1.0), 120.0, 1e-9);
  EXPECT_NEAR(ContactTransient::ComputeFrequency(400.0, 4.0), 240.0, 1e-9);
  EXPECT_EQ(ContactTransient::ComputeFrequency(400.0, 0.0), 0.0);
  EXPECT_EQ(ContactTransient::ComputeFrequency(6000.0, 1e9), 300.0);
  for (const double frequency : { 120.0, 240.0 })
  {
    const std::vector<double> pulses = Play(frequency, 1.0, 25);
    // Find the frequency (Hz) with the most power in the sent force, by Fourier's integral.
    double best = 0.0;
    double most = 0.0;
    for (double f = 60.0; f < 400.0; f += 1.0)
    {
      double real = 0.0;
      double imaginary = 0.0;
      for (std::size_t i = 0; i < pulses.size(); ++i)
      {
        const double angle = 6.283185307179586 * f * Period * (static_cast<double>(i) + 0.5);
        real += pulses[i] * std::cos(angle);
        imaginary += pulses[i] * std::sin(angle);
      }
      const double power = real * real + imaginary * imaginary;
      best = power > most ? f : best;
      most = std::max(most, power);
    }
    EXPECT_NEAR(best, frequency, 0.08 * frequency) << "a decaying wave has a broad peak";
  }
}

TEST(ContactTransient, MakesWallsStifferAndReturnsLess)
{
  for (const StiffArm& arm : { StiffArm::FalconLike(), StiffArm::TouchLike() })
  {
    for (const double speed : { 0.05, 0.1, 0.3 })
    {
      for (const double frequency : { 100.0, 147.0, 300.0 })
      {
        for (int phase = 0; phase < 5; ++phase)
        {
          SCOPED_TRACE(std::string(arm.Name) + ", " + std::to_string(speed) + " m/s, " +
            std::to_string(frequency) + " Hz, " + std::to_string(phase));
          Tap tap{ speed, arm.Sampled(), frequency, 0.0, 0.2 * phase, true };
          const TapResult plain = TapOnce(arm, tap);
          tap.Gain = 0.5;
          const TapResult half = TapOnce(arm, tap);
          EXPECT_GT(half.Effective, 1.5 * plain.Effective);
          EXPECT_LE(half.Returned, plain.Returned + 1e-9) << "a friction that creeps";
          EXPECT_LE(half.MostGiven, plain.MostGiven);
        }
      }
    }
  }
}

TEST(ContactTransient, GivesNoMoreThanItTakesToAHandThatLeadsTheTip)
{
  // Follow the same path with and without the pulse. The work of the pulse is the difference
  // between the works on both paths.
  double most = 0.0;
  double least = 0.0;
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    std::mt19937 engine(seed);
    const auto pick = [&engine](double a, double b) { return a + (b - a) * (engine() * 0x1p-32); };
    const double depth = pick(2e-4, 4e-3);
    const double beat = 6.283185307179586 * pick(1.0, 8.0);
    const double frequency = pick(50.0, 300.0);
    GatedStage stage[2];
    stage[0].Arm();
    stage[1].Arm();
    const SafetyLimits limits[2] = { MakeLimits(0.0, true), MakeLimits(pick(0.2, 1.0), true) };
    SafetyInput input = MakeInput();
    double given = 0.0;
    double pulse = 0.0;
    for (int i = 0; i < 1000; ++i)
    {
      const double before = input.Tip.Z;
      input.Tip.Z = depth * (std::cos(beat * Period * i) + 0.2);
      given += i > 0 ? pulse * (input.Tip.Z - before) : 0.0;
      most = std::max(most, given);
      least = std::min(least, given);
      input.Stretch = std::max(0.0, -input.Tip.Z);
      input.Force.Z = Stiffness * input.Stretch;
      input.Frequency = input.Force.Z > 0.0 ? frequency : 0.0;
      const double plain = stage[0].Apply(input, limits[0]).Z;
      pulse = stage[1].Apply(input, limits[1]).Z - plain;
    }
  }
  EXPECT_LE(most, 1e-6) << "J";
  EXPECT_LT(least, -1e-4) << "pulses brake";
}
