// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares a needle in layers of tissue with the closed forms N1 to N3. The spring has 500 N/m.
 */

#include "Core/Tools/Needle/NeedleTool.h"
#include "NeedleScene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace coretest;

namespace
{
constexpr double Spring = 500.0;

/// Returns the force (N) on the hand along the needle. It is negative while the hand pushes the
/// needle in.
double AlongNeedle(const TickRecord& record)
{
  return record.Force.Z;
}

class Needles : public testing::TestWithParam<HapticSolver>
{
protected:
  std::unique_ptr<HapticModel> Bake(NeedleScene& scene) const
  {
    scene.Description.Settings.Solver = this->GetParam();
    return std::make_unique<HapticModel>(scene.Description);
  }
};
} // namespace

// Rows of N1's table: insertion depth (mm), force during insertion (N), force during withdrawal
// (N).
TEST_P(Needles, FeelsLayersAndTheShaft)
{
  NeedleScene scene(LayersOfN1());
  const auto model = this->Bake(scene);
  const double rows[][3] = { { 2.999, 0.36, 0.06 }, { 14.999, 0.22, 0.12 }, { 24.999, 0.67, 0.37 },
    { 34.999, 0.92, 0.62 }, { 37.999, 1.60, 0.80 }, { 38.001, 0.80, 0.80 } };
  for (const auto& [depth, in, out] : rows)
  {
    NeedleHand hand(*model);
    hand.MoveTo(Along(2.0));
    // Place the tip so that the proxy is at the depth. Behind the ligament, the proxy leaps too far
    // forward and has to be drawn back.
    const bool isBehind = depth > 38.0;
    const double deepest = NeedleScene::Skin + depth + 1e3 * in / Spring + (isBehind ? 3.0 : 0.0);
    hand.MoveTo(Along(deepest));
    EXPECT_NEAR(AlongNeedle(hand.Record), -in, 2e-3 * in) << depth;
    if (!isBehind)
    {
      EXPECT_NEAR(hand.ComputeDepth(), depth, 2e-3) << depth;
    }
    hand.MoveTo(Along(NeedleScene::Skin + depth - 1e3 * out / Spring - 0.01));
    EXPECT_NEAR(AlongNeedle(hand.Record), out, 5e-3 * out + 1e-4) << depth;
    EXPECT_NEAR(hand.ComputeDepth(), depth, 0.03) << depth;
    // Between insertion and withdrawal, friction holds the needle.
    const Vector3 held = hand.Record.Proxy;
    hand.MoveTo(Along(NeedleScene::Skin + depth));
    EXPECT_EQ(hand.Record.Proxy.Z, held.Z);
    EXPECT_EQ(hand.Record.Contact, ContactState::Sticking);
    EXPECT_LT(std::abs(AlongNeedle(hand.Record)), 0.02);
  }
}

TEST_P(Needles, LosesItsResistanceAtTheEndOfTheLigament)
{
  NeedleScene scene(LayersOfN1());
  const auto model = this->Bake(scene);
  NeedleHand hand(*model);
  hand.MoveTo(Along(2.0));
  double before = 0.0;
  double loss = 0.0;
  hand.MoveTo(Along(50.0), 0.005,
    [&](const TickRecord& record)
    {
      loss = std::max(loss, AlongNeedle(record) - before);
      before = AlongNeedle(record);
    });
  EXPECT_NEAR(loss, 0.80, 8e-3);
  EXPECT_NEAR(before, -0.80, 1e-6);
}

// Cutting takes 12.30 mJ and friction 10.5 mJ. In addition, each drop of the force by dF loses
// dF^2/(2 k). In this scene, R drops from the skin to the fat, and behind the ligament.
TEST_P(Needles, TakesTheWorkOfTheTissue)
{
  NeedleScene scene(LayersOfN1());
  const auto model = this->Bake(scene);
  NeedleHand hand(*model);
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(NeedleScene::Skin + 40.0 + 0.8e3 / Spring), 0.002);
  EXPECT_NEAR(hand.ComputeDepth(), 40.0, 1e-3);
  const double falls = (0.2 * 0.2 + 0.8 * 0.8) / (2.0 * Spring);
  const double inserted = hand.Work - hand.ComputeStored();
  EXPECT_NEAR(inserted, 12.30e-3 + 10.5e-3 + falls, 1e-4);
  const double stored = hand.ComputeStored();
  hand.MoveTo(Along(2.0), 0.002);
  EXPECT_EQ(hand.Record.Depth, 0.0);
  EXPECT_EQ(Norm(hand.Record.Force), 0.0);
  EXPECT_NEAR(hand.Work - inserted - hand.ComputeStored(), 12.30e-3, 5e-5);
  EXPECT_GT(stored, 0.0);
}

// Each puncture takes dF^2/(2 (k + tau)) more, where dF is the drop of the force, from T plus the R
// of the tissue in front (0 in air) to the R of the layer. The shaft's friction tau counts because
// it rises while the tip springs forward.
TEST_P(Needles, TakesTheWorkOfEachPuncture)
{
  const auto workOf = [this](const std::vector<Layer>& layers)
  {
    NeedleScene scene(layers);
    const auto model = this->Bake(scene);
    NeedleHand hand(*model);
    hand.MoveTo(Along(2.0));
    // Move far enough that all drops of the force are over.
    hand.MoveTo(Along(NeedleScene::Skin + 45.0), 0.002);
    return hand.Work - hand.ComputeStored();
  };
  std::vector<Layer> layers = LayersOfN1();
  // Remove the drops of R from skin to fat and behind the ligament, because punctures replace them.
  layers[1].Cutting = layers[0].Cutting;
  layers[4].Cutting = layers[3].Cutting;
  const double without = workOf(layers);
  const double strengths[] = { 1.2, 0.7, 1.0, 1.2 };
  for (int i = 0; i < 4; ++i)
  {
    std::vector<Layer> one = layers;
    one[static_cast<std::size_t>(i)].Puncture = strengths[i];
    const Layer& layer = layers[static_cast<std::size_t>(i)];
    const double before = i == 0 ? 0.0 : layers[static_cast<std::size_t>(i) - 1].Cutting;
    const double fall = strengths[i] + before - layer.Cutting;
    const double loss = fall * fall / (2.0 * (Spring + layer.Shaft));
    EXPECT_NEAR(workOf(one) - without, loss, 0.01 * loss + 2e-5) << i;
  }
}

// Before a puncture, f.a = -(T + R + F_s), where R is that of the tissue at the tip. In front of
// the skin, this is air. The needle therefore breaks through the skin with the same force as a
// point, whose drag is the R at x_v in front of the surface.
TEST_P(Needles, HoldsAtTheSkinWithAllThatIsThere)
{
  for (const double strength : { 1.2, 0.2 })
  {
    std::vector<Layer> layers = LayersOfN1();
    layers[0].Puncture = strength;
    NeedleScene scene(layers);
    const auto model = this->Bake(scene);
    NeedleHand hand(*model);
    hand.MoveTo(Along(2.0));
    double most = 0.0;
    hand.MoveTo(Along(NeedleScene::Skin + 3.3), 0.005,
      [&](const TickRecord& record) { most = std::max(most, -AlongNeedle(record)); });
    // Behind the skin, the force is the skin's R plus the friction along the depth. It may exceed
    // the strength T.
    const double within = 0.3 + 20e-3 * hand.ComputeDepth();
    EXPECT_NEAR(-AlongNeedle(hand.Record), within, 1e-3);
    EXPECT_NEAR(most, std::max(strength, within), 0.015);
  }
}

TEST_P(Needles, HoldsAtABoundaryWithAllThatIsThere)
{
  std::vector<Layer> layers = LayersOfN1();
  layers[3].Puncture = 1.2;
  NeedleScene scene(layers);
  const auto model = this->Bake(scene);
  NeedleHand hand(*model);
  hand.MoveTo(Along(2.0));
  double most = 0.0;
  hand.MoveTo(Along(NeedleScene::Skin + 35.0 + 5.3), 0.005,
    [&](const TickRecord& record)
    {
      most = std::max(most, -AlongNeedle(record));
      const bool isHeld = record.SurfaceStrength > 0.0 && record.Depth > 0.03;
      EXPECT_EQ(record.Viscosity, isHeld ? 0.3 : record.Viscosity) << "the tip is in the muscle";
    });
  // T, plus the R of the muscle at the tip, plus the friction along 35 mm.
  EXPECT_NEAR(most, 1.2 + 0.3 + 0.62, 0.01);
}

TEST_P(Needles, IsHeldAcrossItsAxis)
{
  NeedleScene scene(LayersOfN1());
  const auto model = this->Bake(scene);
  NeedleHand hand(*model);
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(25.0));
  const double along = AlongNeedle(hand.Record);
  hand.MoveTo({ 12.5, 11.5, 25.0 });
  EXPECT_NEAR(hand.Record.Force.X, -0.5, 1e-9);
  EXPECT_NEAR(hand.Record.Force.Y, 0.0, 1e-12);
  EXPECT_NEAR(AlongNeedle(hand.Record), along, 1e-9);
  hand.MoveTo({ 17.5, 11.5, 25.0 });
  EXPECT_NEAR(hand.Record.Force.X, -1.0, 1e-9);
  // The needle was moved aside by more than the tissue can hold, so it stays at its new place.
  hand.MoveTo({ 15.5, 11.5, 25.0 });
  EXPECT_NEAR(hand.Record.Force.X, 0.0, 1e-9);
}

TEST_P(Needles, FeelsTheSameInEveryDirection)
{
  NeedleScene scene(LayersOfN1());
  const auto upright = this->Bake(scene);
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Matrix3 turn = Matrix3{ { { c, -s, 0.0 }, { s, c, 0.0 }, { 0.0, 0.0, 1.0 } } } *
    Matrix3{ { { 1.0, 0.0, 0.0 }, { 0.0, c, -s }, { 0.0, s, c } } };
  NeedleScene other(LayersOfN1());
  other.Description.IndexToWorld.Linear = turn;
  auto labels = std::make_shared<BakedLabels>(*other.Description.Labels);
  labels->IndexToWorld.Linear = turn;
  other.Description.Labels = labels;
  const auto turned = this->Bake(other);
  NeedleHand first(*upright);
  NeedleHand second(*turned);
  const Vector3 stops[] = { Along(2.0), Along(20.0), { 12.5, 11.0, 20.5 }, Along(44.0),
    { 11.0, 12.0, 30.0 }, Along(1.0) };
  for (const Vector3& stop : stops)
  {
    std::vector<Vector3> forces;
    first.MoveTo(stop, 0.0503, [&](const TickRecord& record) { forces.push_back(record.Force); });
    std::size_t i = 0;
    second.MoveTo(turn * stop, 0.0503,
      [&](const TickRecord& record)
      {
        const std::size_t at = std::min(i++, forces.size() - 1);
        EXPECT_LT(Norm(record.Force - turn * forces[at]), 2e-3);
      });
    EXPECT_NEAR(double(i), double(forces.size()), 1.0);
    EXPECT_LT(Norm(second.Record.Force - turn * first.Record.Force), 1e-6);
  }
}

// Whatever the motion is, the hand must get back at most the energy that it has put in.
TEST_P(Needles, GivesNoEnergy)
{
  std::vector<Layer> layers = LayersOfN1();
  layers[0].Puncture = 1.0;
  layers[2].Puncture = 0.5;
  NeedleScene scene(layers);
  const auto model = this->Bake(scene);
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int walk = 0; walk < 20; ++walk)
  {
    NeedleHand hand(*model);
    Vector3 at = Along(3.0);
    Vector3 speed;
    int inserted = 0;
    Quaternion orientation{ 0.0, 1.0, 0.0, 0.0 }; // points along +z
    hand.State.HasOrientation = walk % 2 == 1;
    double least = 0.0;
    for (int i = 0; i < 20000; ++i)
    {
      speed = 0.995 * speed +
        0.002 * Vector3{ uniform(engine), uniform(engine), uniform(engine) + 0.2 * (i < 8000) };
      at += speed;
      at.X = std::clamp(at.X, 4.0, 20.0);
      at.Y = std::clamp(at.Y, 4.0, 20.0);
      at.Z = std::clamp(at.Z, 0.5, 50.0);
      orientation.Y += 0.003 * uniform(engine);
      orientation.Z += 0.003 * uniform(engine);
      orientation = (1.0 / std::sqrt(SquaredNorm(orientation))) * orientation;
      hand.State.Orientation = orientation;
      const TickRecord& record = hand.Place(at);
      least = std::min(least, hand.Work - hand.ComputeStored());
      inserted += record.Depth > 0.0 ? 1 : 0;
      if (record.Depth > 0.0)
      {
        const double held = record.Viscosity + record.ShaftForce + record.SurfaceStrength;
        EXPECT_LE(record.NormalForce, held + 1e-6);
        EXPECT_LE(record.FrictionForce, 1.0 + 1e-9);
      }
    }
    EXPECT_GT(least, -1e-6) << walk;
    EXPECT_GT(inserted, 1000) << walk;
  }
}

TEST_P(Needles, PuncturesOnlyWithItsPoint)
{
  std::vector<Layer> layers = LayersOfN1();
  layers[0].Puncture = 1.0;
  NeedleScene scene(layers);
  const auto model = this->Bake(scene);
  for (const bool pointsIn : { true, false })
  {
    NeedleHand hand(*model);
    hand.State.HasOrientation = true;
    // A stylus points along its own -z. Half a turn about x turns that direction into +z.
    hand.State.Orientation =
      pointsIn ? Quaternion{ 0.0, 1.0, 0.0, 0.0 } : Quaternion{ 1.0, 0.0, 0.0, 0.0 };
    hand.MoveTo(Along(2.0));
    hand.MoveTo(Along(20.0));
    EXPECT_EQ(hand.State.Needle.IsInserted, pointsIn);
    EXPECT_EQ(hand.Record.Depth > 0.0, pointsIn);
  }
}

TEST_P(Needles, FreezesItsAxisWithoutAnOrientation)
{
  std::vector<Layer> layers = LayersOfN1();
  layers[0].Puncture = 1.0;
  NeedleScene scene(layers);
  const auto model = this->Bake(scene);
  NeedleHand hand(*model);
  hand.MoveTo({ 9.0, 11.5, 3.0 });
  const Vector3 way{ 3.0, 0.0, 20.0 };
  const Vector3 axis = (1.0 / Norm(way)) * way;
  hand.MoveTo(Vector3{ 9.0, 11.5, 3.0 } + way);
  ASSERT_TRUE(hand.State.Needle.IsInserted);
  EXPECT_GT(Dot(hand.State.Needle.Axis, axis), std::cos(0.01));
  const Vector3 frozen = hand.State.Needle.Axis;
  hand.MoveTo({ 13.0, 13.0, 30.0 });
  EXPECT_EQ(hand.State.Needle.Axis.X, frozen.X);
  // The skin is flat, so its normal is along z.
  EXPECT_NEAR(hand.State.Needle.Normal.Z, 1.0, 1e-6);
}

TEST_P(Needles, LetsTheHandGoWhenTheToolIsChanged)
{
  std::vector<Layer> layers = LayersOfN1();
  layers[0].Puncture = 1.0;
  NeedleScene scene(layers);
  const auto needle = this->Bake(scene);
  NeedleScene other(layers);
  other.Description.Tool = nullptr;
  const auto point = this->Bake(other);
  NeedleHand hand(*needle);
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(25.0));
  ASSERT_GT(hand.Record.Depth, 0.015);
  const double stored = hand.ComputeStored();
  CarryState(*needle, *point, hand.State);
  hand.Model = point.get();
  hand.Place(Along(25.0));
  EXPECT_FALSE(hand.State.Needle.IsInserted);
  EXPECT_EQ(hand.Record.Depth, 0.0);
  EXPECT_TRUE(IsFinite(hand.Record.Force));
  EXPECT_LE(hand.ComputeStored(), stored * (1.0 + 1e-9));
  // After the change back, the needle has to puncture the skin again.
  CarryState(*point, *needle, hand.State);
  hand.Model = needle.get();
  hand.Place(Along(25.0));
  EXPECT_LE(hand.ComputeStored(), stored * (1.0 + 1e-9));
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(25.0));
  EXPECT_GT(hand.Record.Depth, 0.015);
}

// The needle must stay inserted after a change of materials and placement.
TEST_P(Needles, StaysInsertedWhenTheVolumeIsMoved)
{
  NeedleScene scene(LayersOfN1());
  const auto model = this->Bake(scene);
  NeedleHand hand(*model);
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(25.0));
  const TickRecord before = hand.Record;
  Affine3 moved = model->DeviceToWorld;
  moved.Offset.X += 1.0;
  const HapticModel other(*model, moved, ForceCaps{});
  CarryState(*model, other, hand.State);
  hand.Model = &other;
  hand.Place(Along(25.0));
  EXPECT_NEAR(hand.Record.Depth, before.Depth, 1e-12);
  EXPECT_NEAR(Norm(hand.Record.Force - before.Force), 0.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Solvers, Needles,
  testing::Values(HapticSolver::Paper, HapticSolver::Precise),
  [](const auto& info)
  { return std::string(info.param == HapticSolver::Paper ? "Paper" : "Precise"); });
