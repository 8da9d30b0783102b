// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests bounds for the change of a mode's force when the tip moves.
 *
 * For one set of primitives with fixed anchors, the force is k-Lipschitz in the tip, because the
 * proxy is a proximal map (PrimitiveSolver.h). A mode has different primitives at each place. Let
 * K(x) be the set of forces that the primitives at x can have, and let K change by L along the
 * proxy's path: for each force in K(x), K(x + dx) contains a force that differs by at most L |dx|.
 * For a line along q of strength S, L is |S grad q| + |grad S|, that is, how fast the flow turns
 * and how fast its strength changes. A moving proxy has the force f in K(x) that opposes the motion
 * most: dx.(f - g) <= 0 for all g in K(x). For the forces before and after a motion, this gives
 *
 *   dx.df <= L |dx|^2,   df = k (dx - dy),   and, with q = L/k < 1,
 *   |dx| <= |dy|/(1 - q)                     since dx.df = k (|dx|^2 - dx.dy),
 *   |df|^2 <= k |df| |dy| + k L |dx|^2       since |df|^2 = k df.(dx - dy), and therefore
 *
 *   |df| <= k |dy| (1 + sqrt(1 + 4 q/(1 - q)^2))/2 = k |dy|/(1 - q).
 *
 * On a circle of radius R, with the tip at a distance d inside the circle, q is d/R. If the tip
 * moves to the centre, the proxy runs around the circle. If q is 1 or more, only the strengths
 * bound the change: |df| <= S(x) + S(x + dx). If S(|v|)/|v| and the slope of S are at most s, q is
 * at most s |J|/k for flows and fronts, because S v/|v| is an s-Lipschitz function of v. Flows and
 * fronts are therefore within 1/(1 - q) wherever s |J| < k.
 */

#include "Rigs/ModeGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace modegrid;

namespace
{
constexpr int Ticks = 200000;  // ticks of each mode; all modes together make more than a million
constexpr double Stride = 0.2; // largest motion (mm) per tick along each axis

/// Upper bound of the norm of the flow's Jacobian (per mm). The Jacobian is [0 a 0; 0 0 b; c d 0]
/// with |a| <= 0.4, |b| <= 0.3, |c| <= 0.25, |d| <= 0.1 per mm, and its norm is at most (0.4 *
/// 0.5)^(1/2), the root of the largest row sum times the largest column sum. The flow has many
/// directions, rotation, stretching and places at rest.
constexpr double SteepestSwirl = 0.45;
void Swirl(const Vector3& x, double* v)
{
  v[0] = std::sin(0.4 * x.Y);
  v[1] = std::cos(0.3 * x.Z) - 0.5;
  v[2] = 0.5 * std::sin(0.5 * x.X + 0.2 * x.Y);
}

/// Computes the tensor v v^T + 0.1 of the flow v, changed so that it is flat or elongated in
/// places.
void SwirlTensor(const Vector3& x, double* t)
{
  double v[3];
  Swirl(x, v);
  const double flat = 0.3 * std::sin(0.3 * x.Z);
  const double six[6] = { v[0] * v[0] + 0.1, v[1] * v[1] + 0.1 + flat * flat, v[2] * v[2] + 0.1,
    v[0] * v[1], v[1] * v[2], v[0] * v[2] };
  std::copy_n(six, 6, t);
}

/// Returns the distance (N) from a force to the nearest force that a primitive can have.
double Miss(const Vector3& force, const Primitive& p)
{
  const double along = Dot(force, p.Direction);
  const double across = Norm(force - along * p.Direction);
  switch (p.Kind)
  {
    case PrimitiveKind::Line:
      return std::hypot(along, std::max(0.0, across - p.Strength));
    case PrimitiveKind::Plane:
      return Norm(force - std::clamp(along, 0.0, p.Strength) * p.Direction);
    case PrimitiveKind::Point:
      return std::max(0.0, Norm(force) - p.Strength);
    case PrimitiveKind::Force:
      break;
  }
  return Norm(force - p.Strength * p.Direction);
}

double Miss(const PrimitiveForces& forces, const PrimitiveSet& set)
{
  double sum = 0.0;
  for (int i = 0; i < set.GetSize(); ++i)
  {
    sum += Miss(forces[static_cast<std::size_t>(i)], set[i]);
  }
  return sum;
}

/// Largest force of a walk, largest change of the force, and numbers of steps.
struct Walked
{
  double Strongest = 0.0; ///< N
  double Steepest = 0.0;  ///< |df|/(k |dy|)
  int Steeper = 0;        ///< number of steps with a ratio of more than 1
  int Unbound = 0;        ///< number of those steps with q >= 1
};

class ModeSteps
{
public:
  explicit ModeSteps(ModeGrid& grid)
    : Grid(grid)
  {
  }

  Walked Walk()
  {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> uniform(-Stride, Stride);
    Vector3 tip;
    this->Grid.Move(tip); // starts with a force, where the mode pushes
    for (int tick = 0; tick < Ticks && !testing::Test::HasFailure(); ++tick)
    {
      const Vector3 next =
        (1.0 - 0.1 * Stride) * tip + Vector3{ uniform(engine), uniform(engine), uniform(engine) };
      const PrimitiveForces forces = this->Grid.Memory.Forces;
      const PrimitiveMotion from = this->Grid.Motion;
      this->Grid.Move(next); // also limits the forces to the strengths at the new place
      this->Compare(from, forces, 1e-3 * Norm(next - tip), tick);
      tip = next;
    }
    return this->Met;
  }

private:
  void Compare(const PrimitiveMotion& from, const PrimitiveForces& forces, double way, int tick)
  {
    const PrimitiveMotion& to = this->Grid.Motion;
    const double step = Norm(to.Force - from.Force);
    const double ratio = step / (CouplingOf * way);
    this->Met.Strongest = std::max(this->Met.Strongest, Norm(to.Force));
    this->Met.Steepest = std::max(this->Met.Steepest, ratio);
    // At the end of a tick, SolvePrimitives() moves the proxy by up to FinishedFraction (1e-3) of
    // the longest step without computing the force again, so the ratio may be larger by 1e-3.
    constexpr double ofEnds = 1e-3;
    if (ratio <= 1.0 + ofEnds)
    {
      return;
    }
    ++this->Met.Steeper;
    const double q = this->ComputeTurning(from.Proxy, to.Proxy, forces);
    if (q < 1.0)
    {
      EXPECT_LE(ratio, (1.0 + ofEnds) / (1.0 - q)) << "tick " << tick << ", q " << q;
      return;
    }
    ++this->Met.Unbound;
    EXPECT_LE(step, this->StrengthsAt(from.Proxy) + this->StrengthsAt(to.Proxy)) << tick;
  }

  /// Returns the largest q = L/k along parts of the path, for the forces before and after the
  /// motion.
  double ComputeTurning(const Vector3& from, const Vector3& to, const PrimitiveForces& forces) const
  {
    constexpr int parts = 16;
    const std::array<const PrimitiveForces*, 2> both = { &forces, &this->Grid.Memory.Forces };
    const double length = Norm(to - from) / parts;
    std::array<double, 2> before{};
    double most = 0.0;
    for (int part = 0; part <= parts; ++part)
    {
      const PrimitiveSet set = this->Grid.At(1e3 * (from + (1.0 * part / parts) * (to - from)));
      for (std::size_t i = 0; i < 2; ++i)
      {
        const double miss = Miss(*both[i], set);
        most = part > 0 ? std::max(most, std::abs(miss - before[i]) / length) : most;
        before[i] = miss;
      }
    }
    return most / CouplingOf;
  }

  double StrengthsAt(const Vector3& place) const
  {
    return this->Grid.At(1e3 * place).SumStrengths() + 1e-3;
  }

  ModeGrid& Grid;
  Walked Met;
};

struct SteppedMode
{
  ModeKind Kind;
  int Components;
  double Second; ///< strength (N) of the other primitives where the first one has its full strength
};

Walked WalkThrough(const SteppedMode& mode, double strength)
{
  ModeGrid grid(24, 24, 24, 1.0, mode.Components,
    [&](const Vector3& x, double* to) { (mode.Components == 3 ? Swirl : SwirlTensor)(x, to); });
  grid.Bake(mode.Kind, { { 0.0, 0.0 }, { 1.0, strength } }, { { 0.0, 0.0 }, { 1.0, mode.Second } });
  grid.StartAt({});
  return ModeSteps(grid).Walk();
}
} // namespace

class ModesInASwirl : public testing::TestWithParam<SteppedMode>
{
};

TEST_P(ModesInASwirl, StepByTheSpringAsFarAsTheFieldAllows)
{
  const Walked met = WalkThrough(this->GetParam(), 1.5);
  EXPECT_GT(met.Strongest, 0.3);
  // The hand moves at 0.2 m/s. Only few of its steps cross places where the flow turns so fast that
  // there is no bound (q >= 1).
  EXPECT_LT(met.Unbound, Ticks / 100);
}

INSTANTIATE_TEST_SUITE_P(ModeSteps, ModesInASwirl,
  testing::Values(SteppedMode{ ModeKind::VectorFollow, 3, 0.2 },
    SteppedMode{ ModeKind::VectorFront, 3, 0.0 }, SteppedMode{ ModeKind::TwoSidedFront, 3, 0.0 },
    SteppedMode{ ModeKind::VortexTube, 3, 0.3 }, SteppedMode{ ModeKind::Shear, 3, 0.0 },
    SteppedMode{ ModeKind::TensorFollow, 6, 0.5 }));

/// The flow is weak: s |J| = 0.3 N * 0.45/mm is 0.27 k. The bound 1/(1 - q) therefore exists
/// everywhere.
TEST(ModeSteps, OfWeakFlowsAndFrontsAreWithinABoundOfTheirStrength)
{
  constexpr double strength = 0.3;
  const double q = 1e3 * strength * SteepestSwirl / CouplingOf;
  for (const ModeKind kind :
    { ModeKind::VectorFollow, ModeKind::VectorFront, ModeKind::TwoSidedFront })
  {
    const Walked met = WalkThrough({ kind, 3, 0.0 }, strength);
    EXPECT_LE(met.Steepest, 1.0 / (1.0 - q)) << "mode " << int(kind);
    EXPECT_GT(met.Strongest, 0.25) << "mode " << int(kind);
    EXPECT_EQ(met.Unbound, 0) << "mode " << int(kind);
  }
}

/// A straight guide has the same primitives at each place, so q is 0.
TEST(ModeSteps, OfAStraightGuideAreThoseOfTheSpring)
{
  ModeGrid grid(24, 24, 24, 1.0, 3, Swirl);
  const GuidePath::Line line = { { -1.5, -1.0, 0.2 }, { 1.0, 0.4, 0.7 } };
  grid.Mode.Guide = std::make_shared<GuidePath>(std::vector<GuidePath::Line>{ line }, 0.0);
  grid.Bake(ModeKind::Guide, ConstantPolyline(0.4));
  grid.StartAt({});
  const Walked met = ModeSteps(grid).Walk();
  EXPECT_GT(met.Strongest, 0.39) << "it has yielded";
  EXPECT_EQ(met.Steeper, 0);
}
