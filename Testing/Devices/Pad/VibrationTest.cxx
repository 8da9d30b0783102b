// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the levels of a pad's motors for given forces: by the closed forms of the two low-pass
 * filters in Vibration.h, and by the limits of the rates for random forces.
 */

#include "Devices/Pad/Vibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

using namespace VolumeHaptics;

namespace
{
constexpr double Fast = 0.02; // s
constexpr double Slow = 0.15; // s

/**
 * Returns the weak motor's level `time` (s) after a force has stepped from 0 to `step` (N).
 */
double WeakOf(double step, double time)
{
  return std::min(1.0, step * std::exp(-time / Fast));
}
double StrongOf(double step, double time)
{
  return std::min(1.0, step * (std::exp(-time / Slow) - std::exp(-time / Fast)));
}

/**
 * Returns the time (s) at which a level that rises by 100 per second reaches the weak motor's
 * curve.
 */
double MeetingTime(double step)
{
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (100.0 * middle < WeakOf(step, middle) ? low : high) = middle;
  }
  return low;
}
} // namespace

TEST(Vibration, AStepHasItsClosedForm)
{
  for (const double step : { 0.05, 0.3, 1.0 })
  {
    // Sample the levels with ticks (s) of different lengths.
    for (const double tick : { 1e-4, 1e-3, 2e-3 })
    {
      Vibration vibration;
      const Vector3 force = step * Vector3{ 0.6, 0.0, -0.8 };
      double largest = 0.0;
      double weakBefore = 0.0;
      for (int i = 1; i * tick < 1.0; ++i)
      {
        const double time = i * tick;
        const VibrationLevels levels = vibration.Advance(force, tick);
        largest = std::max(largest, levels.Weak);
        ASSERT_NEAR(levels.Strong, StrongOf(step, time), 1e-12) << step << " N, " << time << " s";
        // The weak level rises by 100 per second until it reaches its curve, and falls by at most
        // 10 per second.
        const double expected = time < MeetingTime(step)
          ? 100.0 * time
          : std::max(WeakOf(step, time), weakBefore - 10.0 * tick);
        ASSERT_NEAR(levels.Weak, expected, 100.0 * tick * tick / Fast + 1e-12)
          << step << ", " << time;
        weakBefore = levels.Weak;
      }
      EXPECT_NEAR(largest, 100.0 * MeetingTime(step), 100.0 * tick);
      EXPECT_EQ(Vibration::Quantize(weakBefore, 255), 0) << "at rest";
    }
  }
}

TEST(Vibration, TheHeadersExampleHolds)
{
  Vibration vibration;
  double weak = 0.0;
  double weakAt = 0.0;
  double strong = 0.0;
  double strongAt = 0.0;
  for (int i = 1; i < 10000; ++i)
  {
    const VibrationLevels levels = vibration.Advance({ 1.0, 0.0, 0.0 }, 1e-5);
    weakAt = levels.Weak > weak ? i * 1e-5 : weakAt;
    weak = std::max(weak, levels.Weak);
    strongAt = levels.Strong > strong ? i * 1e-5 : strongAt;
    strong = std::max(strong, levels.Strong);
  }
  EXPECT_NEAR(weak, 0.70, 0.005);
  EXPECT_NEAR(weakAt, 0.007, 0.0005);
  EXPECT_NEAR(strong, 0.64, 0.005);
  EXPECT_NEAR(strongAt, 0.046, 0.001);
}

TEST(Vibration, ASteadyGrowthHasItsLevels)
{
  const double rate = 5.0; // N/s
  Vibration vibration;
  VibrationLevels levels;
  const double tick = 1e-5;
  for (int i = 0; i < 200000; ++i)
  {
    levels = vibration.Advance({ 0.0, rate * tick * i, 0.0 }, tick);
  }
  EXPECT_NEAR(levels.Weak, rate * Fast, 1e-3);
  EXPECT_NEAR(levels.Strong, rate * (Slow - Fast), 1e-3);
}

TEST(Vibration, AForceThatStaysIsNotFelt)
{
  Vibration vibration;
  const Vector3 force{ 1.0, -2.0, 3.0 };
  VibrationLevels levels;
  for (int i = 0; i < 20000; ++i)
  {
    levels = vibration.Advance(force, 1e-3);
  }
  EXPECT_NEAR(levels.Weak, 0.0, 1e-12);
  EXPECT_NEAR(levels.Strong, 0.0, 1e-12);
  for (int i = 0; i < 1000; ++i)
  {
    levels = vibration.Advance(force, 1e-3);
    EXPECT_EQ(Vibration::Quantize(levels.Weak, 255) + Vibration::Quantize(levels.Strong, 255), 0);
  }
}

TEST(Vibration, TheLimitsOfTheRatesHoldOverRandomForces)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const double infinite = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < 200; ++trial)
  {
    Vibration vibration;
    VibrationLevels before;
    const double most = std::pow(10.0, 3.0 * share(random));
    Vector3 force;
    for (int i = 0; i < 300; ++i)
    {
      const double tick = std::pow(10.0, -3.0 + 2.0 * share(random));
      if (random() % 3 == 0)
      {
        force = most * Vector3{ share(random), share(random), share(random) };
      }
      const VibrationLevels levels = vibration.Advance(force, tick);
      for (const auto& [now, last] : { std::pair<double, double>{ levels.Weak, before.Weak },
             std::pair<double, double>{ levels.Strong, before.Strong } })
      {
        ASSERT_GE(now, 0.0);
        ASSERT_LE(now, 1.0);
        ASSERT_LE(now - last, 100.0 * tick + 1e-12);
        ASSERT_GE(now - last, -10.0 * tick - 1e-12);
      }
      before = levels;
    }
    for (const double bad : { infinite, std::nan("") })
    {
      const VibrationLevels levels = vibration.Advance({ 0.0, bad, 1.0 }, 1e-3);
      EXPECT_EQ(levels.Weak + levels.Strong, 0.0) << "what is no number is silence, at once";
    }
  }
}

TEST(Vibration, WhatMotorsDoNotTurnAtIsNothing)
{
  EXPECT_EQ(Vibration::Quantize(0.0, 255), 0);
  EXPECT_EQ(Vibration::Quantize(0.039, 255), 0);
  EXPECT_EQ(Vibration::Quantize(0.5, 255), 128);
  EXPECT_EQ(Vibration::Quantize(1.0, 255), 255);
  EXPECT_EQ(Vibration::Quantize(7.0, 255), 255);
  EXPECT_EQ(Vibration::Quantize(-1.0, 255), 0);
}
