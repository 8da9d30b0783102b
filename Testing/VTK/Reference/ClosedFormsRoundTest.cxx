// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The specification's closed forms T10 to T13, curved walls. They document the faults of the
 * paper's solver (it moves along a tangent, so it drifts outward) to the figures that its recursion
 * gives.
 */

#include "ClosedForms.h"

using namespace reference;

namespace
{
constexpr double TwoPi = 6.283185307179586;
constexpr double Impenetrable = 1e9;

// The gradient of a square is exact with central differences and splines: exactly radial.
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
} // namespace

class ClosedFormsRound : public ClosedForms
{
protected:
  // Touch the wall at radius 20 and go round on `radius`; the last tick of turn i is i x ticks + 1.
  Trace Circle(const Field& field, double friction, double radius, int ticks, int turns)
  {
    // On half millimetres: a sampled Gaussian is exact on linear fields, and near it on squares.
    this->Begin(24.0, field, OnCircle(20.0, 0.0), 0.5);
    SetMaterial(this->TheScene, 500.0, friction, 0.0, Impenetrable);
    for (int tick = 0; tick <= ticks * turns; ++tick)
    {
      this->TheScene.path.push_back(OnCircle(radius, TwoPi * tick / ticks));
    }
    return this->Play();
  }
};

TEST_P(ClosedFormsRound, T10DriftsOutwardOnABall)
{
  // As printed, to the last digit printed.
  const Trace coarse = this->Circle(Ball, 0.0, 18.0, 1000, 1);
  EXPECT_NEAR(Norm(coarse[1].proxy), 20.0, 1e-9);
  EXPECT_NEAR(Norm(coarse.back().proxy), 20.399, 0.002 * 0.399);
  const Trace fine = this->Circle(Ball, 0.0, 18.0, 10000, 1);
  EXPECT_NEAR(Norm(fine.back().proxy), 20.0395, 0.002 * 0.0395);
}

TEST_P(ClosedFormsRound, T11LeaksThroughACavityWall)
{
  const int ticks = 1257;
  const Trace trace = this->Circle(Cavity, 0.0, 22.0, ticks, 7);
  const double printed[] = { 1.0, 0.842, 0.681, 0.518, 0.352, 0.183, 0.012, 0.0 };
  for (int turn = 0; turn <= 7; ++turn)
  {
    EXPECT_NEAR(Norm(trace[turn * ticks + 1].force), printed[turn], 0.002) << "turn " << turn;
  }
}

TEST_P(ClosedFormsRound, T12LagsByTheFrictionAngle)
{
  const auto lag = [](const TickRecord& tick) { return Angle(tick.tip) - Angle(tick.proxy); };
  const TickRecord printed = this->Circle(Ball, 0.3, 18.0, 10000, 1).back();
  EXPECT_NEAR(Norm(printed.proxy), 20.04, 0.001);
  EXPECT_NEAR(lag(printed), 0.0342, 0.002 * 0.0342);

  // The formula by its own radius. The paper's normal is a tick old, which in 10000 ticks a turn
  // would alone make 0.23 % of the lag.
  const TickRecord fine = this->Circle(Ball, 0.3, 18.0, 40000, 1).back();
  const double phi = std::atan(0.3);
  const double expected = std::asin(Norm(fine.proxy) / 18.0 * std::sin(phi)) - phi;
  EXPECT_NEAR(lag(fine), expected, 0.002 * expected);
}

TEST_P(ClosedFormsRound, T13ChattersInADeepCavity)
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

INSTANTIATE_TEST_SUITE_P(Round, ClosedFormsRound, AllPlayers, PlayerName);
