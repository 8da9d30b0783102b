// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The specification's closed forms T1 to T5: a flat surface, penetration, friction, drag.
 */

#include "ClosedForms.h"

using namespace reference;

namespace
{
constexpr double Step = 0.1; // mm per tick

double Slab(const Vec3& x)
{
  return 100.0 * x[2];
}

// The record of the tick whose tip is `z` mm deep, first or last on the way.
const TickRecord& AtTick(const Trace& trace, double mm)
{
  return trace[std::size_t(std::lround(mm / Step))];
}

void ExpectNear(double actual, double expected, double scale)
{
  EXPECT_NEAR(actual, expected, 0.002 * scale);
}
} // namespace

class ClosedFormsFlat : public ClosedForms
{
};

TEST_P(ClosedFormsFlat, T1AndT2PushAndRetract)
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

TEST_P(ClosedFormsFlat, T3DragAddsAndResistsOutward)
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

TEST_P(ClosedFormsFlat, T4AndT5StickSlipAndReversal)
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

INSTANTIATE_TEST_SUITE_P(Flat, ClosedFormsFlat, AllPlayers, PlayerName);
