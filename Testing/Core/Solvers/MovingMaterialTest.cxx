// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests volumes whose time steps have displacements, which describe the motion of the material. The
 * expected forces are closed forms, or those of the same hand in the material's coordinates: a
 * volume that moves as a whole under a resting hand feels like a volume at rest under a hand that
 * moves in the opposite direction.
 */

#include "Core/Model/HapticModel.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <list>
#include <vector>

using namespace coretest;

namespace
{
constexpr double MaterialK = 500.0; // N/m
constexpr double MaterialDt = 1e-3; // s per tick

/// A series of time steps with displacements, one unit of time apart, of 28 x 26 x 24 voxels.
class MaterialMovie
{
public:
  using Value = std::function<double(const Vector3& index, int timeStep)>;
  using Motion = std::function<Vector3(const Vector3& index, int timeStep)>;
  static constexpr std::int64_t N[3] = { 28, 26, 24 };

  /// @param motion returns the displacement (world units) at an index
  MaterialMovie(int timeSteps, const Value& value, const Motion& motion, bool isSingle = false)
  {
    for (int timeStep = 0; timeStep < timeSteps; ++timeStep)
    {
      TestVolume& volume = this->Volumes.emplace_back(
        ScalarType::Float64, std::array<std::int64_t, 3>{ N[0], N[1], N[2] });
      volume.Fill<double>([&](std::int64_t i, std::int64_t j, std::int64_t k)
        { return value(At(i, j, k), timeStep); });
      this->TimeSteps.push_back({ static_cast<double>(timeStep), volume.View, nullptr });
      if (motion && timeStep + 1 < timeSteps)
      {
        this->TimeSteps.back().Displacements = isSingle
          ? DisplacementView{ this->Fill(this->Singles.emplace_back(), motion, timeStep),
              ScalarType::Float32 }
          : DisplacementView{ this->Fill(this->Doubles.emplace_back(), motion, timeStep),
              ScalarType::Float64 };
      }
    }
  }

  HapticModelDescription Describe() const
  {
    HapticModelDescription description = coretest::Describe(this->Volumes.front());
    description.TimeSteps = this->TimeSteps;
    description.Material.Stiffness = ConstantPolyline(MaterialK);
    description.Settings.Placement = MaterialPlacement::Kernel;
    description.Settings.Alignment = ContactAlignment::Edge;
    return description;
  }

  std::vector<VolumeTimeStep> TimeSteps;

private:
  static Vector3 At(std::int64_t i, std::int64_t j, std::int64_t k)
  {
    return { static_cast<double>(i), static_cast<double>(j), static_cast<double>(k) };
  }

  template <typename T>
  static const void* Fill(std::vector<T>& numbers, const Motion& motion, int timeStep)
  {
    for (std::int64_t at = 0; at < N[0] * N[1] * N[2]; ++at)
    {
      const Vector3 u = motion(At(at % N[0], at / N[0] % N[1], at / (N[0] * N[1])), timeStep);
      for (const double number : { u.X, u.Y, u.Z })
      {
        numbers.push_back(static_cast<T>(number));
      }
    }
    return numbers.data();
  }

  std::list<TestVolume> Volumes;
  std::list<std::vector<float>> Singles;
  std::list<std::vector<double>> Doubles;
};

/// Returns the value at an index of a bumpy wall, which is at x < `place`.
double BumpyWall(const Vector3& index, double place, double width = 1.5)
{
  const double bumps = 0.4 * std::sin(0.3 * index.Y) * std::cos(0.2 * index.Z);
  return 500.0 * (1.0 - std::tanh((index.X - place - bumps) / width));
}

struct MaterialHand
{
  explicit MaterialHand(const HapticModelDescription& description)
    : Model(description)
  {
  }
  const TickRecord& Touch(const Vector3& tip, double time)
  {
    this->State.DataTime = time;
    VolumeHaptics::Tick(this->Model, this->State, tip, this->Record);
    return this->Record;
  }
  const HapticModel Model;
  ServoState State;
  TickRecord Record;
};

/// Returns a rotated grid whose voxels are not cubes.
Affine3 ObliqueGrid()
{
  constexpr double c = 0.8;
  constexpr double s = 0.6;
  return { { { { c, -s * 1.1, 0.0 }, { s, c * 1.1, 0.0 }, { 0.0, 0.0, 0.9 } } },
    { 3.0, -7.0, 5.0 } };
}
} // namespace

/// V6 of the derivations: a moving volume gives the same force as a volume at rest under a hand
/// that moves in the opposite direction. The motion between time steps is a whole number of voxels,
/// so that sampling adds no error.
TEST(MovingMaterial, AVolumeThatMovesIsAHandThatGoes)
{
  struct Choice
  {
    HapticSolver Solver;
    ContactAlignment Alignment;
    MaterialPlacement Placement;
    bool IsSingle;
    double Strength;
    double Friction;
    double Drag;
  };
  // Compare single ticks that start from the same state, as well as whole paths. With the solver
  // Precise, rounding decides what happens where friction and drag release the proxy together, or
  // at an edge whose width is a thousandth of its height (kernel materials with alignment Edge).
  // Where a graded edge (far side) gives way, rounding errors grow from tick to tick, up to the
  // tolerance of a motion.
  const Choice choices[] = {
    { HapticSolver::Paper, ContactAlignment::Distinctness, MaterialPlacement::Kernel, false, 5.0,
      0.3, 0.1 },
    { HapticSolver::Precise, ContactAlignment::Distinctness, MaterialPlacement::Kernel, false, 5.0,
      0.3, 0.0 },
    { HapticSolver::Precise, ContactAlignment::Edge, MaterialPlacement::FarSide, true, 5.0, 0.3,
      0.0 },
    { HapticSolver::Precise, ContactAlignment::Edge, MaterialPlacement::FarSide, false, 0.0, 0.0,
      0.3 },
  };
  const Affine3 grid = ObliqueGrid();
  const Vector3 step{ 2.0, 1.0, -1.0 }; // voxels per time step
  const Vector3 velocity = grid.Linear * step;
  for (const Choice& choice : choices)
  {
    const MaterialMovie movie(
      4,
      [&](const Vector3& index, int timeStep)
      { return BumpyWall(index - static_cast<double>(timeStep) * step, 8.0); },
      [&](const Vector3&, int) { return velocity; }, choice.IsSingle);
    HapticModelDescription description = movie.Describe();
    description.IndexToWorld = grid;
    description.Settings.Solver = choice.Solver;
    description.Settings.Alignment = choice.Alignment;
    description.Settings.Placement = choice.Placement;
    description.Material.SurfaceStrength = ConstantPolyline(choice.Strength);
    description.Material.Friction = ConstantPolyline(choice.Friction);
    description.Material.Viscosity = ConstantPolyline(choice.Drag);
    const HapticModelDescription movingDescription = description;
    MaterialHand moving(movingDescription);
    description.TimeSteps.clear();
    MaterialHand still(description);
    MaterialHand tickwise(movingDescription);
    const bool isGraded = choice.Alignment == ContactAlignment::Edge && choice.Strength > 0.0;
    double before = 0.0;
    double most = 0.0;
    double mostDrag = 0.0;
    for (int tick = 0; tick < 2900; ++tick)
    {
      const double t = MaterialDt * tick;
      const Vector3 index{ 10.0 + 1.5 * t + 3.0 * std::cos(5.0 * t),
        10.0 + t + 2.0 * std::sin(3.0 * t), 13.0 - t };
      const Vector3 tip = 0.001 * grid(index);
      tickwise.State = still.State;
      tickwise.State.CarriedTo = before;
      for (Vector3* place :
        { &tickwise.State.Proxy, &tickwise.State.PreviousTip, &tickwise.State.Precise.ReachedTip })
      {
        *place += 0.001 * before * velocity;
      }
      before = t;
      const Vector3 next = tickwise.Touch(tip, t).Force;
      const TickRecord& felt = moving.Touch(tip, t);
      const TickRecord& expected = still.Touch(tip - 0.001 * t * velocity, 0.0);
      ASSERT_LT(Norm(next - expected.Force), 1e-9)
        << "at " << t << ", choice " << &choice - choices;
      ASSERT_LT(
        Norm(felt.Force - expected.Force), isGraded ? 2e-4 * Norm(expected.Force) + 1e-6 : 1e-6)
        << "at " << t << ", choice " << &choice - choices;
      most = std::max(most, expected.NormalForce);
      mostDrag = std::max(mostDrag, expected.DragForce);
    }
    EXPECT_GE(most, 0.15 * choice.Strength);
    EXPECT_GE(mostDrag, 0.9 * choice.Drag);
  }
}

/// The tissue stretches along a flat wall: a point at y moves along y, while the values at each
/// place remain the same.
TEST(MovingMaterial, ABreathTakesAStickingHandAlong)
{
  constexpr double stretch = 0.2; // per unit of time: rate of the stretch
  constexpr double fixed = 4.0;   // y (mm) that stays at rest
  const MaterialMovie movie(
    2, [](const Vector3& index, int) { return 500.0 * (1.0 - std::tanh((index.X - 12.0) / 1.5)); },
    [](const Vector3& index, int) {
      return Vector3{ 0.0, stretch * (index.Y - fixed), 0.0 };
    });
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    HapticModelDescription description = movie.Describe();
    description.Settings.Solver = solver;
    description.Settings.Alignment = ContactAlignment::Edge;
    description.Material.SurfaceStrength = ConstantPolyline(5.0);
    description.Material.Friction = ConstantPolyline(0.4);
    MaterialHand hand(description);
    const double y0 = 14.0;
    for (int i = 0; i <= 400; ++i)
    {
      hand.Touch({ 0.001 * (14.0 - 0.01 * i), 0.001 * y0, 0.012 }, 0.0);
    }
    const double push = hand.Record.NormalForce;
    EXPECT_GT(push, solver == HapticSolver::Precise ? 0.99 : 0.5);
    double work = 0.0;
    for (double t = MaterialDt; t < 1.0; t += MaterialDt)
    {
      const TickRecord& felt = hand.Touch({ 0.010, 0.001 * y0, 0.012 }, t);
      // The material of the first contact carries the proxy along. Beyond the friction cone, the
      // proxy slides. The hand rests, so the material below the proxy now comes from a smaller y.
      const double along = 0.001 * MaterialK * stretch * t * (y0 - fixed);
      EXPECT_NEAR(felt.Force.Y, std::min(along, 0.4 * push), 2e-3) << "at " << t;
      EXPECT_NEAR(felt.Force.X, push, 1e-6) << "at " << t;
      work += felt.WallWork;
    }
    // The spring is stretched up to q = mu F / k, where the proxy slips. From then on, the wall
    // does work against the friction mu F.
    const double grip = 0.4 * push;
    const double held = grip / (0.001 * MaterialK * stretch * (y0 - fixed)); // s
    const double slid = stretch * (y0 - fixed) * (1.0 - held) * 0.001;
    EXPECT_NEAR(work, 0.5 * grip * grip / MaterialK + grip * slid, 0.05 * work);
  }
}

/// A wall moves by 3.5 of its widths per time step, and back. Without displacements, the volume is
/// a cross-fade of two time steps, in which no wall moves.
TEST(MovingMaterial, AFastWallIsAWallAllTheWay)
{
  const auto place = [](double t) { return 10.0 + 5.3 * (t < 1.0 ? t : 2.0 - t); };
  const MaterialMovie movie(
    3, [&](const Vector3& index, int timeStep) { return BumpyWall(index, place(timeStep)); },
    [&](const Vector3&, int timeStep) {
      return Vector3{ timeStep == 0 ? 5.3 : -5.3, 0.0, 0.0 };
    });
  HapticModelDescription description = movie.Describe();
  description.Material.SurfaceStrength = ConstantPolyline(5.0);
  // Largest error (mm) of the surface's position, without displacements and with them.
  double worst[2] = { 0.0, 0.0 };
  for (const bool isKnown : { false, true })
  {
    for (VolumeTimeStep& timeStep : description.TimeSteps)
    {
      timeStep.Displacements.Data = isKnown ? timeStep.Displacements.Data : nullptr;
    }
    MaterialHand hand(description);
    for (double t = 0.0; t < 2.0; t += MaterialDt)
    {
      const double force = hand.Touch({ 0.013, 0.012, 0.012 }, t).Force.X;
      const double bumps = 0.4 * std::sin(3.6) * std::cos(2.4);
      const double depth = std::max(0.0, place(t) + bumps - 13.0);
      // Measure the distance along x. The bumps tilt the surface, so the distance along the normal
      // is slightly shorter.
      const double off = std::abs(force - 0.001 * MaterialK * depth) / (0.001 * MaterialK);
      worst[isKnown] = std::max(worst[isKnown], off);
    }
    description.TimeSteps = movie.TimeSteps;
  }
  EXPECT_LT(worst[1], 0.02);
  EXPECT_GT(worst[0], 0.5);
}

/// Displacements of zero give the plain blend of two time steps.
TEST(MovingMaterial, DisplacementsOfZeroAreABlend)
{
  const MaterialMovie movie(
    3, [](const Vector3& index, int timeStep) { return BumpyWall(index, 12.0 + 0.3 * timeStep); },
    [](const Vector3&, int) { return Vector3{}; });
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    HapticModelDescription description = movie.Describe();
    description.Settings.Solver = solver;
    description.Material.Friction = ConstantPolyline(0.3);
    MaterialHand known(description);
    for (VolumeTimeStep& timeStep : description.TimeSteps)
    {
      timeStep.Displacements.Data = nullptr;
    }
    MaterialHand unknown(description);
    Wanderer wanderer(26.0);
    int touched = 0;
    for (int tick = 0; tick < 4000; ++tick)
    {
      const Vector3 tip = wanderer.Next();
      const double time = 5e-4 * tick;
      const Vector3 difference = known.Touch(tip, time).Force - unknown.Touch(tip, time).Force;
      ASSERT_LT(Norm(difference), 1e-6) << "tick " << tick; // N
      touched += Norm(known.Record.Force) > 0.1 ? 1 : 0;
    }
    EXPECT_GT(touched, 100) << "the hand feels little";
  }
}

/// Each tick advances the time by several time steps, forwards and backwards. The expected places
/// are those of the analytic motion.
TEST(MovingMaterial, MaterialIsTrackedThroughTimeStepsBothWays)
{
  const auto at = [](double y, double t) { return 13.0 + (y - 13.0) * (1.0 + 0.15 * t); };
  // The displacement of a time step leads from y to the place of the same material one time step
  // later.
  const MaterialMovie movie(
    4, [](const Vector3& index, int) { return index.X; },
    [&](const Vector3& index, int timeStep)
    {
      const double material = 13.0 + (index.Y - 13.0) / (1.0 + 0.15 * timeStep);
      return Vector3{ 0.0, at(material, timeStep + 1.0) - index.Y, 0.0 };
    });
  const HapticModel model(movie.Describe());
  const auto follow = [&](const Vector3& index, double from, double to)
  { return model.Baked->TrackMaterial(index, from, to); };
  const double times[] = { -1.0, 0.0, 0.3, 1.0, 1.7, 2.0, 2.9, 3.0, 4.0 };
  for (const double from : times)
  {
    for (const double to : times)
    {
      const Vector3 begin{ 9.0, at(15.0, std::clamp(from, 0.0, 3.0)), 11.0 };
      const Vector3 end = follow(begin, from, to);
      EXPECT_NEAR(end.Y, at(15.0, std::clamp(to, 0.0, 3.0)), 1e-9) << from << " to " << to;
      EXPECT_EQ(end.X, 9.0);
      EXPECT_EQ(end.Z, 11.0);
    }
  }
}

/// A displacement of 5 voxels that varies in space. Places must be right within 1e-5 voxel, and
/// slopes must equal difference quotients.
TEST(MovingMaterial, PlacesInBetweenAreThoseOfTheMaterial)
{
  const auto motion = [](const Vector3& x)
  {
    return Vector3{ 5.0 * std::sin(0.0628 * x.X + 0.3), 1.5 * std::sin(0.1 * x.Z),
      std::cos(0.09 * x.Y) };
  };
  const MaterialMovie movie(
    2, [](const Vector3& index, int) { return index.X; },
    [&](const Vector3& index, int) { return motion(index); });
  const HapticModel model(movie.Describe());
  const DisplacementField& field = *model.Baked->TimeSteps.front().Motion;
  Wanderer wanderer(18.0);
  for (int i = 0; i < 200; ++i)
  {
    const double fraction = wanderer.Uniform();
    const Vector3 x{ 8.0 + 10.0 * wanderer.Uniform(), 8.0 + 8.0 * wanderer.Uniform(),
      8.0 + 8.0 * wanderer.Uniform() };
    const MaterialPlace place = field.Compute(x, fraction);
    // At a fraction of 0, the displacement is that of the field at the place itself.
    const MaterialPlace own = field.Compute(place.First, 0.0);
    EXPECT_LT(Norm(place.First + fraction * (own.Second - own.First) - x), 1e-5);
    EXPECT_LT(Norm(place.Second - own.Second), 1e-5);
    // The B-spline smooths the field. It deviates by a sixth of the second derivative, at most 5 *
    // 0.0628^2 / 6 voxels.
    EXPECT_LT(Norm(own.Second - own.First - motion(place.First)), 0.006);
    const double h = 1e-3;
    const Vector3 steps[] = { { h, 0, 0 }, { 0, h, 0 }, { 0, 0, h } };
    for (int axis = 0; axis < 3; ++axis)
    {
      const MaterialPlace ahead = field.Compute(x + steps[axis], fraction);
      const MaterialPlace behind = field.Compute(x - steps[axis], fraction);
      const Vector3 first = (0.5 / h) * (ahead.First - behind.First);
      const Vector3 second = (0.5 / h) * (ahead.Second - behind.Second);
      EXPECT_LT(Norm(first - Transpose(place.FirstSlope).Row[axis]), 1e-3);
      EXPECT_LT(Norm(second - Transpose(place.SecondSlope).Row[axis]), 1e-3);
    }
  }
}

/// The gradient that the solver Precise uses must equal the derivative of the value, with
/// displacements that vary in space.
TEST(MovingMaterial, TheGradientIsThatOfTheValue)
{
  const MaterialMovie movie(
    2, [](const Vector3& index, int timeStep) { return BumpyWall(index, 10.0 + 2.0 * timeStep); },
    [](const Vector3& index, int) {
      return Vector3{ 2.0 + 0.5 * std::sin(0.2 * index.Y), 0.7 * std::sin(0.15 * index.X), 0.0 };
    });
  HapticModelDescription description = movie.Describe();
  description.Settings.Solver = HapticSolver::Precise;
  const HapticModel model(description);
  for (const double time : { 0.2, 0.5, 0.9 })
  {
    const FieldAtTime field = model.Baked->At(time);
    for (double x = 7.0; x < 16.0; x += 0.37)
    {
      const Vector3 index{ x, 11.3, 12.6 };
      const FieldSample sample = field.Gradient(index);
      const double h = 1e-4;
      const Vector3 difference{ field.Gradient({ x + h, 11.3, 12.6 }).Value -
          field.Gradient({ x - h, 11.3, 12.6 }).Value,
        field.Gradient({ x, 11.3 + h, 12.6 }).Value - field.Gradient({ x, 11.3 - h, 12.6 }).Value,
        field.Gradient({ x, 11.3, 12.6 + h }).Value - field.Gradient({ x, 11.3, 12.6 - h }).Value };
      EXPECT_LT(Norm((0.5 / h) * difference - sample.Gradient), 1e-3 * Norm(sample.Gradient) + 1e-3)
        << "at " << x << ", " << time;
    }
  }
}

/// With friction, drag and a random hand, the hand must get back at most the energy that hand and
/// material have put in.
TEST(MovingMaterial, GivesNoMoreThanTheMaterialsWork)
{
  const MaterialMovie movie(
    3,
    [](const Vector3& index, int timeStep)
    { return BumpyWall(index, timeStep == 1 ? 14.0 : 11.0); },
    [](const Vector3& index, int timeStep)
    {
      const double side = 0.8 * std::sin(0.3 * index.Z);
      return timeStep == 0 ? Vector3{ 3.0, side, 0.0 } : Vector3{ -3.0, -side, 0.0 };
    });
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    HapticModelDescription description = movie.Describe();
    description.Settings.Solver = solver;
    description.Material.SurfaceStrength = ConstantPolyline(1.5);
    description.Material.Friction = ConstantPolyline(0.3);
    description.Material.Viscosity = ConstantPolyline(0.1);
    MaterialHand hand(description);
    Vector3 tip{ 0.013, 0.013, 0.012 };
    hand.Touch(tip, 0.0);
    double given = 0.0;
    double walls = 0.0;
    double least = 0.0;
    for (int tick = 1; tick < 12000; ++tick)
    {
      const Vector3 before = tip;
      const Vector3 force = hand.Record.Force;
      const double phase = 0.001 * tick;
      tip = { 0.013 + 0.003 * std::sin(7.1 * phase), 0.013 + 0.002 * std::sin(5.3 * phase), 0.012 };
      hand.Touch(tip, 1.0 - std::cos(2.0 * phase));
      given += 0.5 * Dot(force + hand.Record.Force, tip - before);
      walls += hand.Record.WallWork;
      ASSERT_LT(given, walls + 1e-4) << "tick " << tick;
      least = std::min(least, given);
    }
    EXPECT_LT(least, -1e-3);
  }
}

/// V6 for the method ForceField: material that moves past a resting hand drags it like resting
/// material drags a hand that moves in the opposite direction.
TEST(MovingMaterial, TheDragOfAForceFieldIsAgainstTheMaterial)
{
  const MaterialMovie movie(
    3, [](const Vector3& index, int timeStep) { return BumpyWall(index, 11.0 + timeStep); },
    [](const Vector3&, int) {
      return Vector3{ 1.0, 0.0, 0.0 };
    });
  HapticModelDescription description = movie.Describe();
  description.Settings.Method = HapticMethod::ForceField;
  description.Settings.ForceFieldDamping = 50.0;
  MaterialHand hand(description);
  description.TimeSteps.clear();
  MaterialHand still(description);
  double farthest = 0.0;
  for (int tick = 0; tick <= 100; ++tick)
  {
    const double time = 0.02 * tick;
    const Vector3 tip{ 0.011 + 1e-5 * tick, 0.012, 0.011 + 2e-5 * tick };
    const Vector3 force = hand.Touch(tip, time).Force;
    const Vector3 opposite = still.Touch(tip - Vector3{ 0.001 * time, 0.0, 0.0 }, 0.0).Force;
    ASSERT_LT(Norm(force - opposite), 1e-9) << "tick " << tick;
    // Along x, the material moves at 20 mm/s and the hand at 10 mm/s. Along z, the hand moves at 20
    // mm/s.
    const double drag = tick == 0 ? 0.0 : 50.0 * std::hypot(0.010, 0.020);
    ASSERT_NEAR(hand.Record.DragForce, drag, 1e-9) << "tick " << tick;
    farthest = std::max(farthest, Norm(force));
  }
  EXPECT_GT(farthest, 1.0);
}

/// For any displacements, the force must be finite, and a surface must push with at most its
/// strength.
TEST(MovingMaterial, AbsurdDisplacementsMakeNoAbsurdForce)
{
  std::mt19937_64 engine(4);
  const double absurd[] = { 1e300, -1e300, std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN(), 30.0, -8.0, 0.0 };
  const auto any = [&] { return absurd[engine() % 7]; };
  const MaterialMovie movie(
    3, [](const Vector3& index, int timeStep) { return BumpyWall(index, 11.0 + timeStep); },
    [&](const Vector3&, int timeStep) {
      return timeStep == 0 ? Vector3{ any(), any(), any() } : Vector3{ 0.0, 0.01 * any(), 1e5 };
    });
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    HapticModelDescription description = movie.Describe();
    description.Settings.Solver = solver;
    MaterialHand hand(description);
    Wanderer wanderer(24.0);
    for (int tick = 0; tick < 4000; ++tick)
    {
      const TickRecord& record = hand.Touch(wanderer.Next(), 1.0 - std::cos(0.001 * tick));
      ASSERT_TRUE(IsFinite(record.Force) && IsFinite(record.Proxy)) << "tick " << tick;
      ASSERT_LE(record.NormalForce, 2.0 + 1e-9) << "tick " << tick;
    }
  }
}
