// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the closed forms of Documentation/evaluation.md: T1 to T5 (a flat surface, penetration,
 * friction and drag), T6 to T9 (drag without a surface, and distinctness), and T10 to T13 (curved
 * walls). T10 to T13 document the faults of the paper's solver, which moves along a tangent and so
 * drifts outwards, with the figures of its recursion. Both the module and the reference play each
 * case, so the reference is tested, too.
 */

#include "SampledImage.h"
#include "Scene.h"

#include <gtest/gtest.h>
#include <vtkPiecewiseFunction.h>

#include <string>
#include <tuple>

using namespace reference;

namespace
{
enum class Player
{
  Module,
  Reference
};

constexpr double Step = 0.1; // mm per tick
constexpr double TwoPi = 6.283185307179586;
constexpr double Impenetrable = 1e9;

double Slab(const Vec3& x)
{
  return 100.0 * x[2];
}

// The gradient of a square is exact, and thus exactly radial, with central differences and splines.
double Ball(const Vec3& x)
{
  return -0.5 * Dot(x, x);
}

double Cavity(const Vec3& x)
{
  return 0.5 * Dot(x, x);
}

Vec3 OnCircle(double radius, double angle)
{
  return { { radius * std::cos(angle), radius * std::sin(angle), 0.0 } };
}

double Angle(const Vec3& x)
{
  return std::atan2(x[1], x[0]);
}

// Returns the record of the tick at which the tip has moved by `mm`.
const TickRecord& AtTick(const Trace& trace, double mm)
{
  return trace[std::size_t(std::lround(mm / Step))];
}

void ExpectNear(double actual, double expected, double scale)
{
  EXPECT_NEAR(actual, expected, 0.002 * scale);
}

std::string PlayerName(const testing::TestParamInfo<std::tuple<Player, Estimator>>& info)
{
  static const char* const players[] = { "Module", "Reference" };
  static const char* const estimators[] = { "CentralDifference", "Gaussian", "CubicBSpline" };
  return std::string(players[int(std::get<0>(info.param))]) +
    estimators[int(std::get<1>(info.param))];
}
} // namespace

class ClosedForms : public testing::TestWithParam<std::tuple<Player, Estimator>>
{
protected:
  /// Starts with k = 500 N/m, T_N = 2 N, W_d = 1 and R = mu = 0, in a field around the origin, and
  /// with a path of one point.
  void Begin(double halfSize, const Field& field, const Vec3& start, double spacing = 1.0)
  {
    this->TheScene.image = Sample(Cube(halfSize, spacing), field);
    this->TheScene.estimator = std::get<1>(this->GetParam());
    this->TheScene.path = { start };
    SetMaterial(this->TheScene, 500.0, 0.0, 0.0, 2.0);
  }

  Trace Play()
  {
    return std::get<0>(this->GetParam()) == Player::Module ? RunFilter(this->TheScene)
                                                           : RunReference(this->TheScene);
  }

  // Touches the wall at the radius 20, and circles at `radius`. Turn i ends at tick i x ticks + 1.
  Trace Circle(const Field& field, double friction, double radius, int ticks, int turns)
  {
    // With samples half a millimetre apart, a sampled Gaussian is exact on linear fields, and
    // nearly exact on squares.
    this->Begin(24.0, field, OnCircle(20.0, 0.0), 0.5);
    SetMaterial(this->TheScene, 500.0, friction, 0.0, Impenetrable);
    for (int tick = 0; tick <= ticks * turns; ++tick)
    {
      this->TheScene.path.push_back(OnCircle(radius, TwoPi * tick / ticks));
    }
    return this->Play();
  }

  Scene TheScene;
};

TEST_P(ClosedForms, T1AndT2PushAndRetract)
{
  this->Begin(16.0, Slab, {});
  this->TheScene.MoveTo({ { 0.0, 0.0, 10.0 } }, Step);
  this->TheScene.MoveTo({}, Step);
  const Trace trace = this->Play();
  ExpectNear(AtTick(trace, 2.0).force[2], -1.0, 1.0);
  ExpectNear(AtTick(trace, 4.0).force[2], -2.0, 2.0);
  ExpectNear(AtTick(trace, 10.0).force[2], -2.0, 2.0);
  ExpectNear(AtTick(trace, 10.0).proxy[2], 6.0, 6.0);
  ExpectNear(AtTick(trace, 12.0).force[2], -1.0, 1.0);
  for (double z : { 6.0, 4.0, 0.0 })
  {
    ExpectNear(AtTick(trace, 20.0 - z).force[2], 0.0, 1.0);
  }
  double work = 0.0;
  for (std::size_t tick = 1; tick < trace.size(); ++tick)
  {
    work -= 0.5e-3 *
      Dot(trace[tick].force + trace[tick - 1].force, trace[tick].tip - trace[tick - 1].tip);
  }
  ExpectNear(work, 12.0e-3, 12.0e-3);
}

TEST_P(ClosedForms, T3DragAddsAndResistsOutward)
{
  this->Begin(16.0, Slab, {});
  SetMaterial(this->TheScene, 500.0, 0.0, 0.5, 2.0);
  this->TheScene.MoveTo({ { 0.0, 0.0, 10.0 } }, Step);
  this->TheScene.MoveTo({}, Step);
  const Trace trace = this->Play();
  ExpectNear(AtTick(trace, 10.0).force[2], -2.5, 2.5);
  ExpectNear(AtTick(trace, 15.0).force[2], 0.0, 2.5);
  for (double z : { 4.0, 3.0, 2.0, 1.0, 0.0 })
  {
    ExpectNear(AtTick(trace, 20.0 - z).force[2], 0.5, 0.5);
  }
}

TEST_P(ClosedForms, T4AndT5StickSlipAndReversal)
{
  this->Begin(16.0, Slab, { { -5.0, 0.0, 0.0 } });
  SetMaterial(this->TheScene, 500.0, 0.4, 0.0, 2.0);
  this->TheScene.MoveTo({ { -5.0, 0.0, 3.0 } }, Step);
  this->TheScene.MoveTo({ { 5.0, 0.0, 3.0 } }, Step);
  this->TheScene.MoveTo({ { -5.0, 0.0, 3.0 } }, Step);
  const Trace trace = this->Play();
  const auto at = [&](double mm) { return AtTick(trace, 3.0 + mm); };
  for (double mm : { 0.4, 0.8, 1.2 })
  {
    ExpectNear(at(mm).frictionForce, 0.5 * mm, 0.6);
    EXPECT_NEAR(at(mm).proxy[0], -5.0, 1e-9) << "sticks";
  }
  for (double mm : { 1.3, 2.0, 5.0, 10.0 })
  {
    ExpectNear(at(mm).frictionForce, 0.6, 0.6);
    ExpectNear(at(mm).force[0], -0.6, 0.6);
    ExpectNear(at(mm).normalForce, 1.5, 1.5);
    ExpectNear(at(mm).force[2], -1.5, 1.5);
  }
  ExpectNear(at(11.2).force[0], 0.0, 0.6);
  for (double mm : { 12.4, 13.0, 18.0 })
  {
    ExpectNear(at(mm).force[0], 0.6, 0.6);
  }
}

TEST_P(ClosedForms, T6AndT7DragInAUniformRegion)
{
  for (double step : { 0.01, 0.1, 1.5 })
  {
    this->Begin(16.0, [](const Vec3&) { return 1234.567; }, { { -6.0, 0.0, 0.0 } });
    SetMaterial(this->TheScene, 500.0, 0.3, 0.5, 2.0);
    this->TheScene.MoveTo({}, step);
    const std::size_t turn = this->TheScene.path.size() - 1;
    // small enough steps for T7's limit
    this->TheScene.MoveTo({ { 0.0, 1.0, 0.0 } }, 0.001);
    const Trace trace = this->Play();
    ExpectNear(trace[turn].force[0], -0.5, 0.5);
    ExpectNear(trace[turn].dragForce, 0.5, 0.5);
    ExpectNear(trace[turn].tip[0] - trace[turn].proxy[0], 1.0, 1.0);
    const Vec3 lag = trace.back().tip - trace.back().proxy;
    ExpectNear(lag[0], 1.0 / std::cosh(1.0), 0.64805);
    ExpectNear(lag[1], std::tanh(1.0), 0.76159);
  }
}

TEST_P(ClosedForms, T8AndT9DistinctnessMakesTwoSprings)
{
  // With samples half a millimetre apart, a sampled Gaussian is exact on linear fields, and nearly
  // exact on squares.
  this->Begin(
    16.0, [](const Vec3& x) { return 50.0 * x[2] * x[2]; }, {}, 0.5);
  vtkPiecewiseFunction* distinctness = this->TheScene.property->GetDistinctness();
  distinctness->RemoveAllPoints();
  distinctness->AddPoint(0.0, 0.0);
  distinctness->AddPoint(400.0, 1.0); // the gradient at 4 mm has the distinctness 1
  this->TheScene.MoveTo({ { 0.0, 0.0, 10.0 } }, Step);
  const Trace trace = this->Play();
  ExpectNear(trace[40].force[2], -1.0, 1.0);
  ExpectNear(trace[100].force[2], -2.0, 2.0);

  // Case T9, a fault of the paper's solver: W_d is read before the proxy moves, so a jump causes no
  // force.
  this->TheScene.path = { {}, { { 0.0, 0.0, 4.0 } } };
  EXPECT_NEAR(Norm(this->Play().back().force), 0.0, 1e-9);
}

TEST_P(ClosedForms, T10DriftsOutwardOnABall)
{
  // The documentation has the expected values, which are correct to the last printed digit.
  const Trace coarse = this->Circle(Ball, 0.0, 18.0, 1000, 1);
  EXPECT_NEAR(Norm(coarse[1].proxy), 20.0, 1e-9);
  EXPECT_NEAR(Norm(coarse.back().proxy), 20.399, 0.002 * 0.399);
  const Trace fine = this->Circle(Ball, 0.0, 18.0, 10000, 1);
  EXPECT_NEAR(Norm(fine.back().proxy), 20.0395, 0.002 * 0.0395);
}

TEST_P(ClosedForms, T11LeaksThroughACavityWall)
{
  const int ticks = 1257;
  const Trace trace = this->Circle(Cavity, 0.0, 22.0, ticks, 7);
  const double printed[] = { 1.0, 0.842, 0.681, 0.518, 0.352, 0.183, 0.012, 0.0 };
  for (int turn = 0; turn <= 7; ++turn)
  {
    EXPECT_NEAR(Norm(trace[turn * ticks + 1].force), printed[turn], 0.002) << "turn " << turn;
  }
}

TEST_P(ClosedForms, T12LagsByTheFrictionAngle)
{
  const auto lag = [](const TickRecord& tick) { return Angle(tick.tip) - Angle(tick.proxy); };
  const TickRecord printed = this->Circle(Ball, 0.3, 18.0, 10000, 1).back();
  EXPECT_NEAR(Norm(printed.proxy), 20.04, 0.001);
  EXPECT_NEAR(lag(printed), 0.0342, 0.002 * 0.0342);

  // Evaluate the formula with the radius of this trace. The paper's normal is one tick old: with
  // 10000 ticks per turn, this alone would cause 0.23 % of the lag.
  const TickRecord fine = this->Circle(Ball, 0.3, 18.0, 40000, 1).back();
  const double phi = std::atan(0.3);
  const double expected = std::asin(Norm(fine.proxy) / 18.0 * std::sin(phi)) - phi;
  EXPECT_NEAR(lag(fine), expected, 0.002 * expected);
}

TEST_P(ClosedForms, T13ChattersInADeepCavity)
{
  this->Begin(16.0, Cavity, OnCircle(5.0, 0.0));
  SetMaterial(this->TheScene, 500.0, 0.0, 0.0, Impenetrable);
  const double angle = 0.01;
  this->TheScene.path.insert(this->TheScene.path.end(), 12, OnCircle(12.0, angle)); // rho > 2 r
  const Trace trace = this->Play();
  for (std::size_t tick = 2; tick < trace.size(); ++tick)
  {
    const double before = Angle(trace[tick - 1].proxy) - angle;
    const double after = Angle(trace[tick].proxy) - angle;
    EXPECT_LT(before * after, 0.0) << "from side to side with period 2, tick " << tick;
  }
  EXPECT_GT(std::abs(Angle(trace.back().proxy) - angle), 10.0 * angle) << "and growing";
}

INSTANTIATE_TEST_SUITE_P(Specification, ClosedForms,
  testing::Combine(
    testing::Values(Player::Module, Player::Reference), testing::ValuesIn(AllEstimators)),
  PlayerName);
