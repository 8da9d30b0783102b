// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The ideal hand is correct as often as signal detection theory predicts: Phi(d'/2) for two
 * tissues, and closed forms for three tissues on a line. It also palpates slabs whose forces are
 * known.
 */

#include "Palpation.h"

#include "Shapes.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

using namespace evaluation;
using namespace VolumeHaptics;

namespace
{
double Phi(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

TEST(IdealHand, ADifferenceOfOneWeberFractionIsOneUnit)
{
  const IdealHand hand(0.1, { 1e-9, 0.5 });
  EXPECT_NEAR(hand.Perceive(1.1, 0) - hand.Perceive(1.0, 0), 1.0, 1e-6);
  EXPECT_NEAR(hand.Perceive(220.0, 0) - hand.Perceive(200.0, 0), 1.0, 1e-6);
  EXPECT_EQ(hand.Perceive(0.0, 1), 0.0) << "nothing is felt as nothing";
  // Far below the floor, the perceived difference is linear, with the unit x0 ln(1 + w).
  const double unit = 0.5 * std::log(1.1);
  EXPECT_NEAR(hand.Perceive(1e-6, 1), 1e-6 / unit, 1e-10);
}

TEST(IdealHand, OfTwoIsRightByPhiOfHalfTheDistance)
{
  const IdealHand hand(0.1, { 1e-9, 1e-9 });
  for (const double distance : { 0.0, 0.5, 1.0, 2.0, 4.0 })
  {
    // Two cues change along a line, in the ratio 3 : 4.
    const auto cue = [](double units) { return std::exp(units * std::log(1.1)); };
    const FeltTissue one{ "one", { { 1.0, 1.0 } } };
    const FeltTissue other{ "other", { { cue(0.6 * distance), cue(0.8 * distance) } } };
    EXPECT_NEAR(hand.Distance(one, other), distance, 1e-5);
    const auto confusion = hand.ComputeConfusion({ one, other });
    for (std::size_t i = 0; i < 2 && distance > 0.0; ++i)
    {
      EXPECT_NEAR(confusion[i][i], Phi(0.5 * distance), 0.008) << distance;
      EXPECT_NEAR(confusion[i][0] + confusion[i][1], 1.0, 1e-9);
    }
    // Two tissues have the same cues, so identifying either of them is a guess.
    EXPECT_NEAR(CountCorrect(confusion), 2.0 * Phi(0.5 * distance), 0.01);
  }
}

TEST(IdealHand, OfThreeOnALineTheMiddleOneIsConfusedTwice)
{
  const double units = 2.0;
  const auto cue = [](double u) { return std::exp(u * std::log(1.1)); };
  const IdealHand hand(0.1, { 1e-9 });
  const auto confusion = hand.ComputeConfusion({ { "low", { { cue(0.0) } } },
    { "middle", { { cue(units) } } }, { "high", { { cue(2.0 * units) } } } });
  EXPECT_NEAR(confusion[0][0], Phi(0.5 * units), 0.008);
  EXPECT_NEAR(confusion[1][1], 2.0 * Phi(0.5 * units) - 1.0, 0.008);
  EXPECT_NEAR(confusion[1][0], 1.0 - Phi(0.5 * units), 0.008);
  EXPECT_NEAR(confusion[0][2], 1.0 - Phi(1.5 * units), 0.008);
}

TEST(IdealHand, PlacesThatDifferAreHarderToName)
{
  // Each of two means has places at -s and s: the variance is 1 + s^2, and the border is still
  // halfway between the means.
  const auto cue = [](double u) { return std::exp(u * std::log(1.1)); };
  const double s = 1.5;
  const double d = 3.0;
  const IdealHand hand(0.1, { 1e-9 });
  const auto confusion = hand.ComputeConfusion(
    { { "one", { { cue(-s) }, { cue(s) } } }, { "other", { { cue(d - s) }, { cue(d + s) } } } });
  const double right = 0.5 * (Phi(0.5 * d + s) + Phi(0.5 * d - s));
  EXPECT_NEAR(confusion[0][0], right, 0.008);
  EXPECT_NEAR(confusion[1][1], right, 0.008);
}

/** Returns a linear ramp, in which a surface is wherever the hand begins. */
std::shared_ptr<const HapticModel> MakeRamp(
  double stiffness, double friction, double strength, double viscosity)
{
  const Volume volume([](const Vector3& x) { return -100.0 * x.Z; },
    { 24.0, { 1.0, 1.0, 1.0 }, ScalarType::Float64, 0.0, 1, false });
  Touching touching;
  touching.Material = MakeMaterial(stiffness, friction, viscosity, strength);
  return volume.Bake(touching);
}

TEST(IdealHand, CuesOfASlabAreTheClosedForms)
{
  Spot spot = OnSlab();
  spot.Above = 0.0;
  {
    const auto firm = MakeRamp(800.0, 0.25, 3.0, 0.0);
    const auto force = Palpate(*firm, spot, HandStrategy::ConstantForce);
    EXPECT_NEAR(force[0], 1.0 / 0.8, 0.02) << "f / k in mm";
    EXPECT_NEAR(force[1], 0.25 * 1.0, 0.005) << "mu f";
    EXPECT_NEAR(force[2], 3.0, 0.01) << "T_N";
    const auto depth = Palpate(*firm, spot, HandStrategy::ConstantDepth);
    EXPECT_NEAR(depth[0], 1.6, 0.01) << "k d";
    EXPECT_NEAR(depth[1], 0.25 * 1.6, 0.005);
  }
  {
    const auto weak = MakeRamp(400.0, 0.0, 0.3, 0.0);
    const auto force = Palpate(*weak, spot, HandStrategy::ConstantForce);
    EXPECT_NEAR(force[0], 10.0, 1e-9) << "it does not hold 1 N";
    EXPECT_NEAR(force[2], 0.3, 0.01);
    EXPECT_NEAR(Palpate(*weak, spot, HandStrategy::ConstantDepth)[0], 0.3, 0.01) << "T_N < k d";
  }
  {
    const auto hard = MakeRamp(1000.0, 0.1, Impenetrable, 0.0);
    EXPECT_NEAR(Palpate(*hard, spot, HandStrategy::ConstantForce)[2], 4.0, 1e-9)
      << "no more than the hand presses";
  }
}

TEST(IdealHand, TellsBoneFromFluidOnSlabs)
{
  const Identification found = IdentifyOnSlabs("CT contrast");
  ASSERT_EQ(found.Correct.size(), 2u);
  EXPECT_EQ(found.Tissues, 6u);
  for (const double correct : found.Correct)
  {
    EXPECT_GT(correct, 4.0);
    EXPECT_LE(correct, 6.0 + 1e-9);
  }
  for (const auto& row : found.Confusions.Rows)
  {
    EXPECT_EQ(row.size(), found.Confusions.Columns.size());
  }
}
} // namespace
