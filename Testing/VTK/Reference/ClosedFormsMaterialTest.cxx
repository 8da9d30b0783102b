// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The specification's closed forms T6 to T9: drag without a surface, and distinctness.
 */

#include "ClosedForms.h"

#include <vtkPiecewiseFunction.h>

using namespace reference;

namespace
{
void ExpectNear(double actual, double expected, double scale)
{
  EXPECT_NEAR(actual, expected, 0.002 * scale);
}
} // namespace

class ClosedFormsMaterial : public ClosedForms
{
};

TEST_P(ClosedFormsMaterial, T6AndT7DragInAUniformRegion)
{
  for (double step : { 0.01, 0.1, 1.5 })
  {
    this->Begin(16.0, [](const Vec3&) { return 1234.567; }, { { -6.0, 0.0, 0.0 } });
    SetMaterial(this->TheScene, 500.0, 0.3, 0.5, 2.0);
    this->TheScene.MoveTo({}, step);
    const std::size_t turn = this->TheScene.path.size() - 1;
    this->TheScene.MoveTo({ { 0.0, 1.0, 0.0 } }, 0.001); // steps small enough for T7's limit
    const Trace trace = this->Play();
    ExpectNear(trace[turn].force[0], -0.5, 0.5);
    ExpectNear(trace[turn].dragForce, 0.5, 0.5);
    ExpectNear(trace[turn].tip[0] - trace[turn].proxy[0], 1.0, 1.0);
    const Vec3 lag = trace.back().tip - trace.back().proxy;
    ExpectNear(lag[0], 1.0 / std::cosh(1.0), 0.64805);
    ExpectNear(lag[1], std::tanh(1.0), 0.76159);
  }
}

TEST_P(ClosedFormsMaterial, T8AndT9DistinctnessMakesTwoSprings)
{
  // On half millimetres: a sampled Gaussian is exact on linear fields, and near it on squares.
  this->Begin(
    16.0, [](const Vec3& x) { return 50.0 * x[2] * x[2]; }, {}, 0.5);
  const double step = 0.1;
  vtkPiecewiseFunction* distinctness = this->TheScene.property->GetDistinctness();
  distinctness->RemoveAllPoints();
  distinctness->AddPoint(0.0, 0.0);
  distinctness->AddPoint(400.0, 1.0); // the gradient at 4 mm
  this->TheScene.MoveTo({ { 0.0, 0.0, 10.0 } }, step);
  const Trace trace = this->Play();
  ExpectNear(trace[40].force[2], -1.0, 1.0);
  ExpectNear(trace[100].force[2], -2.0, 2.0);

  // T9, the paper's fault: it reads W_d before it moves, so a jump meets nothing.
  this->TheScene.path = { {}, { { 0.0, 0.0, 4.0 } } };
  EXPECT_NEAR(Norm(this->Play().back().force), 0.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Material, ClosedFormsMaterial, AllPlayers, PlayerName);
