// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Expects the same sound whether ticks arrive in bursts, late, too many at once, or not at all.

#include "Applications/Explorer/Sound/SoundStream.h"
#include "Spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

using namespace soundtest;
using Explore::SoundStream;
using Explore::SoundTick;
using Explore::SurfaceContact;

namespace
{

/** Returns a tick of a hand that touches a surface for 20 ms every 200 ms, starting at 0.1 s. */
SoundTick TapAt(int tick)
{
  SoundTick tap;
  tap.Time = 0.001 * tick;
  tap.Stiffness = 400.0;
  tap.Strength = 12.0;
  if (tick % 200 >= 100 && tick % 200 < 120)
  {
    tap.Contact = SurfaceContact::Sticking;
    tap.NormalForce = 1.0;
  }
  return tap;
}

SoundTick SlideAt(int tick)
{
  SoundTick slide = TapAt(tick);
  slide.Contact = SurfaceContact::Sliding;
  slide.FrictionForce = 0.5;
  slide.Speed = 0.1;
  return slide;
}

struct Player
{
  SoundStream Stream{ RATE };
  std::vector<float> Heard;

  void Play(int milliseconds)
  {
    for (int i = 0; i < milliseconds; ++i)
    {
      this->Heard.resize(this->Heard.size() + 48);
      this->Stream.Render(this->Heard.data() + this->Heard.size() - 48, 48);
    }
  }
  /**
   * Returns the times (s) at which clicks begin: at a loud sample after 50 ms without a loud
   * sample.
   */
  std::vector<double> Onsets() const
  {
    std::vector<double> onsets;
    double quietSince = -1.0;
    for (std::size_t i = 0; i < this->Heard.size(); ++i)
    {
      const double time = static_cast<double>(i) / RATE;
      if (std::abs(this->Heard[i]) > 0.1f)
      {
        if (time - quietSince > 0.05)
        {
          onsets.push_back(time);
        }
        quietSince = time;
      }
    }
    return onsets;
  }
  bool IsSilent(double since) const
  {
    return std::all_of(this->Heard.begin() + static_cast<std::ptrdiff_t>(since * RATE),
      this->Heard.end(), [](float x) { return x == 0.0f; });
  }
};

} // namespace

TEST(SoundStream, PlaysBurstsAtThePaceOfTheirTicks)
{
  for (const int burst : { 1, 16, 50, 130 })
  {
    Player player;
    for (int first = 0; first < 3000; first += burst)
    {
      player.Play(burst); // one frame, with its ticks at the end
      for (int i = 0; i < burst && first + i < 3000; ++i)
      {
        player.Stream.Push(TapAt(first + i));
      }
    }
    player.Play(300);
    const std::vector<double> onsets = player.Onsets();
    // The sound begins with the newest tick of the first burst, so that a burst of more than 100
    // ticks skips the first tap.
    ASSERT_EQ(onsets.size(), burst > 100 ? 14u : 15u) << burst;
    for (std::size_t i = 1; i < onsets.size(); ++i)
    {
      EXPECT_NEAR(onsets[i] - onsets[i - 1], 0.2, 0.0025) << burst;
    }
    // Allow one frame until the ticks arrive, one more until they are played, and 5 ms for the
    // impact.
    EXPECT_LE(onsets.back() - (0.001 * 2900 + 0.005), 0.001 * (2 * burst + 4)) << burst;
  }
}

TEST(SoundStream, SkipsWhatIsTooOld)
{
  Player player;
  for (int i = 0; i < 1118; ++i)
  {
    player.Stream.Push(TapAt(i));
  }
  player.Play(200);
  for (int i = 1118; i < 1118 + 300; ++i)
  {
    player.Stream.Push(TapAt(i));
    player.Play(1);
  }
  const std::vector<double> onsets = player.Onsets();
  ASSERT_EQ(onsets.size(), 1u) << "none of those that were skipped";
  EXPECT_NEAR(onsets[0], 0.2 + 0.001 * (1300 - 1118) + 0.005, 0.003);
}

TEST(SoundStream, CatchesUpWithoutSkipping)
{
  Player player;
  int next = 0;
  const auto push = [&](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      player.Stream.Push(TapAt(next++));
    }
  };
  push(100);
  player.Play(1);
  push(250); // a long frame
  for (int i = 0; i < 15000; ++i)
  {
    push(1);
    player.Play(1);
  }
  const std::vector<double> onsets = player.Onsets();
  // At first, 350 ticks are waiting, so a tap at tick n is heard at n - 350 ms or later.
  const double last = 0.001 * (15300 - 350) + 0.005;
  EXPECT_NEAR(onsets.back(), last, 0.03);
  for (std::size_t i = 1; i < onsets.size(); ++i)
  {
    EXPECT_NEAR(onsets[i] - onsets[i - 1], 0.2, 0.2 - 0.2 / 1.05 + 0.002);
  }
}

TEST(SoundStream, FallsSilentIfNoTicksCome)
{
  Player player;
  for (int i = 0; i < 500; ++i)
  {
    player.Stream.Push(SlideAt(i));
    player.Play(1);
  }
  EXPECT_FALSE(player.IsSilent(0.45));
  player.Play(1500);
  EXPECT_TRUE(player.IsSilent(1.5));
  player.Play(500);
  EXPECT_TRUE(player.IsSilent(1.5));
}

TEST(SoundStream, IsSilentBeforeTheFirstTick)
{
  Player player;
  player.Play(100);
  EXPECT_TRUE(player.IsSilent(0.0));
}

TEST(SoundStream, GoesOnWhenTheTimesBeginAnew)
{
  Player player;
  for (const int ticks : { 1050, 1050 })
  {
    for (int i = 0; i < ticks; ++i)
    {
      player.Stream.Push(TapAt(i));
      player.Play(1);
    }
  }
  EXPECT_EQ(player.Onsets().size(), 10u);
}

TEST(SoundStream, IsMutedAndComesBackWithoutACrack)
{
  Player sound;
  Player muted;
  const auto play = [&](int from, int to)
  {
    for (int i = from; i < to; ++i)
    {
      sound.Stream.Push(SlideAt(i));
      muted.Stream.Push(SlideAt(i));
      sound.Play(1);
      muted.Play(1);
    }
  };
  play(0, 1000);
  muted.Stream.SetMuted(true);
  play(1000, 2000);
  muted.Stream.SetMuted(false);
  play(2000, 3000);
  for (std::size_t i = 1; i < sound.Heard.size(); ++i)
  {
    // Both sounds consist of the same noise. The gain of the muted sound changes by 1 in 480
    // samples.
    const double jump = std::abs(static_cast<double>(sound.Heard[i]) - sound.Heard[i - 1]);
    ASSERT_LE(std::abs(static_cast<double>(muted.Heard[i]) - muted.Heard[i - 1]),
      jump + 0.9 / 480.0 + 1e-6);
  }
  const auto at = [](double seconds) { return static_cast<std::ptrdiff_t>(seconds * RATE); };
  EXPECT_TRUE(std::all_of(muted.Heard.begin() + at(1.011), muted.Heard.begin() + at(2.0),
    [](float x) { return x == 0.0f; }));
  EXPECT_TRUE(std::equal(
    muted.Heard.begin() + at(2.011), muted.Heard.end(), sound.Heard.begin() + at(2.011)));
}

TEST(SoundStream, ServesTwoThreads)
{
  SoundStream stream(RATE);
  std::atomic<bool> ends{ false };
  std::thread feeder(
    [&]
    {
      for (int i = 0; i < 20000; ++i)
      {
        stream.Push(SlideAt(i));
        if (i % 1000 == 0)
        {
          stream.SetMuted(i % 2000 == 0);
          std::this_thread::yield();
        }
      }
      ends = true;
    });
  std::vector<float> samples(480);
  float peak = 0.0f;
  while (!ends)
  {
    stream.Render(samples.data(), samples.size());
    for (const float y : samples)
    {
      peak = std::max(peak, std::abs(y));
    }
  }
  feeder.join();
  EXPECT_LE(peak, 0.9f);
}
