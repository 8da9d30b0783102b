// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Volumes that move under a tip that rests, whose forces have closed forms: the surface is where
 * the analytic volume has it, a spring of stiffness k pulls from the tip to it, and what is above
 * T_N slips.
 */

#include "Core/Model/HapticModel.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <list>
#include <vector>

using namespace coretest;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double K = 500.0;    // N/m
constexpr double Width = 1.5;  // mm, of the edges
constexpr double Period = 1.0; // s, of the ball
constexpr double Dt = 1e-3;    // s, of a tick
/// N, of 1.5 N.
constexpr double OnePercent = 0.015;

/// Where (mm along x) a surface is at a time (s).
using Place = std::function<double(double)>;

double BallRadius(double t)
{
  return 20.0 + 2.0 * std::sin(2.0 * Pi * t / Period);
}

/// Frames of a volume: 26 x 25 x 25 voxels of 1 mm, the middle of whose x side is `From`.
class Movie
{
public:
  using Value = std::function<double(double x, double y, double z, double t)>;

  Movie(const Value& value, double from, double end, double step)
    : From(from)
  {
    for (int i = 0; i * step < end + 0.5 * step; ++i)
    {
      const double t = i * step;
      TestVolume& frame =
        this->Volumes.emplace_back(ScalarType::Float64, std::array<std::int64_t, 3>{ 26, 25, 25 });
      frame.Fill<double>(
        [&](std::int64_t x, std::int64_t y, std::int64_t z)
        {
          return value(from + static_cast<double>(x), static_cast<double>(y) - 12.0,
            static_cast<double>(z) - 12.0, t);
        });
      this->Frames.push_back({ t, frame.View, nullptr });
    }
  }

  HapticModelDescription Describe() const
  {
    HapticModelDescription description = coretest::Describe(this->Volumes.front());
    description.Frames = this->Frames;
    description.IndexToWorld.Offset = { this->From, -12.0, -12.0 };
    description.Material.Stiffness = ConstantPolyline(K);
    description.Settings.Placement = MaterialPlacement::Kernel;
    description.Settings.Alignment = ContactAlignment::Edge;
    return description;
  }

private:
  const double From;
  std::list<TestVolume> Volumes;
  std::vector<VolumeFrame> Frames;
};

Movie MakeBall(double step)
{
  return { [](double x, double y, double z, double t)
    {
      const double rho = std::sqrt(x * x + y * y + z * z);
      return 500.0 * (1.0 - std::tanh((rho - BallRadius(t)) / Width));
    },
    6.0, 2.0, step };
}

/// A wall on the side of lower x, whose surface is at an x that moves.
Movie MakeWall(const Place& at, double step)
{
  return { [at](double x, double, double, double t)
    { return 500.0 * (1.0 - std::tanh((x - at(t)) / Width)); },
    6.0, 2.0, step };
}

/// A hand that goes straight to a place on the x axis while time holds, and then rests there.
class RestingHand
{
public:
  RestingHand(const HapticModelDescription& description, double from, double to)
    : Model(description)
    , At{ 0.001 * to, 0.0, 0.0 }
  {
    const int ticks = static_cast<int>(std::abs(from - to) / 0.01);
    for (int i = 0; i <= ticks; ++i)
    {
      this->Touch({ 0.001 * (from + (to - from) * i / std::max(1, ticks)), 0.0, 0.0 });
    }
  }

  /// A tick, at a data time.
  const TickRecord& Go(double time)
  {
    this->State.DataTime = time;
    return this->Touch(this->At);
  }

  const TickRecord& Touch(const Vector3& tip)
  {
    VolumeHaptics::Tick(this->Model, this->State, tip, this->Record);
    return this->Record;
  }

  const HapticModel Model;
  const Vector3 At;
  ServoState State;
  TickRecord Record;
};

HapticModelDescription WithStrength(HapticModelDescription description, double strength)
{
  description.Material.SurfaceStrength = ConstantPolyline(strength);
  return description;
}

/// The Gaussian's blur moves the surface of a ball by 0.03 mm, as the evaluation shows; this one's
/// by 0.016 mm.
HapticModelDescription WithSpline(HapticModelDescription description)
{
  description.Estimator = GradientEstimator::CubicBSpline;
  return description;
}

/// V5: frames that are all the same volume, 10 ms apart, are felt as one that stands still.
template <typename TipAt>
void ExpectFramesAlike(HapticModelDescription description, int frames, int ticks, TipAt tipAt)
{
  description.Frames.clear();
  const HapticModel still(description);
  for (int i = 0; i < frames; ++i)
  {
    description.Frames.push_back({ 0.01 * i, description.View, nullptr });
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

/// V1 of the derivations: f = k max(0, r - 19 mm).
TEST(MovingVolume, ABallThatPulsatesPushesARestingHand)
{
  const Movie ball = MakeBall(0.01);
  RestingHand hand(WithSpline(WithStrength(ball.Describe(), 2.0)), 24.0, 19.0);
  EXPECT_NEAR(hand.Record.Force.X, 0.5, 0.01);
  double before = hand.Record.Force.X;
  for (double t = Dt; t < 2.0; t += Dt)
  {
    const Vector3 force = hand.Go(t).Force;
    EXPECT_NEAR(force.X, 0.001 * K * std::max(0.0, BallRadius(t) - 19.0), OnePercent) << "at " << t;
    EXPECT_NEAR(force.Y, 0.0, 1e-9);
    EXPECT_NEAR(force.Z, 0.0, 1e-9);
    // Twice the step of a surface that is as fast as this one can be.
    EXPECT_LE(std::abs(force.X - before), 2.0 * 0.001 * K * 4.0 * Pi * Dt) << "at " << t;
    before = force.X;
  }
}

/// V2: the surface slips through the proxy at T_N, and on the way back it has the level it reached.
TEST(MovingVolume, ASurfaceThatHoldsLessPushesWithItsStrength)
{
  const Movie ball = MakeBall(0.01);
  RestingHand hand(WithStrength(ball.Describe(), 1.0), 24.0, 19.0);
  for (double t = Dt; t < 0.91; t += Dt)
  {
    const double force = hand.Go(t).Force.X;
    const double sine = std::sin(2.0 * Pi * t);
    const double expected = t < 0.25 ? std::min(1.0, 0.5 + sine) : std::max(0.0, sine);
    EXPECT_NEAR(force, expected, 0.015) << "at " << t;
  }
}

/// V2 for PAPER, which holds a ball before the middle of its edge: how far does not matter once
/// it has slipped at 2 N, 22 mm large. From then on f = 2 N - k (22 mm - r) = 1 N + sin(2 pi t) N,
/// period after period. Only with the spline does V have no ripple from voxel to voxel.
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

/// V3: a wall that comes through a medium at 10 mm/s. The medium moves along and does not drag.
TEST(MovingVolume, AWallThatComesThroughAMediumPushesAlone)
{
  const Place at = [](double t) { return 16.0 + 10.0 * std::min(t, 0.5); };
  const Movie wall = MakeWall(at, 0.02);
  HapticModelDescription description = WithSpline(WithStrength(wall.Describe(), 2.0));
  description.Material.Viscosity = ConstantPolyline(0.5);
  RestingHand hand(description, 20.0, 18.0);
  EXPECT_LT(Norm(hand.Record.Force), 0.51); // of the drag on the way here
  RestingHand rested(description, 18.0, 18.0);
  for (double t = Dt; t < 1.0; t += Dt)
  {
    EXPECT_NEAR(rested.Go(t).Force.X, 0.001 * K * std::max(0.0, at(t) - 18.0), OnePercent)
      << "at " << t;
  }
}

/// V4: between frames, the blend of two edges is an edge half-way, up to a motion of their width.
TEST(MovingVolume, FramesFarApartAreBlendedToAMotion)
{
  for (const double step : { 0.05, 0.1 })
  {
    const Movie ball = MakeBall(step);
    RestingHand hand(WithSpline(WithStrength(ball.Describe(), 2.0)), 24.0, 19.0);
    double before = hand.Record.Force.X;
    for (double t = Dt; t < 1.0; t += Dt)
    {
      // All that the frames tell: where the blend of two edges is half-way.
      const double frame = step * std::floor(t / step);
      const double share = (t - frame) / step;
      double low = 17.5;
      double radius = 22.5;
      for (double high = radius; high - low > 1e-6; radius = 0.5 * (low + high))
      {
        const double blend = (share - 1.0) * std::tanh((radius - BallRadius(frame)) / Width) -
          share * std::tanh((radius - BallRadius(frame + step)) / Width);
        (blend > 0.0 ? low : high) = radius;
      }
      const double force = hand.Go(t).Force.X;
      // The spline blurs by a variance of 1/3 square voxel.
      const double seen = radius - 1.0 / (3.0 * radius);
      EXPECT_NEAR(force, 0.001 * K * std::max(0.0, seen - 19.0), OnePercent)
        << "at " << t << ", frames " << step << " s apart";
      EXPECT_LE(std::abs(force - before), 2.0 * 0.001 * K * 4.0 * Pi * Dt) << "at " << t;
      before = force;
    }
  }
}

/// V5, for both solvers, on a path that also leaves the volume.
TEST(MovingVolume, FramesThatAreAlikeAreAVolumeThatStandsStill)
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
      ExpectFramesAlike(description, 1000, 12000, [&](int) { return wanderer.Next(); });
    }
  }
}

/// V1, V5 and V7 with LOCAL_SURFACE, whose slow loop is up to two periods (33 ms) late: in that
/// time the surface goes by 0.4 mm, which are 0.2 N.
TEST(MovingVolume, ALocalSurfaceIsCarriedBetweenItsFits)
{
  const Movie ball = MakeBall(0.01);
  HapticModelDescription description = ball.Describe();
  description.Settings.Method = HapticMethod::LocalSurface;
  description.Settings.IsoValue = 500.0; // where the ball's surface is
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
  EXPECT_NEAR(most, 2.0e-3, 0.06e-3); // k x^2 / 2 at 3 mm, less that at 1 mm
  EXPECT_NEAR(work, 0.0, 0.06e-3);

  ExpectFramesAlike(description, 100, 1000,
    [](int tick)
    {
      const double angle = 0.01 * tick;
      return Vector3{ 0.020 + 0.003 * std::cos(angle), 0.004 * std::sin(2.0 * angle), 0.001 };
    });
}

/// FORCE_FIELD has no proxy: its force is at all times that of the volume as it is then.
TEST(MovingVolume, AForceFieldPushesAsTheVolumeIs)
{
  const Movie wall = MakeWall([](double t) { return 14.0 + 4.0 * t; }, 0.1);
  HapticModelDescription description = wall.Describe();
  description.Settings.Method = HapticMethod::ForceField;
  description.Settings.ForceFieldGain = 0.01;
  const std::vector<VolumeFrame> frames = description.Frames;
  RestingHand hand(description, 16.0, 16.0);
  description.Frames.clear();
  double strongest = 0.0;
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    description.View = frames[i].View;
    RestingHand still(description, 16.0, 16.0);
    const double expected = still.Go(0.0).Force.X;
    EXPECT_NEAR(hand.Go(frames[i].Time).Force.X, expected, 1e-12) << "at " << frames[i].Time;
    strongest = std::max(strongest, expected);
  }
  EXPECT_GT(strongest, 0.5);
}

/// A rigid motion of a flat wall is felt as the opposite motion of the hand.
TEST(MovingVolume, AWallThatComesIsAHandThatGoes)
{
  struct Choice
  {
    HapticSolver Solver;
    ContactAlignment Alignment;
    MaterialPlacement Placement;
    double Tolerance; // N
  };
  // PAPER begins to hold where a wall is distinct, which is some voxels before it, and depends on
  // where the voxels are.
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

/// V7: a surface that holds gives back what it took; one that slips uses up work.
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
    // k x^2 / 2 at 3 mm, from that at 1 mm; slipping at 1 N uses up the 1 mm above 2 mm.
    EXPECT_NEAR(most, strength > 1.5 ? 2.0e-3 : 0.75e-3 + 1.0e-3, 0.05e-3);
    EXPECT_NEAR(work, strength > 1.5 ? 0.0 : 1.0e-3, 0.05e-3);
  }
}

/// The hand gets no more energy than walls and hand have put in.
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
        // A leap of data time from the end to the beginning is none of the volume.
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

TEST(MovingVolume, HoldsItsEndsBeyondTheFrames)
{
  const Movie wall = MakeWall([](double t) { return 14.0 + 2.0 * t; }, 0.5);
  const HapticModel model(wall.Describe());
  const Vector3 at{ 0.016, 0.0, 0.0 };
  EXPECT_EQ(model.ValueAtDevice(at, -5.0), model.ValueAtDevice(at, 0.0));
  EXPECT_EQ(model.ValueAtDevice(at, 9.0), model.ValueAtDevice(at, 2.0));
  const double between = model.ValueAtDevice(at, 0.75);
  EXPECT_DOUBLE_EQ(between, 0.5 * (model.ValueAtDevice(at, 0.5) + model.ValueAtDevice(at, 1.0)));
}

/// A series may be published in parts: the next part begins with a frame that the last one has.
TEST(MovingVolume, GoesOnFromOnePartOfASeriesToTheNext)
{
  const Movie ball = MakeBall(0.1);
  HapticModelDescription description = WithStrength(ball.Describe(), 2.0);
  description.Number = 77;
  RestingHand whole(description, 24.0, 19.0);
  const std::vector<VolumeFrame> frames = description.Frames;
  const auto part = [&](std::size_t first)
  {
    description.Frames = { frames.begin() + static_cast<std::ptrdiff_t>(first),
      frames.begin() + static_cast<std::ptrdiff_t>(first) + 3 };
    description.View = description.Frames.front().View;
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
