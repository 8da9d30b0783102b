// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the comparison of methods: fit, response, likeness, and errors for bad input. */

#include "Comparison.h"
#include "CostFit.h"
#include "Likeness.h"
#include "Relief.h"
#include "Shapes.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

using namespace evaluation;

namespace
{
const Method& Precise()
{
  return AllMethods()[1];
}

TEST(Comparison, FitFindsConstantAndSlope)
{
  std::vector<double> taps;
  std::vector<double> times;
  for (int radius = 1; radius <= 6; ++radius)
  {
    taps.push_back(TapsOf(radius));
    times.push_back(0.25 + 0.002 * taps.back());
  }
  const LineFit exact = FitLine(taps, times);
  EXPECT_NEAR(exact.Constant, 0.25, 1e-9);
  EXPECT_NEAR(exact.Slope, 0.002, 1e-12);
  EXPECT_LT(exact.Worst, 1e-9);
  times[2] *= 1.1;
  const LineFit disturbed = FitLine(taps, times);
  EXPECT_GT(disturbed.Worst, 0.05);
  EXPECT_LT(disturbed.Residual, disturbed.Worst);
  EXPECT_EQ(FitLine({ 64.0, 64.0 }, { 1.0, 2.0 }).Slope, 0.0) << "one x is no line";
}

TEST(Comparison, AmplitudeOfAFollowerAndOfALowPass)
{
  // Make a signal that follows a relief, and the same signal through a settled first-order low-pass
  // filter. Both signals drift.
  constexpr int period = 50;
  constexpr double smoothing = 0.9;
  std::vector<double> followed;
  std::vector<double> damped;
  double state = 0.0;
  for (int i = 0; i < 20 * period; ++i)
  {
    const double height = std::sin(TwoPi * i / period + 0.3);
    state = smoothing * state + (1.0 - smoothing) * height;
    if (i >= 10 * period)
    {
      followed.push_back(height + 5.0 + 0.01 * i);
      damped.push_back(state - 0.002 * i);
    }
  }
  const double w = TwoPi / period;
  const double theory =
    (1.0 - smoothing) / std::sqrt(1.0 - 2.0 * smoothing * std::cos(w) + smoothing * smoothing);
  EXPECT_NEAR(AmplitudeOf(followed, w), 1.0, 1e-9);
  EXPECT_NEAR(AmplitudeOf(damped, w), theory, 1e-6);
  EXPECT_EQ(AmplitudeOf({ 1.0, 2.0 }, w), 0.0);
}

TEST(Comparison, CutOffLiesBetweenTheWavelengthsAroundIt)
{
  EXPECT_NEAR(CutOff({ 2.0, 8.0 }, { 0.5, 2.0 * std::sqrt(0.5) - 0.5 }), 4.0, 1e-9);
  EXPECT_EQ(CutOff({ 2.0, 8.0 }, { 0.8, 0.9 }), 0.0);
}

TEST(Comparison, LongWavesAreFeltWholeAndShortOnesAsTheKernelSmoothsThem)
{
  // PRECISE follows an iso-level of the volume smoothed by a Gaussian of 1.12 voxels.
  const double scale = 2.0 * VolumeHaptics::GradientKernel::OwnScalePerRadius;
  const auto smoothed = [scale](double wavelength)
  { return std::exp(-0.5 * std::pow(TwoPi * scale / wavelength, 2.0)); };
  EXPECT_NEAR(MeasureRelief(Precise(), 40.0), smoothed(40.0), 0.01);
  EXPECT_NEAR(MeasureRelief(Precise(), 10.0), smoothed(10.0), 0.06);
  EXPECT_NEAR(MeasureRelief(SurfaceHaptics(), 40.0), 1.0, 0.03);
}

TEST(Comparison, APlaneFeelsTheSameByPreciseAndBySurfaceHaptics)
{
  Scene scene(
    SampleImage([](const Vector3& x) { return 100.0 * Dot(x - OddCentre, OddNormal); }, 12.0), 0.0);
  Stroke stroke{ OddCentre, -1.0 * OddNormal, { OddCentre }, 0 };
  MoveTo(stroke.Tips, OddCentre + 1.5 * OddNormal, 0.02);
  stroke.Pressed = stroke.Tips.size();
  MoveTo(stroke.Tips, OddCentre + 1.5 * OddNormal + 6.0 * OddAside, 0.1);
  for (const double friction : { 0.0, 0.3 })
  {
    scene.SetMaterial(500.0, friction);
    const Trace reference = scene.Feel(SurfaceHaptics(), stroke);
    Differences differences;
    differences.Add(stroke, reference, scene.Feel(Precise(), stroke));
    ASSERT_GT(differences.Percent.size(), 100u);
    EXPECT_LT(SpreadOf(differences.Percent).RootMeanSquare, 0.5);
    EXPECT_LT(SpreadOf(differences.Stiffness).P95, 0.5);
    EXPECT_LT(SpreadOf(differences.Degrees).P95, 0.5);
    EXPECT_EQ(FractionBelow(differences.Percent, ForceThresholds.Lower), 100.0);
    // The comparison must detect a known difference: 10 % more stiffness gives a difference of 10
    // %.
    scene.SetMaterial(550.0, friction);
    Differences stiffer;
    stiffer.Add(stroke, reference, scene.Feel(Precise(), stroke));
    EXPECT_NEAR(SpreadOf(stiffer.Stiffness).P95, 10.0, 0.5);
    EXPECT_EQ(FractionBelow(stiffer.Percent, ForceThresholds.Lower), 0.0);
  }
}

TEST(Comparison, SaysWhyThereIsNoBone)
{
  std::string error;
  EXPECT_TRUE(MakeBone(nullptr, BoneValue, {}, error).empty());
  EXPECT_NE(error.find("--volume"), std::string::npos) << error;
  const auto soft = SampleImage([](const Vector3& x) { return x.Z; }, 4.0);
  EXPECT_TRUE(MakeBone(soft, BoneValue, {}, error).empty());
  EXPECT_NE(error.find("300"), std::string::npos) << error;
  EXPECT_NE(error.find("from -4 to 4"), std::string::npos) << error;
}
} // namespace
