// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Compares the contact sound with the closed forms in the class comment of ContactSound: a damped
/// oscillation (A. P. French, Vibrations and Waves, 1971, chapter 4: its spectrum is largest at
/// sqrt(w^2 - a^2)), and white noise behind band-passes, integrated numerically. Spectra are sums
/// by the definition of the Fourier transform.

#include "Applications/Explorer/Sound/ContactSound.h"
#include "Spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace soundtest;
using Explore::ContactSound;
using Explore::SoundTick;
using Explore::SurfaceContact;

namespace
{

constexpr double FAT_STRENGTH = 1.0; // N; strengths as in the preset "CT contrast"
constexpr double MUSCLE_STRENGTH = 2.2;
constexpr double BONE_STRENGTH = 12.0;
constexpr double STIFFNESS = 400.0;

/** Plays a hand's contact in ticks of 1 ms, and records the resulting sound. */
struct Hand
{
  SoundTick Tick;
  ContactSound Sound{ RATE };
  std::vector<float> Heard;

  explicit Hand(double strength = FAT_STRENGTH, double stiffness = STIFFNESS)
  {
    this->Tick.Strength = strength;
    this->Tick.Stiffness = stiffness;
  }
  void Do(double seconds)
  {
    const auto ticks = static_cast<int>(std::lround(1000.0 * seconds));
    for (int i = 0; i < ticks; ++i)
    {
      this->Tick.Time += 0.001;
      this->Sound.Feed(this->Tick);
      this->Heard.resize(this->Heard.size() + 48);
      this->Sound.Render(this->Heard.data() + this->Heard.size() - 48, 48);
    }
  }
  void Leave(double seconds)
  {
    this->Tick.Contact = SurfaceContact::Free;
    this->Tick.NormalForce = this->Tick.FrictionForce = this->Tick.Speed = 0.0;
    this->Do(seconds);
  }
  void Touch(double newtons, double seconds)
  {
    this->Tick.Contact = SurfaceContact::Sticking;
    this->Tick.NormalForce = newtons;
    this->Do(seconds);
  }
  void Slide(double watts, double seconds)
  {
    this->Tick.Contact = SurfaceContact::Sliding;
    this->Tick.FrictionForce = 0.4;
    this->Tick.Speed = watts / 0.4;
    this->Do(seconds);
  }
  /** Returns the recorded samples from a time (s) onwards. */
  std::vector<float> Since(double seconds) const
  {
    return { this->Heard.begin() + static_cast<std::ptrdiff_t>(seconds * RATE), this->Heard.end() };
  }
  double Peak(double since) const
  {
    double peak = 0.0;
    for (const float y : this->Since(since))
    {
      peak = std::max(peak, std::abs(static_cast<double>(y)));
    }
    return peak;
  }
  double LargestJump(double since) const
  {
    const std::vector<float> y = this->Since(since);
    double jump = 0.0;
    for (std::size_t i = 1; i < y.size(); ++i)
    {
      jump = std::max(jump, std::abs(static_cast<double>(y[i]) - y[i - 1]));
    }
    return jump;
  }
  bool IsSilent(double since) const
  {
    const std::vector<float> y = this->Since(since);
    return !y.empty() && std::all_of(y.begin(), y.end(), [](float x) { return x == 0.0f; });
  }
};

/** Returns the sound of a single first touch, starting at the impact (5 ms after the touch). */
std::vector<float> Click(double strength, double stiffness, double newtons)
{
  Hand hand(strength, stiffness);
  hand.Leave(0.1);
  hand.Touch(newtons, 0.3);
  const std::vector<float> y = hand.Since(0.1);
  const auto begin = std::find_if(y.begin(), y.end(), [](float x) { return x != 0.0f; });
  return { begin, y.end() };
}

} // namespace

TEST(ContactSound, HasThePitchOfTheMaterial)
{
  EXPECT_NEAR(ContactSound::ComputePitch(400.0, 1.0), 500.0, 1e-9);
  EXPECT_NEAR(ContactSound::ComputePitch(400.0, 4.0), 1000.0, 1e-9);
  EXPECT_NEAR(ContactSound::ComputePitch(6400.0, 1.0), 1000.0, 1e-9);
  EXPECT_NEAR(ContactSound::ComputePitch(25.0, 9.0), 750.0, 1e-9);
  EXPECT_EQ(ContactSound::ComputePitch(400.0, 1e6), ContactSound::ComputePitch(400.0, 12.0));
  EXPECT_EQ(ContactSound::ComputePitch(0.0, 0.0), 60.0);
  EXPECT_EQ(ContactSound::ComputePitch(1e9, 12.0), 6000.0);
}

TEST(ContactSound, RingsAtThePitch)
{
  for (const double strength : { FAT_STRENGTH, MUSCLE_STRENGTH, 3.2, BONE_STRENGTH })
  {
    const double pitch = 500.0 * std::sqrt(strength);
    const double decay = 1.0 / 0.015;
    const double expected = std::sqrt(pitch * pitch - std::pow(decay / (2.0 * PI), 2));
    const double peak =
      FindPeak(Click(strength, STIFFNESS, 0.02), 0.8 * pitch, 1.25 * pitch, 0.001 * pitch);
    EXPECT_NEAR(peak, expected, 0.01 * expected) << strength << " N";
    EXPECT_NEAR(peak, pitch, 0.01 * pitch) << strength << " N";
  }
}

TEST(ContactSound, DecaysAsItSays)
{
  const std::vector<float> y = Click(FAT_STRENGTH, STIFFNESS, 0.02);
  // A period is 96 samples. Compare the RMS values of two periods that are 14 periods apart.
  const auto effective = [&y](std::size_t first)
  {
    double sum = 0.0;
    for (std::size_t i = first; i < first + 96; ++i)
    {
      sum += static_cast<double>(y[i]) * y[i];
    }
    return std::sqrt(sum);
  };
  EXPECT_NEAR(effective(14 * 96) / effective(0), std::exp(-14 * 0.002 / 0.015), 0.005);
}

TEST(ContactSound, IsLouderTheHarderTheTouch)
{
  const double omega = 2.0 * PI * 500.0;
  const double decay = 1.0 / 0.015;
  const double first = std::atan(omega / decay) / omega; // s, time of the first maximum
  for (const double newtons : { 0.01, 0.1, 1.0 })
  {
    const std::vector<float> y = Click(FAT_STRENGTH, STIFFNESS, newtons);
    const double x =
      0.6 * newtons / (newtons + 0.1) * std::exp(-decay * first) * std::sin(omega * first);
    EXPECT_NEAR(*std::max_element(y.begin(), y.end()), 0.9 * std::tanh(x / 0.9), 0.01 * x);
  }
}

TEST(ContactSound, HasTheLoudnessOfTheFrictionPower)
{
  for (const double watts : { 0.0005, 0.002, 0.02 })
  {
    Hand hand;
    hand.Slide(watts, 6.0);
    double sum = 0.0;
    const std::vector<float> y = hand.Since(1.0);
    for (const float value : y)
    {
      const double x = 0.9 * std::atanh(static_cast<double>(value) / 0.9);
      sum += x * x;
    }
    const double power = watts - 1e-6;
    const double expected = 0.15 * std::sqrt(power / (power + 0.02));
    // 5 s of noise in a band of about 400 Hz contain about 4000 independent values.
    EXPECT_NEAR(std::sqrt(sum / static_cast<double>(y.size())), expected, 0.05 * expected);
  }
}

TEST(ContactSound, HasTheBandOfTheMaterial)
{
  const auto share = [](double from, double to)
  {
    double part = 0.0;
    double all = 0.0;
    const double step = 0.001;
    for (double x = 0.5 * step; x < 8.0; x += step)
    {
      const double power = std::pow(1.0 + std::pow(x - 1.0 / x, 2), -2);
      all += power;
      part += x >= from && x < to ? power : 0.0;
    }
    return part / all;
  };
  const double pitch = 500.0 * std::sqrt(MUSCLE_STRENGTH);
  Hand hand(MUSCLE_STRENGTH);
  hand.Slide(0.002, 4.0);
  const std::vector<float> y = hand.Since(1.0);
  const double all = BandEnergy(y, 4096, 20.0, 8.0 * pitch);
  for (const double x : { 0.25, 0.5, 1.0, 2.0 })
  {
    EXPECT_NEAR(BandEnergy(y, 4096, x * pitch, 2.0 * x * pitch) / all, share(x, 2.0 * x), 0.03)
      << x << " of the pitch";
  }
}

TEST(ContactSound, TellsSkinMuscleAndBoneApart)
{
  std::vector<double> noises;
  std::vector<double> clicks;
  for (const double strength : { FAT_STRENGTH, MUSCLE_STRENGTH, BONE_STRENGTH })
  {
    Hand hand(strength);
    hand.Slide(0.005, 1.7);
    noises.push_back(Centroid(hand.Since(1.0), 4096));
    std::vector<float> click = Click(strength, STIFFNESS, 0.1);
    click.resize(4096);
    clicks.push_back(Centroid(click, 4096));
  }
  const double third = std::cbrt(2.0); // a third of an octave
  for (const std::vector<double>& centroids : { noises, clicks })
  {
    EXPECT_GT(centroids[1], third * centroids[0]);
    EXPECT_GT(centroids[2], third * centroids[1]);
  }
}

TEST(ContactSound, IsSilentInTheAirAndAtRest)
{
  Hand hand;
  hand.Tick.Speed = 0.5;
  hand.Do(1.0);
  EXPECT_TRUE(hand.IsSilent(0.0)) << "in the air";
  hand.Slide(0.02, 0.5);
  EXPECT_FALSE(hand.IsSilent(1.1));
  hand.Tick.Speed = 0.0;
  hand.Tick.Contact = SurfaceContact::Sticking;
  hand.Do(2.0);
  EXPECT_TRUE(hand.IsSilent(2.5)) << "at rest";
  hand.Slide(1e-6, 1.0);
  EXPECT_TRUE(hand.IsSilent(3.5)) << "creeping";
}

TEST(ContactSound, ClicksOnlyAtATouchFromTheAir)
{
  Hand hand;
  hand.Touch(1.0, 0.3);
  EXPECT_TRUE(hand.IsSilent(0.0)) << "it was not in the air before";
  hand.Leave(0.03);
  hand.Touch(1.0, 0.3);
  EXPECT_TRUE(hand.IsSilent(0.0)) << "not long enough";
  hand.Leave(0.06);
  hand.Touch(1.0, 0.02);
  EXPECT_GT(hand.Peak(0.69), 0.3);
  hand.Do(1.0);
  EXPECT_TRUE(hand.IsSilent(1.2)) << "once";
}

TEST(ContactSound, ClicksWhereASurfaceIsPierced)
{
  const auto press = [](SurfaceContact contact, double fall)
  {
    Hand hand;
    for (double newtons = 2.0; newtons > 0.0; newtons -= 0.002 / fall)
    {
      hand.Tick.Contact = contact;
      hand.Tick.NormalForce = newtons;
      hand.Do(0.001);
    }
    hand.Leave(1.0);
    return hand;
  };
  EXPECT_GT(press(SurfaceContact::Penetrating, 0.02).Peak(0.0), 0.5);
  EXPECT_TRUE(press(SurfaceContact::Sticking, 0.02).IsSilent(0.0)) << "withdrawn";
  EXPECT_TRUE(press(SurfaceContact::Sliding, 0.02).IsSilent(0.0)) << "withdrawn";
  EXPECT_TRUE(press(SurfaceContact::Penetrating, 0.02).IsSilent(0.8));
  // The force falls by 1 N/s. Its peak decays with a time constant of 50 ms and stays about 0.05 N
  // above the force, which therefore falls below half of the peak only at about 0.05 N.
  EXPECT_LT(press(SurfaceContact::Penetrating, 2.0).Peak(0.0), 0.3) << "gives way slowly";
}

TEST(ContactSound, NeverExceedsItsBound)
{
  std::mt19937 random(22);
  std::uniform_real_distribution<double> size(-12.0, 12.0);
  std::uniform_int_distribution<int> kind(0, 3);
  std::uniform_int_distribution<int> rarely(0, 99);
  const auto number = [&]
  {
    switch (rarely(random))
    {
      case 0:
        return std::numeric_limits<double>::quiet_NaN();
      case 1:
        return std::numeric_limits<double>::infinity();
      case 2:
        return -1.0;
      default:
        return std::exp(size(random));
    }
  };
  Hand hand;
  for (int i = 0; i < 20000; ++i)
  {
    hand.Tick.NormalForce = number();
    hand.Tick.FrictionForce = number();
    hand.Tick.Speed = number();
    hand.Tick.Stiffness = number();
    hand.Tick.Strength = number();
    hand.Tick.Contact =
      rarely(random) < 60 ? SurfaceContact::Free : static_cast<SurfaceContact>(kind(random));
    hand.Do(0.001);
  }
  for (const float y : hand.Heard)
  {
    ASSERT_LE(std::abs(y), 0.9f);
  }
  EXPECT_GT(hand.Peak(0.0), 0.5);
  hand.Leave(2.0);
  EXPECT_TRUE(hand.IsSilent(21.5));
}

TEST(ContactSound, BeginsAndEndsWithoutACrack)
{
  // The largest step is the slope of 0.6 sin(2 pi f t), with f the highest pitch of a preset.
  const double pitch = 500.0 * std::sqrt(BONE_STRENGTH);
  Hand click(BONE_STRENGTH);
  click.Leave(0.1);
  click.Touch(100.0, 0.5);
  EXPECT_GT(click.Peak(0.0), 0.4);
  EXPECT_LE(click.LargestJump(0.0), 0.6 * 2.0 * PI * pitch / RATE);

  Hand noise(BONE_STRENGTH);
  noise.Slide(1.0, 3.0);
  const double steady = noise.LargestJump(0.5);
  noise.Leave(0.5);
  EXPECT_GT(steady, 0.0);
  // The noise stays below six times its RMS value, and the RMS value changes by at most 1 in 240
  // samples.
  EXPECT_LE(noise.LargestJump(0.0), steady + 6.0 / 240.0);
}
