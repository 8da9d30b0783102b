// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests times by the device's clock: report periods, round trips and speeds are computed from the
 * samples' own times, on simulated devices with known times. Also tests springs whose stiffness is
 * capped according to these times.
 *
 * The closed loop is a mass with friction. It is integrated exactly under a force that is constant
 * during a tick (SampledLoop.h). The theory of sampled data predicts where the loop is unstable,
 * independently of LoopTiming.
 */

#include "Core/Servo/LoopTiming.h"
#include "Devices/Virtual/VirtualDevice.h"
#include "Rigs/GatedStage.h"
#include "SampledLoop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <random>

using namespace VolumeHaptics;
using servotest::Damping;
using servotest::Mass;

namespace
{
constexpr std::int64_t Millisecond = 1000000; // ns
constexpr std::int64_t Begin = 5000 * Millisecond;

DeviceSample MakeSample(std::int64_t time, const Vector3& tip = {})
{
  DeviceSample sample;
  sample.Fresh = true;
  sample.Time = time;
  sample.Tip = tip;
  return sample;
}

/// Returns a sample of a device that is alive but has no new position.
DeviceSample MakeSign()
{
  DeviceSample sample;
  sample.Alive = true;
  return sample;
}

/**
 * A device in a loop of 1 kHz that measures every `Every` ticks, and applies a force `Delay` ticks
 * after it was written.
 */
class LateDevice
{
public:
  LateDevice(int every, int delay)
    : Every(every)
    , Forces(static_cast<std::size_t>(delay))
    , Delay(delay)
  {
  }
  /// Lets the tip swing on a spring of stiffness k (N/m). Returns the factor by which the amplitude
  /// grows in 10 s.
  double Swing(double k)
  {
    double first = 0.0;
    double last = 0.0;
    this->X = 1e-3;
    this->V = 0.0;
    constexpr int ticks = 10000;
    for (int i = 0; i < ticks; ++i)
    {
      this->Tick(k);
      double& swing = i < ticks / 2 ? first : last;
      swing = i < 500 || i >= ticks - 500 ? std::max(swing, std::abs(this->X)) : swing;
    }
    return last / first;
  }
  double GetRoundTrip() const { return this->Timing.GetRoundTrip(); }
  double GetReportPeriod() const { return this->Timing.GetReportPeriod(); }

private:
  void Tick(double k)
  {
    const std::int64_t now = Begin + this->Ticks * Millisecond;
    DeviceSample sample = MakeSample(this->Measured, { this->Place, 0.0, 0.0 });
    sample.Fresh = this->Ticks % this->Every == 0;
    if (sample.Fresh)
    {
      this->Measured = sample.Time = now;
      this->Place = sample.Tip.X = this->X;
    }
    this->Timing.RecordSample(sample, now);
    this->Forces.push_back({ -k * this->Place, this->Measured });
    const auto [force, of] = this->Forces.front();
    this->Forces.pop_front();
    if (of != 0)
    {
      this->Timing.RecordTaken({ of, now });
    }
    constexpr double h = servotest::Period;
    const double e = std::exp(-Damping * h / Mass);
    const double drift = (1.0 - e) * Mass / Damping;
    this->X += drift * this->V + (h - drift) / Damping * force;
    this->V = e * this->V + (1.0 - e) / Damping * force;
    ++this->Ticks;
  }
  struct Given
  {
    double Force = 0.0;
    std::int64_t Of = 0;
  };
  const int Every;
  std::deque<Given> Forces;
  const int Delay;
  LoopTiming Timing{ 0.0 };
  std::int64_t Ticks = 0;
  std::int64_t Measured = 0;
  double Place = 0.0;
  double X = 0.0;
  double V = 0.0;
};

/// A safety stage that receives its timing from LoopTiming, as in the loop.
class TimedStage
{
public:
  explicit TimedStage(double leastMotion)
    : Timing(leastMotion)
  {
    this->Limits.MaximumForce = 4.0;
    this->Limits.MaximumSpeed = 2.5;
    this->Stage.Arm();
  }
  void Tick(const DeviceSample& sample)
  {
    this->Now += Millisecond;
    this->Input.Tip = sample.Fresh ? sample.Tip : this->Input.Tip;
    this->Input.Elapsed = this->Input.Period;
    this->Input.Fresh = sample.Fresh;
    this->Input.Alive = sample.Alive;
    this->Input.MotionTime = this->Timing.RecordSample(sample, this->Now);
    this->Stage.Apply(this->Input, this->Limits);
  }
  GateReason GetFault() const { return this->Stage.Gate.GetFault(); }

  LoopTiming Timing;
  rigs::GatedStage Stage;
  SafetyLimits Limits;
  SafetyInput Input;
  std::int64_t Now = Begin;
};
} // namespace

TEST(LoopTiming, KnowsNothingAtFirst)
{
  LoopTiming timing(0.0);
  EXPECT_EQ(timing.GetReportPeriod(), 0.0);
  EXPECT_EQ(timing.GetRoundTrip(), 0.0);
  EXPECT_EQ(timing.RecordSample(MakeSample(Begin), Begin), 0.0);
  EXPECT_EQ(timing.RecordSample(MakeSample(Begin + Millisecond), Begin), 1e-3);
  EXPECT_EQ(timing.RecordSample({}, Begin), 0.0);
  timing.RecordTaken({ -1, 0 });
  EXPECT_EQ(timing.GetRoundTrip(), 0.0);
}

TEST(LoopTiming, ADelayCountsTwice)
{
  for (const int every : { 1, 2, 8 })
  {
    for (const int delay : { 0, 1, 3 })
    {
      LateDevice device(every, delay);
      device.Swing(1.0);
      EXPECT_NEAR(device.GetReportPeriod(), 1e-3 * every, 1e-12);
      EXPECT_NEAR(device.GetRoundTrip(), 1e-3 * (every + 2 * delay), 1e-12)
        << every << ", " << delay;
    }
  }
}

TEST(LoopTiming, WhatItCapsIsWhatTheTheoryOfSampledDataAllows)
{
  for (const int delay : { 0, 1, 2, 4 })
  {
    LateDevice device(1, delay);
    device.Swing(1.0);
    const double cap = 2.0 * Damping / device.GetRoundTrip();
    const double limit = servotest::ComputeLimit(delay);
    EXPECT_LE(cap, limit) << "delay " << delay;
    EXPECT_GE(cap, 0.9 * limit) << "delay " << delay;
  }
}

TEST(LoopTiming, ASpringCappedByTheMeasuredRoundTripIsPassiveAndByTheServosPeriodIsNot)
{
  for (const int every : { 1, 2, 4, 8 })
  {
    for (const int delay : { 0, 1, 3 })
    {
      if (every == 1 && delay == 0)
      {
        continue; // here the round trip is only the servo's period
      }
      DeviceLimits limits;
      limits.Damping = Damping;
      LateDevice device(every, delay);
      device.Swing(1.0);
      const double cap = CapsOf(limits, device.GetRoundTrip()).Stiffness;
      EXPECT_LE(LateDevice(every, delay).Swing(cap), 1.0)
        << cap << " N/m, every " << every << " ms, " << delay << " ms late";
      const double servo = CapsOf(limits, servotest::Period).Stiffness;
      EXPECT_GT(LateDevice(every, delay).Swing(servo), 10.0)
        << servo << " N/m, every " << every << " ms, " << delay << " ms late";
    }
  }
}

TEST(LoopTiming, TheVirtualDeviceHasTheTimesThatItSimulates)
{
  for (const int delay : { 0, 1, 5, 16 })
  {
    VirtualDevice device;
    std::string error;
    ASSERT_TRUE(device.Open(error));
    device.SetDynamics({ 0.0, 0.0, 0.0, 0.0, delay, 2.0 });
    device.Lead({});
    LoopTiming timing(device.GetLimits().LeastMotion);
    for (int i = 0; i < 400; ++i)
    {
      DeviceSample sample;
      device.Read(1e-3, sample);
      timing.RecordSample(sample, sample.Time);
      device.Write({});
      timing.RecordTaken(sample.Taken);
    }
    EXPECT_NEAR(timing.GetReportPeriod(), 1e-3, 1e-12);
    EXPECT_NEAR(timing.GetRoundTrip(), 1e-3 * (1 + 2 * delay), 1e-12);
  }
}

TEST(LoopTiming, RestsOfASilentStickTellNoPeriodAndDoNotAge)
{
  constexpr double least = 1e-6;
  LoopTiming timing(least);
  std::int64_t now = Begin;
  double tip = 0.0;
  // While the device moves, it reports its position every 8 ms. While it rests, a sample without a
  // position shows every 10 ms that it is connected.
  for (int i = 0; i < 40; ++i)
  {
    for (int ms = 0; ms < 400; ++ms, now += Millisecond)
    {
      DeviceSample sample;
      if (ms % 8 == 0)
      {
        tip += 4e-3;
        sample = MakeSample(now, { tip, 0.0, 0.0 });
      }
      const double way = timing.RecordSample(sample, now);
      // After a rest, the motion may have begun up to one report period before the last sign of
      // life.
      EXPECT_TRUE(way == 0.0 || (way > 7.999e-3 && way < 18.001e-3)) << way;
      EXPECT_TRUE(way == 0.0 || ms == 0 || way < 8.001e-3) << way;
      timing.RecordTaken({ now - ms % 8 * Millisecond, now });
    }
    for (int ms = 0; ms < 500; ++ms, now += Millisecond)
    {
      timing.RecordSample(ms % 10 == 0 ? MakeSign() : DeviceSample{}, now);
    }
  }
  EXPECT_NEAR(timing.GetReportPeriod(), 8e-3, 1e-12);
  EXPECT_NEAR(timing.GetRoundTrip(), 8e-3, 1e-12);
}

TEST(LoopTiming, StepsOfAStickThatCreepsTellNoPeriod)
{
  constexpr double least = 1e-6;
  LoopTiming timing(least);
  std::int64_t now = Begin;
  double tip = 0.0;
  for (int i = 0; i < 200; ++i, now += 20 * Millisecond)
  {
    tip += least;
    timing.RecordSample(MakeSample(now, { tip, 0.0, 0.0 }), now);
  }
  EXPECT_EQ(timing.GetReportPeriod(), 0.0);
}

TEST(LoopTiming, AStickThatReportsEvery8MsIsAsFastAsItIs)
{
  for (const double speed : { 0.5, 2.4, 2.6, 5.0 })
  {
    TimedStage stage(1e-6);
    for (int ms = 0; ms < 400; ++ms)
    {
      stage.Tick(ms % 8 == 0 ? MakeSample(stage.Now + Millisecond, { 1e-3 * speed * ms, 0.0, 0.0 })
                             : DeviceSample{});
    }
    EXPECT_EQ(stage.GetFault(), speed > 2.5 ? GateReason::OverSpeed : GateReason::None) << speed;
  }
}

TEST(LoopTiming, ReportsThatAreReadLateMakeItNoFaster)
{
  // The reading thread is sometimes delayed: one report is read late, and the next one on time.
  std::mt19937_64 engine(11);
  TimedStage stage(1e-6);
  std::int64_t told = 0;
  for (int ms = 0; ms < 20000; ++ms)
  {
    DeviceSample sample;
    const std::int64_t late =
      ms > 200 && engine() % 4 == 0 ? static_cast<std::int64_t>(engine() % 7) : 0;
    const std::int64_t time = stage.Now + Millisecond;
    if (ms % 8 == 0)
    {
      told = std::max(told + 1, time + late * Millisecond);
      sample = MakeSample(told, { 1e-3 * 1.0 * ms, 0.0, 0.0 });
    }
    stage.Tick(sample);
    ASSERT_EQ(stage.GetFault(), GateReason::None) << ms;
  }
}

TEST(LoopTiming, AStickThatLeapsOutOfARestIsFast)
{
  TimedStage stage(1e-6);
  for (int ms = 0; ms < 400; ++ms)
  {
    stage.Tick(
      ms % 8 == 0 ? MakeSample(stage.Now + Millisecond, { 1e-4 * ms, 0.0, 0.0 }) : DeviceSample{});
  }
  for (int ms = 0; ms < 400; ++ms)
  {
    stage.Tick(ms % 10 == 0 ? MakeSign() : DeviceSample{});
  }
  EXPECT_EQ(stage.GetFault(), GateReason::None);
  EXPECT_FALSE(stage.Stage.IsStale());
  // The tip jumps by 80 mm. No hand moves that far within two report periods.
  stage.Tick(MakeSample(stage.Now + Millisecond, { 0.12, 0.0, 0.0 }));
  EXPECT_EQ(stage.GetFault(), GateReason::OverSpeed);
}

TEST(LoopTiming, ASilentStickIsStaleUnlessItIsSeenAlive)
{
  for (const bool isSeen : { true, false })
  {
    TimedStage stage(1e-6);
    for (int ms = 0; ms < 400; ++ms)
    {
      stage.Tick(ms % 8 == 0 ? MakeSample(stage.Now + Millisecond, { 1e-4 * ms, 0.0, 0.0 })
                             : DeviceSample{});
      ASSERT_FALSE(stage.Stage.IsStale()) << ms;
    }
    for (int ms = 0; ms < 400; ++ms)
    {
      stage.Tick(isSeen && ms % 10 == 0 ? MakeSign() : DeviceSample{});
      // `ms` counts from 8 ms after the last report. The tip becomes stale 30 ms after that report.
      EXPECT_TRUE(stage.Stage.IsStale() == (!isSeen && ms >= 22) || ms == 22) << ms;
    }
  }
}
