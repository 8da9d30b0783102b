// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Throws an undamped mass against a spring, in closed loop through the safety stage. With the slew
 * limit, the mass must leave with at most the energy that it would have without it.
 *
 * In each tick, the mass moves exactly as under a constant force: x += v T + a T^2 / 2, v += a T.
 * An undamped sampled spring adds energy by itself: with f = -k x held for T, the characteristic
 * polynomial of x, v is z^2 - (2 - k T^2 / 2m) z + 1 + k T^2 / 2m, so the energy grows by the
 * factor 1 + k T^2 / 2m in each tick.
 */

#include "Rigs/Impacts.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace rigs::impacts;

TEST(Impact, AStiffWallReturnsNoMoreThanItsSamplingAdds)
{
  constexpr double k = 3000.0;
  constexpr double m = 0.15;
  constexpr double perTick = 1.0 + k * Period * Period / (2.0 * m);
  const double ticks = std::acos(-1.0) * std::sqrt(m / k) / Period + 2.0;
  for (const double most : { 4.0, 8.0 })
  {
    for (int phase = 1; phase <= 10; ++phase)
    {
      const Body body = Throw(m, 0.3, 0.1 * phase);
      Loop loop;
      loop.MaximumForce = most;
      const double left = loop.Fly(body, MakeWall(k));
      EXPECT_LE(left, loop.FlyFreely(body, MakeWall(k))) << most << " N, phase " << phase;
      EXPECT_LE(left, std::pow(perTick, ticks) * body.Energy()) << most << " N, phase " << phase;
      EXPECT_GT(left, 0.7 * body.Energy()) << "a wall, no mud";
      EXPECT_LE(loop.LargestGrowth, 0.5 * (1.0 + 1e-9));
      EXPECT_GT(loop.LargestGrowth, 0.49) << "the limit had something to do";
    }
  }
}

TEST(Impact, TheReboundIsNeverFasterThanWithoutTheStage)
{
  const std::vector<Rebound> all = FlyAll();
  EXPECT_EQ(all.size(), 144U);
  for (const Rebound& r : all)
  {
    EXPECT_LE(r.Left, r.Unlimited) << r.Tick << " s, " << r.Stiffness << " N/m, " << r.Speed
                                   << " m/s, " << r.MaximumForce << " N, delay " << r.Delay;
    EXPECT_LE(r.Left, r.Free) << r.Tick << " s, " << r.Stiffness << " N/m, " << r.Speed << " m/s, "
                              << r.MaximumForce << " N, delay " << r.Delay;
  }
}

TEST(Impact, NoWallReturnsMoreThanWithoutTheLimit)
{
  for (const double mass : { 0.05, 0.15, 0.5 })
  {
    for (const double speed : { 0.1, 0.3, 1.0, 2.0 })
    {
      for (const double k : { 300.0, 1000.0, 3000.0 })
      {
        for (int i = 0; i < 16; ++i)
        {
          Loop loop;
          loop.MaximumForce = i % 2 == 0 ? 4.0 : 20.0;
          loop.ForceRate = i / 2 % 2 == 0 ? 100.0 : 500.0;
          loop.Delay = i / 4 % 2 == 0 ? 0 : 1;
          loop.Stiffness = i / 8 % 2 == 0 ? 0.0 : k;
          const Body body = Throw(mass, speed, 0.3);
          const double left = loop.Fly(body, MakeWall(k));
          EXPECT_LE(left, 1.02 * loop.FlyFreely(body, MakeWall(k)))
            << mass << " kg, " << speed << " m/s, " << k << " N/m, case " << i;
          EXPECT_LE(loop.LargestGrowth, loop.ForceRate * Period * (1.0 + 1e-9));
        }
      }
    }
  }
}

TEST(Impact, NoWallReturnsMoreToADeviceThatReportsSlowly)
{
  for (const int every : { 2, 4, 8, 10 })
  {
    for (const double mass : { 0.05, 0.15, 0.5, 2.0 })
    {
      for (const double speed : { 0.1, 0.3, 1.0 })
      {
        for (const double k : { 100.0, 300.0, 600.0, 1000.0 })
        {
          for (int i = 0; i < 6; ++i)
          {
            Loop loop;
            loop.Every = every;
            loop.ForceRate = i / 2 == 0 ? 10.0 : i / 2 == 1 ? 100.0 : 500.0;
            loop.Stiffness = i % 2 == 0 ? 0.0 : k;
            const Body body = Throw(mass, speed, 0.3 * every);
            const double left = loop.Fly(body, MakeWall(k));
            EXPECT_LE(left, 1.02 * loop.FlyFreely(body, MakeWall(k)))
              << every << " ms, " << mass << " kg, " << speed << " m/s, " << k << " N/m, case "
              << i;
          }
        }
      }
    }
  }
}

TEST(Impact, AWallThatTurnsReturnsNoMoreEither)
{
  // A mass hits the inside of a tube obliquely, so that the force turns while the mass slides along
  // the wall.
  constexpr double radius = 0.01;
  const Field tube = [](const Vector3& x)
  {
    const double r = std::hypot(x.X, x.Y);
    const double pull = r > radius ? -3000.0 * (r - radius) / r : 0.0;
    return Vector3{ pull * x.X, pull * x.Y, 0.0 };
  };
  for (const double aslant : { 0.0, 0.002, 0.005, 0.008 })
  {
    for (const double speed : { 0.3, 0.6 })
    {
      Body body;
      body.Place = { 0.0, aslant, 0.0 };
      body.Velocity = { speed, 0.0, 0.0 };
      Loop loop;
      const double left = loop.Fly(body, tube);
      EXPECT_LE(left, 1.005 * loop.FlyFreely(body, tube)) << aslant << " m, " << speed << " m/s";
    }
  }
}

TEST(Impact, WorkLostToFrictionDoesNotHideWhatAWallIsOwed)
{
  // Friction along x takes 40 J; then, in the same contact, the mass hits a wall. Friction has no
  // end, so the stage computes from the spring's stiffness how much energy can come back. The
  // result includes the spring that friction has stretched, which is 5 % of the wall's energy.
  constexpr double k = 3000.0;
  SafetyLimits limits;
  limits.MaximumForce = 8.0;
  const auto fly = [&](double rate)
  {
    limits.MaximumForceRate = rate;
    rigs::GatedStage stage;
    SafetyInput input;
    input.Stiffness = k;
    input.Elapsed = input.Period = Period;
    input.Fresh = true;
    stage.Arm();
    for (int i = 0; i < 20000; ++i)
    {
      input.Tip.X += 1e-3;
      input.Force = { -2.0, 0.0, 0.0 };
      stage.Apply(input, limits);
    }
    Body body = Throw(0.15, 0.3, 0.3);
    double least = body.Place.Z;
    do
    {
      input.Tip.Z = body.Place.Z;
      input.Force.Z = k * std::max(0.0, -body.Place.Z);
      body.Move({ 0.0, 0.0, stage.Apply(input, limits).Z });
      least = std::min(least, body.Place.Z);
    } while (body.Place.Z < 0.0 || body.Velocity.Z < 0.0);
    EXPECT_LT(least, -1e-3);
    return body.Energy();
  };
  EXPECT_LE(fly(500.0), 1.05 * fly(1e9));
}

TEST(Impact, DragDoesNotHideWhatAWallIsOwed)
{
  // A drag of 5 N s/m acts at 0.1 m/s along x for 0.5 m in front of the wall. Like friction, the
  // drag takes work, but its force has no known stiffness.
  constexpr double k = 3000.0;
  const Vector3 drag{ -0.5, 0.0, 0.0 };
  const auto fly = [&](double rate)
  {
    SafetyLimits limits;
    limits.MaximumForce = 8.0;
    limits.MaximumForceRate = rate;
    rigs::GatedStage stage;
    SafetyInput input;
    input.Elapsed = input.Period = Period;
    input.Fresh = true;
    input.Drag = drag;
    stage.Arm();
    Body body = Throw(0.15, 0.3, 0.3);
    for (int i = 0; i < 5000 || body.Place.Z < 0.0 || body.Velocity.Z < 0.0; ++i)
    {
      input.Tip.X += 1e-4;
      input.Tip.Z = body.Place.Z;
      input.Force = MakeWall(k)(body.Place) + drag;
      const Vector3 force = stage.Apply(input, limits);
      if (i >= 5000)
      {
        body.Move({ 0.0, 0.0, force.Z });
      }
    }
    return body.Energy();
  };
  EXPECT_LE(fly(500.0), 1.02 * fly(1e9));
}

TEST(Impact, SlowGrowthGivesNothingBackThatWasNotPutIn)
{
  // The hand moves fast compared with the growth of the force. When it turns back, the stage
  // reduces the force to Paid / Work = 1 / 64. It may notice one tick later that this force is
  // still too large.
  constexpr double k = 1000.0;
  constexpr double depth = 0.02;
  constexpr double speed = 0.5;
  constexpr double oneTick = 2.0 / 65.0 * k * depth * speed * Period;
  for (const double rate : { 1.0, 2.0, 10.0 })
  {
    for (const int rest : { 0, 300 })
    {
      SafetyLimits limits;
      limits.MaximumForce = 8.0;
      limits.MaximumForceRate = rate;
      SafetyInput input;
      input.Elapsed = input.Period = Period;
      input.Fresh = true;
      rigs::GatedStage stage;
      stage.Arm();
      double given = 0.0;
      double felt = 0.0;
      const auto apply = [&](double shift)
      {
        input.Tip.Z += shift;
        input.Force = MakeWall(k)(input.Tip);
        const double force = stage.Apply(input, limits).Z;
        given += 0.5 * (felt + force) * shift;
        felt = force;
      };
      const auto move = [&](double way, int ticks)
      {
        for (int i = 0; i < ticks; ++i)
        {
          apply(way / ticks);
        }
      };
      input.Tip.Z = 0.01;
      move(0.0, 600);
      const int ticks = static_cast<int>((depth + 0.01) / (speed * Period));
      for (int i = 0; i < 5; ++i)
      {
        move(-depth - 0.01, ticks);
        EXPECT_GT(felt, 0.0) << "a wall is there";
        move(0.0, rest);
        move(depth + 0.01, ticks);
      }
      EXPECT_LE(given, 5.0 * oneTick) << rate << " N/s, " << rest << " ms";
    }
  }
}

TEST(Impact, PressingOnBringsBackWhatTheLimitTook)
{
  SafetyLimits limits;
  limits.MaximumForce = 4.0;
  SafetyInput input;
  input.Elapsed = input.Period = Period;
  input.Fresh = true;
  rigs::GatedStage stage;
  stage.Arm();
  const auto press = [&](double speed, double depth)
  {
    while (input.Tip.Z > -depth)
    {
      input.Tip.Z -= speed * Period;
      input.Force = MakeWall(3000.0)(input.Tip);
      stage.Apply(input, limits);
    }
    return stage.Apply(input, limits).Z;
  };
  for (int i = 0; i < 600; ++i)
  {
    stage.Apply(input, limits);
  }
  const double struck = press(1.0, 0.008);
  const double pressed = press(0.01, 0.016);
  EXPECT_LT(struck, 3.0);
  EXPECT_EQ(stage.Apply(input, limits).Z, pressed) << "a hand at rest feels no change";
  EXPECT_GT(pressed, struck + 0.3);
  EXPECT_GT(press(0.01, 0.2), 3.6);
}
