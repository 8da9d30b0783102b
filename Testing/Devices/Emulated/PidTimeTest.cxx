// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the timing of samples from a stick that reports only new positions, at most every 8 ms. */

#include "Rigs/ReadTimes.h"
#include "StickRig.h"

#include <cerrno>

using namespace emulated;
using devicetest::ReadTimes;

namespace
{
class HangingWheel : public OpenFfboardModel
{
public:
  int Output(const std::uint8_t* report, int size) override
  {
    if (this->Hangs)
    {
      // Time out like the kernel, but sooner: the kernel waits up to 5 s.
      std::this_thread::sleep_for(std::chrono::milliseconds(600));
      return -ETIMEDOUT;
    }
    return OpenFfboardModel::Output(report, size);
  }
  std::atomic<bool> Hangs{ false };
};

class PidTime : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Options.NewtonsPerFullScale = { FfbHandle::FullScale, 0.0 };
    this->Model.ReportPeriod = 8;
    this->Model.OnlySaysNews = true;
    ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
    ReadTimes waiting(*this->Bench.Device);
    this->Move(waiting, 0.1);
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  }
  /// Moves the hand back and forth at 0.5 m/s for `seconds`.
  void Move(ReadTimes& times, double seconds)
  {
    times.Run(seconds,
      [&](double time)
      {
        const double phase = std::fmod(0.5 * time, 0.08);
        this->Model.SetGoal(phase < 0.04 ? phase - 0.02 : 0.06 - phase, 0.0);
      });
  }

  HangingWheel Model;
  EmulatedHid Hid{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  DeviceOptions Options;
  DeviceBench Bench;
};
} // namespace

TEST_F(PidTime, BringsNewsOnceInEightTicksAndIsAsFastAsTheHand)
{
  ReadTimes times(*this->Bench.Device);
  this->Move(times, 2.0);
  // The model's time never runs ahead of the clock, so it reports at most 125 times a second.
  EXPECT_LE(times.Fresh, 125.0 * times.Elapsed + 2.0) << times.Ticks << " ticks";
  EXPECT_GE(times.Fresh, 20);
  EXPECT_GE(times.Timing.GetReportPeriod(), 7.5e-3);
  EXPECT_GE(times.Timing.GetRoundTrip(), 7.5e-3);
  EXPECT_LT(times.LargestSpeed, 2.5)
    << "the hand's spring swings, though not to eight times as fast";
}

TEST_F(PidTime, AtRestShowsThatItIsAliveWithoutNews)
{
  ReadTimes moved(*this->Bench.Device);
  this->Move(moved, 0.5);
  this->Model.SetGoal(0.0, 0.0);
  ReadTimes(*this->Bench.Device).Run(1.0); // until it is at rest
  ReadTimes times(*this->Bench.Device);
  times.Run(2.0);
  EXPECT_LE(times.Fresh, 2) << "of " << times.Ticks << " ticks";
  EXPECT_GT(times.Signs, 20);
  EXPECT_LT(times.LongestSilence, 0.5) << "on a busy machine; else about 10 ms";
}

TEST_F(PidTime, AStickThatReportsAtRestEvery100MsIsNotSilentMeanwhile)
{
  this->Model.OnlySaysNews = false;
  this->Model.SetGoal(0.0, 0.0);
  // s, until the model is at rest and has often repeated its report
  ReadTimes(*this->Bench.Device).Run(4.0);
  ReadTimes times(*this->Bench.Device);
  times.Run(1.0);
  EXPECT_LE(times.Fresh, 12) << "of " << times.Ticks << " ticks";
  EXPECT_GT(times.Signs, 10);
  EXPECT_LT(times.LongestSilence, 0.5) << "on a busy machine; else about 10 ms";
}

TEST_F(PidTime, AStickThatHangsFallsSilent)
{
  ReadTimes times(*this->Bench.Device);
  this->Move(times, 0.2);
  this->Model.Fault = FfbFault::Silence;
  this->Model.Hangs = true;
  EXPECT_TRUE(times.FallsSilent(2.0, 0.05));
  EXPECT_FALSE(times.IsLost && times.LongestSilence < 0.05)
    << "the servo knows before the kernel does";
}
