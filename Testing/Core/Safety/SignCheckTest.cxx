// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the check of a device's signs, in closed loop with simulated hands (SignTrials.h).
 */

#include "Rigs/SignTrials.h"

#include <gtest/gtest.h>

using namespace signtest;
using VolumeHaptics::SignCheck;
using VolumeHaptics::SignResult;
using VolumeHaptics::Vector3;

namespace
{
constexpr Triple Right = { 1.0, 1.0, 1.0 };
/// Number of sessions. Sanitizers make the code slow, so their builds run fewer sessions, although
/// the statistics need the full number.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int Sessions = 20;
#else
constexpr int Sessions = 200;
#endif

std::string Describe(const Hand& hand, const Port& port)
{
  return std::to_string(hand.Mass) + " kg, " + std::to_string(hand.Stiffness) + " N/m, " +
    std::to_string(hand.Damping) + " N s/m, friction " + std::to_string(hand.StaticFriction) +
    " N, at " + std::to_string(port.Rate) + " Hz, largest force " + std::to_string(port.Force) +
    " N";
}
} // namespace

TEST(SignCheck, EveryCombinationOfWrongSignsIsCaughtGently)
{
  for (unsigned wrong = 1; wrong < 8; ++wrong)
  {
    const Triple signs = { wrong & 1u ? -1.0 : 1.0, wrong & 2u ? -1.0 : 1.0,
      wrong & 4u ? -1.0 : 1.0 };
    for (const double mass : { 0.05, 0.5 })
    {
      for (const double stiffness : { 0.0, 100.0, 500.0 })
      {
        Hand hand;
        hand.Mass = mass;
        hand.Stiffness = stiffness;
        hand.Damping = stiffness > 0.0 ? 0.3 * std::sqrt(stiffness * mass) : 0.0;
        hand.TremorSize = 0.05e-3;
        Port port;
        port.ReportTime = wrong % 2 == 0 ? 0.008 : 0.0;
        port.IsLate = true;
        const Outcome outcome = CheckSigns(hand, port, signs, wrong);
        const std::string which = Describe(hand, port) + ", wrong axes " + std::to_string(wrong);
        ASSERT_EQ(outcome.Verdict.Result, SignResult::Wrong) << which;
        EXPECT_TRUE(wrong >> outcome.Verdict.Axis & 1u) << which;
        EXPECT_LT(outcome.Work, 0.010) << which;
        EXPECT_LT(outcome.Motion, 0.005) << which;
      }
    }
  }
}

TEST(SignCheck, WrongSignsInRandomHandsAreCaught)
{
  RandomHands random(11);
  for (int i = 0; i < Sessions / 2; ++i)
  {
    Hand hand;
    Port port;
    random.Draw(hand, port);
    const Outcome outcome = CheckSigns(hand, port, random.DrawWrongSigns(), 1000 + i);
    EXPECT_NE(outcome.Verdict.Result, SignResult::Confirmed) << i << ": " << Describe(hand, port);
    EXPECT_NE(outcome.Verdict.Result, SignResult::Pending) << i << ": " << Describe(hand, port);
    EXPECT_LT(outcome.Work, 0.020) << i << ": " << Describe(hand, port);
    EXPECT_LT(outcome.Motion, 0.005) << i << ": " << Describe(hand, port);
  }
}

TEST(SignCheck, NoHonestDeviceIsCalledWrong)
{
  RandomHands random(12);
  int undecided = 0;
  for (int i = 0; i < Sessions; ++i)
  {
    Hand hand;
    Port port;
    random.Draw(hand, port);
    const Outcome outcome = CheckSigns(hand, port, Right, 2000 + i);
    EXPECT_NE(outcome.Verdict.Result, SignResult::Wrong) << i << ": " << Describe(hand, port);
    EXPECT_NE(outcome.Verdict.Result, SignResult::Pending) << i << ": " << Describe(hand, port);
    undecided += outcome.Verdict.Result == SignResult::Confirmed ? 0 : 1;
  }
  EXPECT_LE(undecided, 10);
}

TEST(SignCheck, SaysWhichAxisDidNotMove)
{
  Hand hand;
  hand.StaticFriction = hand.KineticFriction = 2.0; // N: more than the check may push
  hand.TremorSize = 0.0;
  const Outcome outcome = CheckSigns(hand, {}, Right, 1);
  EXPECT_EQ(outcome.Verdict.Result, SignResult::NoMotion);
  EXPECT_EQ(outcome.Verdict.Axis, 0);
}

TEST(SignCheck, WaitsForAHandThatRestsAndGivesUp)
{
  Hand hand;
  hand.Drift = 0.1; // m/s: the hand moves without a force
  hand.TremorSize = 2e-3;
  const Outcome outcome = CheckSigns(hand, {}, Right, 1);
  EXPECT_EQ(outcome.Verdict.Result, SignResult::Restless);
  EXPECT_EQ(outcome.Work, 0.0) << "it never pushed";
}

TEST(SignCheck, PushesOnlyAlongTheAxesThatTheDeviceHas)
{
  SignCheck check;
  check.Begin(1, 8.0);
  double along = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    const Vector3 force = check.Step({}, true, 1e-3);
    along = std::max(along, std::abs(force.X));
    EXPECT_EQ(force.Y, 0.0);
    EXPECT_EQ(force.Z, 0.0);
  }
  EXPECT_GT(along, 0.0);
  EXPECT_LE(along, SignCheck::MostShare * 8.0);
  check.Begin(0, 8.0);
  EXPECT_EQ(check.GetVerdict().Result, SignResult::Confirmed) << "it can't push at all";
}

TEST(SignCheck, DoesNotPushWithoutMeasuredTips)
{
  SignCheck check;
  check.Begin(7, 8.0);
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 force = check.Step({}, i < 450, 1e-3);
    if (i > 1000)
    {
      ASSERT_EQ(Norm(force), 0.0) << i;
    }
  }
  EXPECT_EQ(check.GetVerdict().Result, SignResult::Pending);
}

TEST(SignCheck, AnInterruptionVoidsTheTrial)
{
  SignCheck check;
  check.Begin(7, 8.0);
  int i = 0;
  while (Norm(check.Step({}, true, 1e-3)) == 0.0)
  {
    ASSERT_LT(++i, 2000);
  }
  check.Interrupt();
  for (int j = 0; j < 300; ++j)
  {
    ASSERT_EQ(Norm(check.Step({}, true, 1e-3)), 0.0) << "it waits for rest anew";
  }
  EXPECT_EQ(check.GetAxis(), 0);
}
