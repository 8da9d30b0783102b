// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests moving volumes under a resting tip, with closed forms of the force: the surface is where
 * the analytic volume has it, a spring of stiffness k pulls the tip to the surface, and the surface
 * slips at its strength T_N.
 */

#include "Rigs/MovingRig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace movingtest;

namespace
{
/// 1 % (N) of the largest force, which is 1.5 N.
constexpr double OnePercent = 0.015;

/// A way to sample and read a volume, with the default kernel radius of 2 voxels.
struct Reading
{
  GradientEstimator Estimator;
  double Voxel; ///< mm
};

HapticModelDescription Read(const Reading& reading, HapticModelDescription description)
{
  description.Estimator = reading.Estimator;
  return description;
}

/// Returns the expected force (N) of V1 at the time t (s).
double ForceOfBall(double t)
{
  return 0.001 * K * std::max(0.0, BallRadius(t) - 19.0);
}

/// Returns the expected force (N) of V2 at the time t (s), up to 0.9 s, for a strength of 1 N.
double ForceOfSlipping(double t)
{
  const double sine = std::sin(2.0 * Pi * t);
  return t < 0.25 ? std::min(1.0, 0.5 + sine) : std::max(0.0, sine);
}

/// V5: expects that a series of identical volumes 10 ms apart gives the same force as the volume at
/// rest.
template <typename TipAt>
void ExpectTimeStepsAlike(HapticModelDescription description, int timeSteps, int ticks, TipAt tipAt)
{
  description.TimeSteps.clear();
  const HapticModel still(description);
  for (int i = 0; i < timeSteps; ++i)
  {
    description.TimeSteps.push_back({ 0.01 * i, description.View, nullptr });
  }
  const HapticModel moving(description);
  ServoState state;
  ServoState movingState;
  TickRecord record;
  TickRecord movingRecord;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const Vector3 tip = tipAt(tick);
    Tick(still, state, tip, record);
    movingState.DataTime = 0.001 * tick;
    Tick(moving, movingState, tip, movingRecord);
    ASSERT_TRUE(IsIdentical(record.Force, movingRecord.Force)) << "tick " << tick;
    ASSERT_TRUE(IsIdentical(record.Proxy, movingRecord.Proxy)) << "tick " << tick;
    ASSERT_EQ(record.SurfaceStrength, movingRecord.SurfaceStrength) << "tick " << tick;
    ASSERT_EQ(movingRecord.WallWork, 0.0) << "tick " << tick;
  }
}

} // namespace

/// With a kernel radius of 2 voxels, V1 to V3 hold within 1 % of the largest force, for the cubic
/// B-spline, and for the Gaussian (the default) on edges that are at least three voxels wide. On
/// edges of 1.5 voxels, the Gaussian is off by up to 0.033 voxel, or 16 mN (see
/// MovingEdgeTest.cxx).
class RestingHands : public testing::TestWithParam<Reading>
{
};

TEST_P(RestingHands, V1ABallThatPulsatesPushes)
{
  // V1: f = k max(0, r - 19 mm), at most 1.5 N.
  const Movie ball = MakeBall(0.01, this->GetParam().Voxel);
  RestingHand hand(Read(this->GetParam(), WithStrength(ball.Describe(), 2.0)), 24.0, 19.0);
  EXPECT_NEAR(hand.Record.Force.X, 0.5, 0.01);
  double before = hand.Record.Force.X;
  for (double t = Dt; t < 2.0; t += Dt)
  {
    const Vector3 force = hand.Go(t).Force;
    EXPECT_NEAR(force.X, ForceOfBall(t), OnePercent) << "at " << t;
    EXPECT_NEAR(force.Y, 0.0, 1e-9);
    EXPECT_NEAR(force.Z, 0.0, 1e-9);
    // Allow twice the step of the surface at its largest speed in this test.
    EXPECT_LE(std::abs(force.X - before), 2.0 * 0.001 * K * 4.0 * Pi * Dt) << "at " << t;
    before = force.X;
  }
}

TEST_P(RestingHands, V2ASurfaceThatHoldsLessPushesWithItsStrength)
{
  // V2: the proxy slips through the surface at the strength T_N. On the way back, the surface keeps
  // the level of V that it has reached.
  const Movie ball = MakeBall(0.01, this->GetParam().Voxel);
  RestingHand hand(Read(this->GetParam(), WithStrength(ball.Describe(), 1.0)), 24.0, 19.0);
  for (double t = Dt; t < 0.91; t += Dt)
  {
    const double force = hand.Go(t).Force.X;
    EXPECT_NEAR(force, ForceOfSlipping(t), 0.01) << "at " << t;
  }
}

TEST_P(RestingHands, V3AWallThatComesThroughAMediumPushesAlone)
{
  // V3: the wall moves at 10 mm/s. The medium moves with the wall, so it does not drag the proxy.
  const Place at = [](double t) { return 16.0 + 10.0 * std::min(t, 0.5); };
  const Movie wall = MakeWall(at, 0.02, this->GetParam().Voxel);
  HapticModelDescription description = Read(this->GetParam(), WithStrength(wall.Describe(), 2.0));
  description.Material.Viscosity = ConstantPolyline(0.5);
  RestingHand hand(description, 20.0, 18.0);
  EXPECT_LT(Norm(hand.Record.Force), 0.51); // the drag of the way to the start
  RestingHand rested(description, 18.0, 18.0);
  for (double t = Dt; t < 1.0; t += Dt)
  {
    EXPECT_NEAR(rested.Go(t).Force.X, 0.001 * K * std::max(0.0, at(t) - 18.0), OnePercent)
      << "at " << t;
  }
}

INSTANTIATE_TEST_SUITE_P(MovingVolume, RestingHands,
  testing::Values(
    Reading{ GradientEstimator::CubicBSpline, 1.0 }, Reading{ GradientEstimator::Gaussian, 0.5 }));

/// V2 with the solver Paper, which holds a ball in front of the middle of its edge. This distance
/// has no effect after the surface has slipped at 2 N, at a radius of 22 mm. From then on, the
/// force in each period is 2 N - k (22 mm - r) = 1 N + sin(2 pi t) N. The test uses the spline,
/// because V then has no ripple from voxel to voxel.
TEST(MovingVolume, PaperCarriesByTheLevelAtWhichItSlipped)
{
  const Movie ball = MakeBall(0.01);
  HapticModelDescription description = WithSpline(WithStrength(ball.Describe(), 2.0));
  description.Settings.Solver = HapticSolver::Paper;
  RestingHand hand(description, 24.0, 19.0);
  for (double t = Dt; t < 2.0; t += Dt)
  {
    const double force = hand.Go(t).Force.X;
    if (t >= 0.25)
    {
      EXPECT_NEAR(force, 1.0 + std::sin(2.0 * Pi * t), 0.01) << "at " << t;
    }
  }
}

/// V4 with time steps 50 ms apart: the force is that of V1 within 15 mN (0.02 k times the width of
/// the edge). Between time steps, the blend follows the chord of the surface's path (see the next
/// test), which is off by up to 0.025 mm or 12 mN. The rest is the error of sampling voxels of 0.5
/// mm.
TEST(MovingVolume, TimeStepsFiftyMillisecondsApartAreAsGoodAsTheMotion)
{
  for (const GradientEstimator estimator :
    { GradientEstimator::Gaussian, GradientEstimator::CubicBSpline })
  {
    const Movie ball = MakeBall(0.05, 0.5);
    HapticModelDescription description = WithStrength(ball.Describe(), 2.0);
    description.Estimator = estimator;
    // With a kernel radius of 2 voxels, the B-spline would be off by 15.1 mN.
    description.KernelRadius = estimator == GradientEstimator::Gaussian ? 2 : 3;
    RestingHand hand(description, 24.0, 19.0);
    double before = hand.Record.Force.X;
    for (double t = Dt; t < 1.0; t += Dt)
    {
      const double force = hand.Go(t).Force.X;
      EXPECT_NEAR(force, ForceOfBall(t), 0.001 * K * 0.02 * Width) << "at " << t;
      EXPECT_LE(std::abs(force - before), 2.0 * 0.001 * K * 4.0 * Pi * Dt) << "at " << t;
      before = force;
    }
  }
}

/// V4 with time steps 100 ms apart. If the motion is at most the edge's width, the time steps
/// determine only where the blend of the two edges has its middle value. Between time steps T
/// apart, a surface at r(t) = r0 + a sin(w t) is therefore on the chord from r(t) to r(t + T). The
/// chord is off by at most r'' T^2/8:
///
///   a w^2 T^2/8 = 0.099 mm for a = 2 mm, w = 2 pi/s, T = 0.1 s, and a quarter of it at 50 ms.
///
/// This test therefore compares the force with the blend, and the blend with V1.
TEST(MovingVolume, TimeStepsFarApartAreBlendedToAMotion)
{
  for (const double step : { 0.05, 0.1 })
  {
    const Movie ball = MakeBall(step);
    RestingHand hand(WithSpline(WithStrength(ball.Describe(), 2.0)), 24.0, 19.0);
    double before = hand.Record.Force.X;
    for (double t = Dt; t < 1.0; t += Dt)
    {
      // Search for the radius at which the blend of the two time steps' edges has its middle value.
      // The time steps contain no other information about the motion between them.
      const double timeStep = step * std::floor(t / step);
      const double fraction = (t - timeStep) / step;
      double low = 17.5;
      double radius = 22.5;
      for (double high = radius; high - low > 1e-6; radius = 0.5 * (low + high))
      {
        const double blend = (fraction - 1.0) * std::tanh((radius - BallRadius(timeStep)) / Width) -
          fraction * std::tanh((radius - BallRadius(timeStep + step)) / Width);
        (blend > 0.0 ? low : high) = radius;
      }
      const double force = hand.Go(t).Force.X;
      EXPECT_LE(std::abs(radius - BallRadius(t)), 2.0 * 4.0 * Pi * Pi * step * step / 8.0 + 0.01)
        << "the chord; 0.01 mm of it since a blend of edges is no edge";
      // The spline blurs with a variance of 1/3 voxel^2, which makes a ball of radius r smaller by
      // 1/(3 r).
      const double seen = radius - 1.0 / (3.0 * radius);
      EXPECT_NEAR(force, 0.001 * K * std::max(0.0, seen - 19.0), OnePercent)
        << "at " << t << ", frames " << step << " s apart";
      EXPECT_LE(std::abs(force - before), 2.0 * 0.001 * K * 4.0 * Pi * Dt) << "at " << t;
      before = force;
    }
  }
}

/// V5 for both solvers. The path also leaves the volume.
TEST(MovingVolume, TimeStepsThatAreAlikeAreAVolumeThatStandsStill)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    for (const MaterialPlacement placement :
      { MaterialPlacement::Kernel, MaterialPlacement::FarSide })
    {
      TestVolume volume(ScalarType::Int16, { 24, 24, 24 });
      volume.FillRandom(5);
      HapticModelDescription description = Describe(volume);
      description.Settings.Solver = solver;
      description.Settings.Placement = placement;
      description.Material.Friction = ConstantPolyline(0.3);
      description.Material.Viscosity = ConstantPolyline(0.1);
      Wanderer wanderer(24.0);
      ExpectTimeStepsAlike(description, 1000, 12000, [&](int) { return wanderer.Next(); });
    }
  }
}

/// V1, V5 and V7 with the method LocalSurface. The slow loop is up to two periods (33 ms) late. In
/// this time, the surface moves by up to 0.4 mm, which changes the force by 0.2 N.
TEST(MovingVolume, ALocalSurfaceIsCarriedBetweenItsFits)
{
  const Movie ball = MakeBall(0.01);
  HapticModelDescription description = ball.Describe();
  description.Settings.Method = HapticMethod::LocalSurface;
  description.Settings.IsoValue = 500.0; // the value of the ball's surface
  description.Settings.HasIsoSurface = true;
  RestingHand hand(description, 24.0, 19.0);
  EXPECT_NEAR(hand.Record.Force.X, 0.5, 0.01);
  double work = 0.0;
  double most = 0.0;
  double before = hand.Record.Force.X;
  for (double t = Dt; t < 1.0 + 0.5 * Dt; t += Dt)
  {
    const double force = hand.Go(t).Force.X;
    EXPECT_NEAR(force, 0.001 * K * std::max(0.0, BallRadius(t) - 19.0), OnePercent) << "at " << t;
    EXPECT_LE(std::abs(force - before), 2.0 * 0.001 * K * 4.0 * Pi * Dt) << "at " << t;
    before = force;
    work += hand.Record.WallWork;
    most = std::max(most, work);
  }
  EXPECT_NEAR(most, 2.0e-3, 0.06e-3); // J: k x^2 / 2 at 3 mm, minus that at 1 mm
  EXPECT_NEAR(work, 0.0, 0.06e-3);

  ExpectTimeStepsAlike(description, 100, 1000,
    [](int tick)
    {
      const double angle = 0.01 * tick;
      return Vector3{ 0.020 + 0.003 * std::cos(angle), 0.004 * std::sin(2.0 * angle), 0.001 };
    });
}

/// The method ForceField has no proxy, so its force depends only on the volume at the present time.
TEST(MovingVolume, AForceFieldPushesAsTheVolumeIs)
{
  const Movie wall = MakeWall([](double t) { return 14.0 + 4.0 * t; }, 0.1);
  HapticModelDescription description = wall.Describe();
  description.Settings.Method = HapticMethod::ForceField;
  description.Settings.ForceFieldGain = 0.01;
  const std::vector<VolumeTimeStep> timeSteps = description.TimeSteps;
  RestingHand hand(description, 16.0, 16.0);
  description.TimeSteps.clear();
  double strongest = 0.0;
  for (std::size_t i = 1; i < timeSteps.size(); ++i)
  {
    description.View = timeSteps[i].View;
    RestingHand still(description, 16.0, 16.0);
    const double expected = still.Go(0.0).Force.X;
    EXPECT_NEAR(hand.Go(timeSteps[i].Time).Force.X, expected, 1e-12) << "at " << timeSteps[i].Time;
    strongest = std::max(strongest, expected);
  }
  EXPECT_GT(strongest, 0.5);
}

/// A flat wall that moves gives the same force as a wall at rest under a hand that moves in the
/// opposite direction.
TEST(MovingVolume, AWallThatComesIsAHandThatGoes)
{
  struct Choice
  {
    HapticSolver Solver;
    ContactAlignment Alignment;
    MaterialPlacement Placement;
    double Tolerance; // N
  };
  // The solver Paper begins to hold some voxels in front of a wall, where the wall is distinct.
  // This place depends on the samples, so Paper needs the larger tolerance.
  const Choice choices[] = {
    { HapticSolver::Paper, ContactAlignment::Distinctness, MaterialPlacement::Kernel, 0.07 },
    { HapticSolver::Precise, ContactAlignment::Edge, MaterialPlacement::Kernel, 0.015 },
    { HapticSolver::Precise, ContactAlignment::Edge, MaterialPlacement::FarSide, 0.015 },
  };
  const Movie moving = MakeWall([](double t) { return 14.0 + 10.0 * t; }, 0.02);
  const Movie still = MakeWall([](double) { return 14.0; }, 0.02);
  for (const Choice& choice : choices)
  {
    HapticModelDescription description = WithStrength(moving.Describe(), 1.0);
    HapticModelDescription other = WithStrength(still.Describe(), 1.0);
    for (HapticModelDescription* d : { &description, &other })
    {
      d->Settings.Solver = choice.Solver;
      d->Settings.Alignment = choice.Alignment;
      d->Settings.Placement = choice.Placement;
      d->Material.Distinctness = { { 20.0, 0.0 }, { 60.0, 1.0 } };
    }
    RestingHand resting(description, 20.0, 20.0);
    RestingHand going(other, 20.0, 20.0);
    double largest = 0.0;
    for (double t = Dt; t < 1.0; t += Dt)
    {
      const double force = resting.Go(t).Force.X;
      const double expected = going.Touch({ 0.020 - 0.010 * t, 0.0, 0.0 }).Force.X;
      EXPECT_NEAR(force, expected, choice.Tolerance)
        << "at " << t << ", choice " << &choice - choices;
      largest = std::max(largest, expected);
    }
    EXPECT_GT(largest, 0.9);
  }
}

/// V7: over a period, a surface that holds returns the work that it took. A surface that slips
/// loses work.
TEST(MovingVolume, APeriodTakesNoWorkUnlessTheSurfaceSlips)
{
  const Movie ball = MakeBall(0.01);
  for (const double strength : { 2.0, 1.0 })
  {
    RestingHand hand(WithStrength(ball.Describe(), strength), 24.0, 19.0);
    double work = 0.0;
    double most = 0.0;
    for (double t = Dt; t < 1.0 + 0.5 * Dt; t += Dt)
    {
      work += hand.Go(t).WallWork;
      most = std::max(most, work);
    }
    // The largest work is the spring's energy k x^2 / 2 at 3 mm minus that at 1 mm. A surface that
    // slips at 1 N loses 1 N times the 1 mm beyond a depth of 2 mm.
    EXPECT_NEAR(most, strength > 1.5 ? 2.0e-3 : 0.75e-3 + 1.0e-3, 0.05e-3);
    EXPECT_NEAR(work, strength > 1.5 ? 0.0 : 1.0e-3, 0.05e-3);
  }
}

/// The hand must get back at most the energy that the walls and the hand have put in.
TEST(MovingVolume, GivesNoMoreThanTheWallsWork)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    for (const MaterialPlacement placement :
      { MaterialPlacement::Kernel, MaterialPlacement::FarSide })
    {
      const Movie ball = MakeBall(0.01);
      HapticModelDescription description = WithStrength(ball.Describe(), 1.5);
      description.Settings.Solver = solver;
      description.Settings.Placement = placement;
      description.Material.Friction = ConstantPolyline(0.2);
      const HapticModel model(description);
      std::mt19937_64 engine(3);
      std::uniform_real_distribution<double> uniform(-1.0, 1.0);
      ServoState state;
      TickRecord record;
      Vector3 tip{ 0.020, 0.0, 0.0 };
      Tick(model, state, tip, record);
      double given = 0.0;
      double least = 0.0;
      double walls = 0.0;
      for (int tick = 1; tick < 20000; ++tick)
      {
        const Vector3 before = tip;
        const Vector3 force = record.Force;
        const double phase = 0.001 * tick;
        tip = { 0.020 + 0.003 * std::sin(7.1 * phase), 0.002 * std::sin(5.3 * phase),
          0.001 * uniform(engine) * 0.01 };
        state.DataTime = std::fmod(phase, 1.0);
        // The jump of the data time from the end to the beginning is not a motion of the volume.
        state.CarriedTo = state.DataTime < state.CarriedTo ? 0.0 : state.CarriedTo;
        Tick(model, state, tip, record);
        given += 0.5 * Dot(force + record.Force, tip - before);
        walls += record.WallWork;
        ASSERT_LT(given, walls + 1e-4) << "tick " << tick;
        least = std::min(least, given);
      }
      EXPECT_LT(least, -1e-3);
    }
  }
}

TEST(MovingVolume, HoldsItsEndsBeyondTheTimeSteps)
{
  const Movie wall = MakeWall([](double t) { return 14.0 + 2.0 * t; }, 0.5);
  const HapticModel model(wall.Describe());
  const Vector3 at{ 0.016, 0.0, 0.0 };
  EXPECT_EQ(model.ValueAtDevice(at, -5.0), model.ValueAtDevice(at, 0.0));
  EXPECT_EQ(model.ValueAtDevice(at, 9.0), model.ValueAtDevice(at, 2.0));
  const double between = model.ValueAtDevice(at, 0.75);
  EXPECT_DOUBLE_EQ(between, 0.5 * (model.ValueAtDevice(at, 0.5) + model.ValueAtDevice(at, 1.0)));
}

/// A series may be published in parts, each of which begins with the last time step of the previous
/// one.
TEST(MovingVolume, GoesOnFromOnePartOfASeriesToTheNext)
{
  const Movie ball = MakeBall(0.1);
  HapticModelDescription description = WithStrength(ball.Describe(), 2.0);
  description.Number = 77;
  RestingHand whole(description, 24.0, 19.0);
  const std::vector<VolumeTimeStep> timeSteps = description.TimeSteps;
  const auto part = [&](std::size_t first)
  {
    description.TimeSteps = { timeSteps.begin() + static_cast<std::ptrdiff_t>(first),
      timeSteps.begin() + static_cast<std::ptrdiff_t>(first) + 3 };
    description.View = description.TimeSteps.front().View;
    return std::make_unique<HapticModel>(description);
  };
  RestingHand parted(description, 24.0, 19.0);
  std::size_t first = 0;
  std::unique_ptr<HapticModel> model = part(first);
  ServoState state = parted.State;
  TickRecord record = parted.Record;
  for (double t = Dt; t < 1.0; t += Dt)
  {
    if (t > 0.1 * static_cast<double>(first + 1) + 0.03)
    {
      std::unique_ptr<HapticModel> next = part(++first);
      CarryState(*model, *next, state);
      model = std::move(next);
    }
    state.DataTime = t;
    VolumeHaptics::Tick(*model, state, parted.At, record);
    ASSERT_TRUE(IsIdentical(record.Force, whole.Go(t).Force)) << "at " << t;
  }
}
