// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the servo's clock of a moving volume, tick by tick. The references compute times by
 * repeated reflection and subtraction, and use the closed form of a wall that moves as a whole.
 *
 * The wall is V = 100 (z - h(t)). With linear blending, its surface is at h(t), which is linear
 * between time steps.
 */

#include "Core/Servo/DataClock.h"
#include "Core/Servo/ServoTick.h"
#include "Rigs/CoreScene.h"
#include "Rigs/GatedStage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <memory>
#include <optional>
#include <random>
#include <vector>

using namespace coretest;

namespace
{
constexpr double ClockPeriod = 1e-3; // s
constexpr double ClockStiffness = 500.0;

/// Time steps at irregular data times, and the height (mm) of a flat wall in each.
struct HighWall
{
  HighWall(std::vector<double> times, const std::vector<double>& heights)
    : Times(std::move(times))
    , Heights(heights)
  {
    for (std::size_t i = 0; i < this->Times.size(); ++i)
    {
      const double height = heights[i];
      TestVolume& timeStep =
        this->Volumes.emplace_back(ScalarType::Float64, std::array<std::int64_t, 3>{ 9, 9, 24 });
      timeStep.Fill<double>([height](std::int64_t, std::int64_t, std::int64_t z)
        { return 100.0 * (double(z) - height); });
      this->TimeSteps.push_back({ this->Times[i], timeStep.View, nullptr });
    }
  }

  /// Returns `count` time steps, beginning with index `first`. The first time step follows the last
  /// one.
  std::vector<VolumeTimeStep> Pick(std::size_t first, std::size_t count) const
  {
    std::vector<VolumeTimeStep> timeSteps;
    for (std::size_t i = first; i < first + count; ++i)
    {
      timeSteps.push_back(this->TimeSteps[i % this->TimeSteps.size()]);
    }
    return timeSteps;
  }

  HapticModelDescription Describe() const
  {
    HapticModelDescription d = coretest::Describe(this->Volumes.front());
    d.TimeSteps = this->Pick(0, this->TimeSteps.size() + 1);
    d.Material.Stiffness = ConstantPolyline(ClockStiffness);
    d.Material.SurfaceStrength = ConstantPolyline(4.0);
    return d;
  }

  double GetMean() const
  {
    return (this->Times.back() - this->Times.front()) / double(this->Times.size() - 1);
  }
  double GetPeriod() const { return this->Times.back() - this->Times.front() + this->GetMean(); }

  /// Returns the wall's height (mm) at a data time of the loop, by searching all intervals.
  double At(double time) const
  {
    for (std::size_t i = 0; i < this->Times.size(); ++i)
    {
      const bool isLast = i + 1 == this->Times.size();
      const double end = isLast ? this->Times[0] + this->GetPeriod() : this->Times[i + 1];
      if (time >= this->Times[i] && time <= end)
      {
        const double share = (time - this->Times[i]) / (end - this->Times[i]);
        return this->Heights[i] + share * (this->Heights[isLast ? 0 : i + 1] - this->Heights[i]);
      }
    }
    return std::nan("");
  }

  const std::vector<double> Times;
  const std::vector<double> Heights;
  std::list<TestVolume> Volumes;
  std::vector<VolumeTimeStep> TimeSteps;
};

HighWall MakeUneven()
{
  return { { 2.0, 3.0, 4.5, 5.0, 6.0 }, { 0.0, 0.8, 1.6, 0.4, 0.2 } };
}

/// A servo without a thread: the test runs the data clock and the ticks.
class ClockedHand
{
public:
  explicit ClockedHand(std::shared_ptr<const HapticModel> model)
    : Model(std::move(model))
  {
  }
  explicit ClockedHand(const HapticModelDescription& d)
    : ClockedHand(std::make_shared<const HapticModel>(d))
  {
  }

  void Publish(std::vector<VolumeTimeStep> timeSteps)
  {
    const BakedVolume& last = *this->Model->Baked;
    const auto baked = std::make_shared<const BakedVolume>(last, timeSteps, last.Series);
    const auto next =
      std::make_shared<const HapticModel>(baked, this->Model->DeviceToWorld, ForceCaps{});
    CarryState(*this->Model, *next, this->State);
    this->Model = next;
  }

  DataClock::Leap Step(const Vector3& tip)
  {
    const DataClock::Leap leap =
      this->Clock.Update(*this->Model->Baked, this->Orders, ClockPeriod, this->State);
    this->State.Enabled = this->State.Enabled && leap != DataClock::Leap::Away;
    VolumeHaptics::Tick(*this->Model, this->State, tip, this->Record);
    return leap;
  }

  double GetTime() const { return this->State.DataTime; }
  const DataClockReport& GetReport() const { return this->Clock.GetReport(); }

  std::shared_ptr<const HapticModel> Model;
  DataClock Clock;
  DataClockOrders Orders;
  ServoState State;
  TickRecord Record;
};

/// Brings a time beyond the ends back into the series: stops, wraps around or reverses at the ends,
/// according to `mode`. (Slow reference.)
double FoldSlowly(const HighWall& wall, double time, Playback mode)
{
  const double first = wall.Times.front();
  const double last = wall.Times.back();
  if (mode == Playback::Once)
  {
    return std::clamp(time, first, last);
  }
  while (mode == Playback::Loop && time >= first + wall.GetPeriod())
  {
    time -= wall.GetPeriod();
  }
  while (mode == Playback::Loop && time < first)
  {
    time += wall.GetPeriod();
  }
  while (mode == Playback::PingPong && (time < first || time > last))
  {
    time = time < first ? 2.0 * first - time : 2.0 * last - time;
  }
  return time;
}

const Vector3 RestingTip{ 0.004, 0.004, 0.012 };
} // namespace

TEST(DataClock, FoldsTimeAtTheEndsOfTheSeries)
{
  const HighWall wall = MakeUneven();
  for (const Playback mode : { Playback::Once, Playback::Loop, Playback::PingPong })
  {
    for (const double rate : { 1.7, -2.3, 40.0 })
    {
      ClockedHand hand(wall.Describe());
      hand.Orders = { mode, false, rate, 2.7, 1 };
      hand.Step(RestingTip);
      EXPECT_EQ(hand.GetTime(), 2.7);
      hand.Orders.Plays = true;
      for (int i = 1; i < 9000; ++i)
      {
        hand.Step(RestingTip);
        const double expected = FoldSlowly(wall, 2.7 + rate * ClockPeriod * i, mode);
        const double off = std::abs(hand.GetTime() - expected);
        // The end of the loop is the same time as its beginning.
        ASSERT_LT(std::min(off, std::abs(off - wall.GetPeriod())), 1e-8)
          << "tick " << i << " of mode " << static_cast<int>(mode) << " at " << rate;
        ASSERT_EQ(hand.Record.DataTime, hand.GetTime());
      }
    }
  }
}

TEST(DataClock, BeginsHeldAtTheFirstTimeStep)
{
  const HighWall wall = MakeUneven();
  ClockedHand hand(wall.Describe());
  for (int i = 0; i < 3; ++i)
  {
    hand.Step(RestingTip);
    EXPECT_EQ(hand.GetTime(), 2.0);
  }
  EXPECT_TRUE(hand.GetReport().IsMoving);
  EXPECT_FALSE(hand.GetReport().IsWaiting);
}

TEST(DataClock, ATimeSpanIsTheWholeToTheBit)
{
  const HighWall wall = MakeUneven();
  const HapticModel whole(wall.Describe());
  for (std::size_t first = 0; first < 5; ++first)
  {
    const BakedVolume instant(*whole.Baked, wall.Pick(first, 1), whole.Baked->Series);
    const double time = wall.Times[first];
    for (const double other : { time - 0.1, time + 0.1 })
    {
      EXPECT_FALSE(instant.GetTimeSpan().Has(other));
    }
    EXPECT_TRUE(instant.GetTimeSpan().Has(time));
    EXPECT_EQ(instant.GetTimeSpan().GetAhead(time) + instant.GetTimeSpan().GetBehind(time), 0.0);
    EXPECT_EQ(instant.FindNearestTimeStep(time), 0U);
    const Vector3 place{ 3.3, 4.4, 5.5 };
    EXPECT_EQ(instant.At(time).Value(place), whole.Baked->At(time).Value(place));
    for (const std::size_t count : { 2, 3 })
    {
      const BakedVolume span(*whole.Baked, wall.Pick(first, count), whole.Baked->Series);
      const TimeSpan times = span.GetTimeSpan();
      int inside = 0;
      for (double t = 2.0; t < 7.0; t += 0.013)
      {
        if (times.Has(t))
        {
          const Vector3 at{ 3.3, 4.4, 5.5 };
          ASSERT_EQ(span.At(t).Value(at), whole.Baked->At(t).Value(at)) << t;
          ASSERT_NEAR(span.At(t).Value(at), 100.0 * (5.5 - wall.At(t)), 1e-9) << t;
          ++inside;
        }
      }
      EXPECT_GT(inside, 30);
    }
  }
}

/// The test publishes time spans of two or three time steps. The next time span arrives in time, or
/// late.
TEST(DataClock, HoldsWhileTimeStepsAreLateAndNeverJumps)
{
  const HighWall wall = MakeUneven();
  for (const double rate : { 3.0, -3.0 })
  {
    for (const int late : { 0, 120 })
    {
      ClockedHand hand(wall.Describe());
      hand.Orders = { Playback::Loop, true, rate, 2.0, 1 };
      std::size_t first = rate > 0.0 ? 0 : 4; // index of the pair's first time step
      hand.Publish(wall.Pick(first, 2));
      int waited = 0;
      int missing = 0;
      double before = 2.0;
      double travelled = 0.0;
      for (int i = 0; i < 6000; ++i)
      {
        const DataClock::Leap leap = hand.Step(RestingTip);
        ASSERT_TRUE(i == 0 || leap == DataClock::Leap::None);
        const double step = std::abs(hand.GetTime() - before);
        const double way = std::min(step, std::abs(step - wall.GetPeriod()));
        ASSERT_LE(way, 3.0 * ClockPeriod * (1.0 + 1e-9)) << "tick " << i;
        travelled += way;
        before = hand.GetTime();
        const bool waits = hand.GetReport().IsWaiting;
        waited += waits ? 1 : 0;
        missing = waits ? missing + 1 : 0;
        if (waits)
        {
          EXPECT_EQ(hand.GetReport().Wanted, hand.GetTime());
        }
        if (missing > late)
        {
          first = (first + (rate > 0.0 ? 1 : 4)) % 5;
          hand.Publish(wall.Pick(first, 2));
        }
      }
      const double all = 3.0 * ClockPeriod * 6000;
      EXPECT_NEAR(travelled, all - 3.0 * ClockPeriod * waited, 0.1);
      EXPECT_EQ(waited > 200, late > 0);
    }
  }
}

TEST(DataClock, OrdersStepNeitherTimeNorForce)
{
  const HighWall wall = MakeUneven();
  ClockedHand hand(wall.Describe());
  std::mt19937 random(7);
  const auto pick = [&random](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  // Fastest motion of the wall (mm per unit of data time).
  const double fastest = 1.2 / 0.5;
  hand.Step({ 0.004, 0.004, 0.0115 });
  for (int i = 0; i < 50; ++i)
  {
    hand.Step({ 0.004, 0.004, 0.0115 + 1e-5 * i });
  }
  hand.Orders.Plays = true;
  hand.Step(RestingTip);
  int turns = 0;
  for (int i = 0; i < 20000; ++i)
  {
    if (i % 61 == 0)
    {
      hand.Orders.Mode = static_cast<Playback>(random() % 3);
      hand.Orders.Plays = random() % 4 != 0;
      hand.Orders.Rate = pick(-6.0, 6.0);
      ++turns;
    }
    const double time = hand.GetTime();
    const double force = hand.Record.Force.Z;
    ASSERT_EQ(hand.Step(RestingTip), DataClock::Leap::None);
    const double step = std::abs(hand.GetTime() - time);
    const double most = std::abs(hand.Orders.Rate) * ClockPeriod * (1.0 + 1e-9);
    ASSERT_LE(std::min(step, std::abs(step - wall.GetPeriod())), most) << "tick " << i;
    // In a tick, the force may change by k |v_n| dt (stiffness, wall's speed, data time), plus the
    // accuracy of a level.
    ASSERT_LE(std::abs(hand.Record.Force.Z - force), ClockStiffness * 1e-3 * fastest * most + 1e-3)
      << "tick " << i;
  }
  EXPECT_GT(turns, 300);
}

TEST(DataClock, GoesToAPlaceAtOnceOrWhenItsTimeStepsCome)
{
  const HighWall wall = MakeUneven();
  ClockedHand hand(wall.Describe());
  hand.Orders = { Playback::Once, false, 1.0, 4.0, 1 };
  hand.Step(RestingTip);
  hand.Orders.Place = 4.8;
  hand.Orders.Places = 2;
  EXPECT_EQ(hand.Step(RestingTip), DataClock::Leap::Within);
  EXPECT_EQ(hand.GetTime(), 4.8);
  EXPECT_EQ(hand.Step(RestingTip), DataClock::Leap::None);

  hand.Publish(wall.Pick(2, 2)); // the time steps at 4.5 and 5
  hand.Orders = { Playback::Once, true, 1.0, 2.2, 3 };
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(hand.Step(RestingTip), DataClock::Leap::None);
    EXPECT_EQ(hand.GetTime(), 4.8);
    EXPECT_TRUE(hand.GetReport().IsWaiting);
    EXPECT_EQ(hand.GetReport().Wanted, 2.2);
  }
  hand.Publish(wall.Pick(0, 2));
  EXPECT_EQ(hand.Step(RestingTip), DataClock::Leap::Away);
  EXPECT_NEAR(hand.GetTime(), 2.2, 1.1 * ClockPeriod);
  EXPECT_EQ(Norm(hand.Record.Force), 0.0); // the leap begins a new contact
  EXPECT_FALSE(hand.GetReport().IsWaiting);

  hand.Orders = { Playback::Once, false, 1.0, 99.0, 4 };
  hand.Publish(wall.Pick(3, 3));
  hand.Step(RestingTip);
  EXPECT_EQ(hand.GetTime(), 6.0);
}

/// After a jump to another place, a single time step may arrive first. In each playback mode, the
/// time holds at this time step, and no motion carries the proxy.
TEST(DataClock, GoesToAPlaceByWayOfOneTimeStep)
{
  const HighWall wall = MakeUneven();
  for (const Playback mode : { Playback::Once, Playback::Loop, Playback::PingPong })
  {
    for (const double rate : { 1.0, -1.0 })
    {
      for (const bool plays : { false, true })
      {
        ClockedHand hand(wall.Describe());
        hand.Orders = { mode, false, rate, 3.0, 1 };
        hand.Publish(wall.Pick(0, 2));
        for (int i = 0; i <= 50; ++i)
        {
          hand.Step({ 0.004, 0.004, 0.0115 + 1e-5 * i });
        }
        const Vector3& tip = RestingTip;
        ASSERT_NEAR(hand.Record.Force.Z, -1e-3 * ClockStiffness * 0.5, 1e-3);
        hand.Orders.Place = 4.6;
        hand.Orders.Places = 2;
        hand.Orders.Plays = plays;
        hand.Step(tip);
        ASSERT_TRUE(hand.GetReport().IsWaiting);
        hand.Publish(wall.Pick(2, 1)); // the time step at 4.5, with the wall at 1.6 mm
        EXPECT_EQ(hand.Step(tip), DataClock::Leap::Away);
        EXPECT_EQ(Norm(hand.Record.Force), 0.0);
        for (int i = 0; i < 20; ++i)
        {
          EXPECT_EQ(hand.GetTime(), 4.5);
          EXPECT_TRUE(hand.GetReport().IsWaiting);
          EXPECT_EQ(hand.GetReport().Wanted, 4.6);
          EXPECT_EQ(hand.Step(tip), DataClock::Leap::None);
        }
        hand.Publish(wall.Pick(2, 2));
        EXPECT_EQ(hand.Step(tip), DataClock::Leap::Away);
        EXPECT_NEAR(hand.GetTime(), 4.6, plays ? 1.1 * ClockPeriod : 0.0);
        EXPECT_EQ(Norm(hand.Record.Force), 0.0);
        EXPECT_FALSE(hand.GetReport().IsWaiting);

        // The single time step may be the wanted place itself. The clock then waits there for the
        // next time steps.
        hand.Publish(wall.Pick(4, 1));
        hand.Orders.Place = 6.0;
        hand.Orders.Places = 3;
        EXPECT_EQ(hand.Step(tip), DataClock::Leap::Away);
        for (int i = 0; i < 20; ++i)
        {
          EXPECT_EQ(hand.GetTime(), 6.0);
          const bool isEnd = mode == Playback::Once && rate > 0.0;
          EXPECT_EQ(hand.GetReport().IsWaiting, plays && !isEnd);
          EXPECT_EQ(hand.Step(tip), DataClock::Leap::None);
        }
        hand.Publish(wall.Pick(3, 2));
        EXPECT_EQ(hand.Step(tip), DataClock::Leap::None);
      }
    }
  }
}

/// The wall beats with an amplitude of 1.6 mm. Hands that rest, yield and press feel it through the
/// safety stage.
TEST(DataClock, AWallThatBeatsGivesItsWorkAndNoFault)
{
  const HighWall wall({ 0.0, 0.25, 0.5, 0.75 }, { 0.0, 0.8, 1.6, 0.8 });
  std::mt19937 random(11);
  std::normal_distribution<double> tremble(0.0, 1.0);
  double largest = 0.0;
  double reached = 0.0;
  for (int session = 0; session < 24; ++session)
  {
    const bool isStill = session % 3 == 0;
    // Beats per second. At the largest rate, the wall moves as fast as a tip in an unstable loop.
    const double rate = session % 8 == 7 ? 18.0 : 0.5 + 0.25 * (session % 8);
    ClockedHand hand(wall.Describe());
    hand.Orders = { Playback::Loop, true, rate, 0.0, 0 };
    rigs::GatedStage stage;
    SafetyLimits limits;
    limits.MaximumForce = 4.0;
    // Limits that reduce or delay the force also do work. In these sessions, the hand's energy is
    // compared with the positive part of the wall's work.
    const bool isLimited = session % 2 != 0;
    limits.MaximumForceRate = isLimited ? 2.0 : 500.0;
    limits.RampTime = isLimited ? 0.5 : 0.0;
    limits.MovesTip = true;
    stage.Arm();
    SafetyInput input;
    input.Elapsed = input.Period;
    input.Fresh = true;
    Vector3 tip{ 0.004, 0.004, 0.0118 };
    Vector3 sent;
    double speed = 0.0;
    double goal = tip.Z;
    double aim = tip.Z;
    double given = 0.0;    // energy (J) that the force has given to the hand
    double fromWall = 0.0; // work of the wall (J)
    double pushed = 0.0;   // positive part of the work of the wall (J)
    double most = 0.0;     // largest energy (J) given to the hand in excess of the work of the wall
    for (int i = 0; i < 6000; ++i)
    {
      // A hand of 80 g on a damped spring of 150 N/m, whose other end moves slowly to and fro.
      goal = i % 700 == 0 ? 0.0125 + 5e-4 * tremble(random) : goal;
      aim += 0.005 * (goal - aim);
      const double force = sent.Z - 150.0 * (tip.Z - aim) - 4.0 * speed;
      speed += isStill ? 0.0 : force / 0.08 * ClockPeriod;
      const double way = isStill ? (i < 100 ? 1e-5 : 0.0) : speed * ClockPeriod;
      given += sent.Z * way;
      tip.Z += way;
      hand.Step(tip);
      input.Force = hand.Record.Force;
      input.Tip = tip;
      input.Stiffness = hand.Record.Stiffness;
      input.Stretch = Norm(hand.Record.Proxy - tip);
      input.WallWork = hand.Record.WallWork;
      sent = stage.Apply(input, limits);
      fromWall += hand.Record.WallWork;
      pushed += std::max(0.0, hand.Record.WallWork);
      most = std::max(most, given - (isLimited ? pushed : fromWall));
      largest = std::max(largest, Norm(sent));
      ASSERT_EQ(stage.Gate.GetFault(), GateReason::None)
        << "session " << session << " tick " << i << ", fault "
        << static_cast<int>(stage.Gate.GetFault());
    }
    // A tick is a finite step, which adds up to k dx^2 / 2 to the energy. The steps dx are some
    // 2e-5 m.
    EXPECT_LE(most, 3e-5) << "session " << session;
    reached = std::max(reached, given);
  }
  EXPECT_GT(largest, 0.7);
  EXPECT_GT(reached, 2e-4); // J: the wall has pushed hands away
}
