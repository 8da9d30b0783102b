// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a needle in a volume without labels: the tissue that it reads, its track, and its stored
 * state.
 */

#include "Core/Tools/Needle/NeedleTissue.h"
#include "Core/State/ServoStateNumbers.h"
#include "NeedleScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace coretest;

TEST(NeedleTrack, SumsItsStretches)
{
  NeedleTrack track;
  track.Append(0.0, 20.0, 1);
  track.Append(0.003, 5.0, 2);
  track.Append(0.015, 25.0, 3);
  EXPECT_EQ(track.GetSize(), 3);
  EXPECT_NEAR(track.Sum(0.020), 0.06 + 0.06 + 0.125, 1e-8);
}

TEST(NeedleTrack, KeepsTheFrictionOfMoreTissuesThanItHolds)
{
  NeedleTrack track;
  double sum = 0.0;
  constexpr int tissues = 500;
  constexpr double length = 1e-4;
  for (int i = 0; i < tissues; ++i)
  {
    const double shaft = 10.0 + 5.0 * (i % 7);
    track.Append(length * i, shaft, i % 5);
    sum += length * shaft;
  }
  EXPECT_EQ(track.GetSize(), NeedleTrack::Most);
  EXPECT_NEAR(track.Sum(length * tissues), sum, 1e-5 * sum);
  EXPECT_TRUE(track.IsPossible());
}

// The value is V = 100 z (z in mm), the friction tau = V/50 N/m and the resistance R = V/10000 N,
// so F_s is the integral of 2 z over mm, and R is z/100.
TEST(NeedleTissue, FollowsFunctionsOfTheScalar)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    const TestVolume volume = MakeRamp(56);
    HapticModelDescription description = Describe(volume);
    description.Settings.Solver = solver;
    description.Material.SurfaceStrength = ConstantPolyline(0.0);
    NeedleDescription needle;
    needle.ShaftFriction = { { 1000.0, 0.0 }, { 1000.0, 20.0 }, { 5000.0, 100.0 } };
    needle.CuttingForce = { { 1000.0, 0.0 }, { 1000.0, 0.1 }, { 5000.0, 0.5 } };
    needle.HasCuttingForce = true;
    description.Tool = std::make_shared<const BakedNeedle>(needle);
    const HapticModel model(description);
    NeedleHand hand(model);
    hand.MoveTo(Along(5.0));
    EXPECT_EQ(hand.Record.Depth, 0.0);
    for (const double z : { 15.0, 30.0, 42.0 })
    {
      hand.MoveTo(Along(z));
      const double at = hand.Model->DeviceToWorld(hand.Record.Proxy).Z;
      const double shaft = 1e-3 * (at * at - 10.0 * 10.0);
      const double cutting = at / 100.0;
      EXPECT_NEAR(-hand.Record.Force.Z, shaft + cutting, 0.01 * (shaft + cutting)) << z;
      EXPECT_NEAR(hand.Record.ShaftForce, shaft, 0.01 * shaft) << z;
      EXPECT_NEAR(hand.Record.Depth, 1e-3 * (at - 10.0), 1e-6) << z;
    }
    // After a part of the needle was withdrawn, friction along the remaining depth holds it.
    hand.MoveTo(Along(25.0));
    const double at = hand.Model->DeviceToWorld(hand.Record.Proxy).Z;
    EXPECT_NEAR(hand.Record.Force.Z, 1e-3 * (at * at - 100.0), 0.01 * hand.Record.Force.Z);
  }
}

// Without labels, the needle punctures surfaces of the scalar values. The surface in this test is a
// sharp edge.
TEST(NeedleTissue, PuncturesTheSurfacesOfTheScalars)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    TestVolume volume(ScalarType::Int16, { 24, 24, 56 });
    volume.Fill<std::int16_t>(
      [](std::int64_t, std::int64_t, std::int64_t k) { return k < 20 ? 0 : 1000; });
    HapticModelDescription description = Describe(volume);
    description.Settings.Solver = solver;
    description.Material.SurfaceStrength = ConstantPolyline(1.0);
    description.Material.Distinctness = { { 50.0, 0.0 }, { 200.0, 1.0 } };
    description.Material.Viscosity = { { 500.0, 0.0 }, { 500.0, 0.2 } };
    NeedleDescription needle;
    needle.ShaftFriction = { { 500.0, 0.0 }, { 500.0, 30.0 } };
    description.Tool = std::make_shared<const BakedNeedle>(needle);
    const HapticModel model(description);
    NeedleHand hand(model);
    hand.MoveTo(Along(10.0));
    double most = 0.0;
    // A press below the surface's strength does not insert the needle. On the way back, the surface
    // releases it.
    hand.MoveTo(Along(19.5 + 0.2));
    EXPECT_FALSE(hand.State.Needle.IsInserted);
    EXPECT_GT(Norm(hand.Record.Force), 0.05);
    hand.MoveTo(Along(10.0));
    EXPECT_EQ(Norm(hand.Record.Force), 0.0);
    hand.MoveTo(
      Along(35.0), 0.01, [&](const TickRecord& record) { most = std::max(most, -record.Force.Z); });
    EXPECT_TRUE(hand.State.Needle.IsInserted);
    // The largest force is the strength T plus the R at the tip. The surface holds while the values
    // are those of tissue.
    EXPECT_GT(most, 1.0);
    EXPECT_LT(most, 1.0 + 0.2 + 0.1);
    const double depth = hand.ComputeDepth() + NeedleScene::Skin - 19.5;
    EXPECT_NEAR(-hand.Record.Force.Z, 0.2 + 0.03 * depth, 0.01 * (0.2 + 0.03 * depth)) << depth;
    hand.MoveTo(Along(10.0));
    EXPECT_FALSE(hand.State.Needle.IsInserted);
    EXPECT_EQ(Norm(hand.Record.Force), 0.0);
  }
}

namespace
{
// Forbids the label of one of N1's layers, with a stand-off of 2 mm.
void Forbid(NeedleScene& scene, std::int64_t label)
{
  auto labels = std::make_shared<BakedLabels>(*scene.Description.Labels);
  std::vector<LabelledMaterial> entries;
  for (std::int64_t i = 1; i <= 5; ++i)
  {
    LabelledMaterial entry;
    entry.Label = i;
    entry.Material = i == label ? LabelMaterial{} : *labels->Table.Find(i);
    entry.Material.IsForbidden = i == label;
    entries.push_back(entry);
  }
  labels->Table = LabelTable(entries);
  labels->Zone = ForbiddenZone::Make(labels->View, labels->Table, labels->IndexToWorld, 2.0);
  ASSERT_TRUE(labels->Zone);
  scene.Description.Labels = labels;
}
} // namespace

// The ligament begins 35 mm below the skin. The leap after a puncture is longer than all steps of
// one tick, and must stop in front of the ligament.
TEST(NeedleTissue, NoLeapGoesThroughForbiddenLabels)
{
  NeedleScene scene(LayersOfN1());
  ASSERT_NO_FATAL_FAILURE(Forbid(scene, 4));
  const HapticModel model(scene.Description);
  NeedleHand hand(model);
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(6.0));
  ASSERT_TRUE(hand.State.Needle.IsInserted);
  for (int tick = 0; tick < 3; ++tick)
  {
    hand.MoveTo(Along(50.0), 100.0);
    EXPECT_NEAR(hand.ComputeDepth(), 35.0 - 2.0, 0.1) << tick;
  }
  EXPECT_EQ(hand.State.Needle.Touches, 1U);
}

// The needle stops 2 mm in front of a forbidden label. A stop counts once, whatever its duration
// is.
TEST(NeedleTissue, StopsBeforeForbiddenLabels)
{
  NeedleScene scene(LayersOfN1());
  ASSERT_NO_FATAL_FAILURE(Forbid(scene, 3));
  const HapticModel model(scene.Description);
  NeedleHand hand(model);
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(30.0));
  EXPECT_NEAR(hand.ComputeDepth(), 15.0 - 2.0, 0.1);
  EXPECT_EQ(hand.State.Needle.Touches, 1U);
  hand.MoveTo(Along(10.0));
  hand.MoveTo(Along(30.0));
  EXPECT_EQ(hand.State.Needle.Touches, 2U);
}

TEST(NeedleTissue, OffersNothingOutsideTheVolumeNorInWhatIsNoNumber)
{
  TestVolume volume(ScalarType::Float32, { 24, 24, 24 });
  volume.Fill<float>([](std::int64_t, std::int64_t, std::int64_t)
    { return std::numeric_limits<float>::quiet_NaN(); });
  HapticModelDescription description = Describe(volume);
  NeedleDescription needle;
  needle.ShaftFriction = ConstantPolyline(30.0);
  description.Tool = std::make_shared<const BakedNeedle>(needle);
  const HapticModel model(description);
  LabelMemory memory;
  const NeedleTissueReader reader(model, 0.0, memory);
  EXPECT_FALSE(reader.At({ -1.0, 0.0, 0.0 }).Resists());
  NeedleHand hand(model);
  hand.MoveTo(Along(-5.0));
  hand.MoveTo(Along(30.0));
  EXPECT_TRUE(IsFinite(hand.Record.Force));
}

// A recording that begins with an inserted needle must continue identically, to the bit.
TEST(NeedleState, GoesOnFromItsNumbersToTheBit)
{
  std::vector<Layer> layers = LayersOfN1();
  layers[0].Puncture = 1.0;
  NeedleScene scene(layers);
  const HapticModel model(scene.Description);
  NeedleHand hand(model);
  hand.State.HasOrientation = true;
  hand.State.Orientation = { 0.0, 1.0, 0.0, 0.0 };
  hand.MoveTo(Along(2.0));
  hand.MoveTo(Along(33.0));
  ASSERT_TRUE(hand.State.Needle.IsInserted);
  const auto numbers = ToNumbers(hand.State);
  ASSERT_TRUE(AreOfAState(numbers));
  NeedleHand other(hand);
  other.State = FromNumbers(numbers);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 at = Along(33.0 + 8.0 * std::sin(0.02 * i));
    const TickRecord first = hand.Place(at);
    const TickRecord second = other.Place(at);
    ASSERT_EQ(first.Force.X, second.Force.X);
    ASSERT_EQ(first.Force.Z, second.Force.Z);
    ASSERT_EQ(first.Proxy.Z, second.Proxy.Z);
  }
  const auto flawed = [&numbers](std::size_t i, double value)
  {
    auto bad = numbers;
    bad[i] = value;
    return AreOfAState(bad);
  };
  // The needle's numbers begin at this index, at the end of a state.
  constexpr std::size_t needle = 101 + 5;
  EXPECT_FALSE(flawed(needle, 2.0));
  EXPECT_FALSE(flawed(needle + 2, 3.0));
  EXPECT_FALSE(flawed(needle + 11, -1.0));
  EXPECT_FALSE(flawed(needle + 23, 33.0));
  EXPECT_FALSE(flawed(needle + 23, 0.0));
  EXPECT_FALSE(flawed(needle + 24, std::nan("")));
}
