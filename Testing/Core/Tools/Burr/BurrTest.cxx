// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the removal by a burr with closed forms (B1 to B3 of the design). A sphere of radius a
 * that has sunk by h into a half-space has removed V = pi h^2 (3 a - h)/3, at the rate Q = mu F
 * v/U.
 */

#include "Rigs/BurrRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// Searches for the depth (mm) at which a sphere of radius a (mm) has removed a volume (mm^3).
double ComputeDepth(double a, double volume)
{
  double low = 0.0;
  double high = a;
  for (int i = 0; i < 60; ++i)
  {
    const double h = 0.5 * (low + high);
    (Pi * h * h * (3.0 * a - h) / 3.0 < volume ? low : high) = h;
  }
  return low;
}
} // namespace

/// B1: the burr has a power of 7.54 W, which removes 0.754 mm^3/s at 10 J/mm^3.
TEST(Burr, HasThePowerOfItsRim)
{
  const BakedBurr burr({ MakeBurr(5e10, 100.0), ConstantPolyline(10.0) });
  EXPECT_NEAR(0.001 * burr.RimSpeed, 12.566, 1e-3);
  EXPECT_NEAR(0.3 * 2.0 * 0.001 * burr.RimSpeed, 7.54, 1e-3);
}

/// B1: with 2 N, the burr is 0.250, 0.357 and 0.512 mm deep after 0.5, 1 and 2 s. Voxels are 0.03
/// mm.
TEST(Burr, SinksIntoAHalfSpaceAsItsVolumeIsRemoved)
{
  constexpr double size = 0.03;
  HalfSpace half({ 112, 112, 44 }, size, 12);
  BurrInVolume hand(half.Scene, MakeBurr(5e10, 100.0), ConstantPolyline(10.0), 4000);
  const double middle = 55.6 * size;
  hand.Tick({ middle, middle, half.Surface - 2.05 });
  int ticks = 0;
  double before = 0.0;
  for (const auto& [seconds, expected] :
    { std::pair<double, double>{ 0.5, 0.250 }, { 1.0, 0.357 }, { 2.0, 0.512 } })
  {
    for (; ticks < static_cast<int>(std::lround(1000.0 * seconds)); ++ticks)
    {
      hand.Press(2.0);
      before = before == 0.0 ? hand.Earned : before;
    }
    EXPECT_NEAR(Norm(hand.Record.Shell.Force), 2.0, 0.02);
    const double rate = 0.3 * 2.0 * 12.566 / 10.0;
    EXPECT_NEAR(hand.Removed, rate * seconds, 0.01 * rate * seconds) << "B3";
    if (seconds >= 1.0)
    {
      // With voxels of 0.03 mm, the sum of the fractions also equals the volume.
      double sum = 0.0;
      std::int64_t at = 0;
      for (const std::uint8_t fraction :
        CopyTissue(half.Removal->Bricks, half.Volume.View.Dimensions))
      {
        sum += at++ >= 12 * 112 * 112 ? size * size * size * (255.0 - fraction) / 255.0 : 0.0;
      }
      EXPECT_NEAR(sum, rate * seconds, 0.01 * rate * seconds);
    }
    const double depth = ComputeDepth(2.0, rate * seconds);
    EXPECT_NEAR(depth, expected, 6e-4);
    // Search below the middle for the depth at which half of the tissue remains.
    const FieldSampler& field = hand.Model.Baked->Field;
    double low = half.Surface / size;
    double high = 40.0;
    for (int i = 0; i < 40; ++i)
    {
      const double z = 0.5 * (low + high);
      (field.Value({ middle / size, middle / size, z }) < 100.0 ? low : high) = z;
    }
    EXPECT_NEAR(low * size - half.Surface, depth, 0.01 * depth) << "after " << seconds << " s";
  }
  EXPECT_FALSE(half.Removal->IsUsedUp());
}

/// B3, with levels of contact at several fractions of the tissue's value. In a CT, for example, the
/// level may be that of skin, far below bone.
TEST(Burr, GoesOnWhereverTheLevelOfContactLies)
{
  constexpr double size = 0.5;
  constexpr double force = 10.0;
  for (const double level : { 10.0, 20.0, 40.0, 100.0, 160.0 })
  {
    HalfSpace half({ 32, 32, 24 }, size, 10);
    BurrInVolume hand(half.Scene, MakeBurr(5e10, level), ConstantPolyline(10.0), 2000);
    hand.Tick({ 15.6 * size, 15.4 * size, half.Surface - 2.0 - size });
    double before = 0.0;
    for (int i = 0; i < 1500; ++i)
    {
      hand.Press(force);
      before = i == 500 ? hand.Removed : before;
    }
    EXPECT_NEAR(Norm(hand.Record.Shell.Force), force, 0.01 * force) << level;
    const double rate = 0.3 * force * 12.566 / 10.0;
    EXPECT_NEAR(hand.Removed - before, rate, 0.02 * rate) << level;
  }
}

/// B3, in tissue whose value rises slowly from the level on. All samples of a layer have the same
/// value. If a sample lost its whole volume as soon as its first part was removed, the burr would
/// have to pay for a whole layer at once; it must spend its energy steadily instead.
TEST(Burr, GoesOnSteadilyWhereTissueBeginsAtTheLevel)
{
  const TestVolume volume = MakeRamp(16);
  HapticModelDescription scene = Describe(volume);
  scene.Removal = std::make_shared<TissueRemoval>();
  BurrInHand settings;
  settings.Radius = 2.5;
  settings.Shell.Level = 800.0;
  BurrInVolume hand(scene, settings, ConstantPolyline(1.0), 1000);
  hand.Tick({ 7.0, 7.0, 4.0 });
  hand.IsSpinning = false;
  hand.Lead({ 7.0, 7.0, 9.0 });
  hand.IsSpinning = true;
  for (int tick = 1; tick <= 3000; ++tick)
  {
    hand.Tick({ 7.0, 7.0, 9.0 });
    ASSERT_GE(hand.Energy, hand.Earned - 1.0) << "J after " << tick << " ms";
  }
  EXPECT_LE(hand.Energy, hand.Earned);
}

/// Press on bone in a head CT with the level of skin. Grainy bone of 1500 HU is far above this
/// level, so the burr could get stuck between the samples of the hole's walls. It must continue,
/// and its energy must remove tissue.
TEST(Burr, GoesOnInBoneWithTheLevelOfSkin)
{
  const Vector3 spacing{ 0.957, 0.957, 1.5 };
  TestVolume volume(ScalarType::Int16, { 26, 44, 18 });
  std::mt19937_64 engine(52);
  volume.Fill<std::int16_t>(
    [&](std::int64_t, std::int64_t j, std::int64_t)
    {
      const double grain = static_cast<double>(engine() % 600) - 300.0;
      return static_cast<std::int16_t>(j < 10 ? -1024.0 : (j < 13 ? 40.0 : 1500.0 + grain));
    });
  HapticModelDescription scene = Describe(volume);
  scene.IndexToWorld.Linear = { { { spacing.X, 0, 0 }, { 0, spacing.Y, 0 }, { 0, 0, spacing.Z } } };
  scene.Removal = std::make_shared<TissueRemoval>();
  scene.AirValue = -1024.0;
  BurrInHand settings;
  settings.Radius = 4.0;
  settings.Shell.Level = -300.0;
  const Polyline energies{ { -300.0, 0.2 }, { 1800.0, 2.0 } };
  BurrInVolume hand(scene, settings, energies, 1000);
  Vector3 at{ 12.7 * spacing.X, 1.0, 8.6 * spacing.Z };
  hand.Tick(at);
  double before = 0.0;
  for (int second = 0; second < 6; ++second)
  {
    for (int i = 0; i < 1000; ++i)
    {
      const double tool = 1000.0 * hand.Record.Shell.Tool.Position.Y;
      at.Y = std::min(at.Y + 0.05, tool + 1000.0 * 10.0 / settings.Shell.CouplingStiffness);
      hand.Tick(at);
    }
    // The burr may save the rest of a second's energy for a step in the next second.
    EXPECT_GT(hand.Energy - before, 0.5 * 0.3 * 10.0 * 25.13 * (second == 0 ? 0.5 : 1.0))
      << "J in second " << second;
    before = hand.Energy;
  }
  EXPECT_LE(hand.Energy, hand.Earned);
  EXPECT_GE(hand.Energy, 0.95 * hand.Earned);
}

/// B3, on a random path through tissues of 2 to 20 J/mm^3: the cost of the removed tissue must
/// equal the energy that the burr has spent, which must not exceed its available energy.
TEST(Burr, RemovesWhatItsEnergyPaysFor)
{
  TestVolume volume(ScalarType::Int16, { 64, 64, 64 });
  std::mt19937_64 engine(6);
  volume.Fill<std::int16_t>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const double bumps = 3.0 * std::sin(0.2 * i) * std::cos(0.25 * j);
      const double tissue = 1000.0 + 600.0 * std::sin(0.3 * i + 0.2 * k);
      return static_cast<std::int16_t>(k > 20.0 + bumps ? tissue + (engine() % 100) : 0.0);
    });
  HapticModelDescription scene = Describe(volume);
  scene.IndexToWorld.Linear = 0.4 * Matrix3{};
  scene.Removal = std::make_shared<TissueRemoval>();
  const Polyline energies{ { 400.0, 2.0 }, { 1700.0, 20.0 } };
  BurrInVolume hand(scene, MakeBurr(5e9, 300.0), energies, 1000);
  Vector3 at{ 12.0, 12.0, 4.0 };
  hand.Tick(at);
  double least = 0.0;
  double most = 0.0;
  for (int leg = 0; leg < 24; ++leg)
  {
    const Vector3 goal = Vector3{ 12.8, 12.8, 12.0 } + RandomIn(engine, 6.0);
    for (int i = 0; i < 250; ++i)
    {
      // Limit the speed to 0.02 mm per tick and the force to 3 N.
      const Vector3 step = ClampNorm(goal - at, 0.02);
      const Vector3 tool = 1000.0 * hand.Record.Shell.Tool.Position;
      at = tool + ClampNorm(at + step - tool, 6.0);
      hand.Tick(at);
      least = std::min(least, hand.Earned - hand.Energy);
      most = std::max(most, Norm(hand.Record.Force));
    }
  }
  EXPECT_GE(least, -1e-12) << "J: nothing is removed in advance";
  EXPECT_LE(most, 3.1);
  EXPECT_GE(hand.Energy, 0.99 * hand.Earned);
  EXPECT_GT(hand.Removed, 3.0);
  // Sum the cost of the removed tissue over all samples.
  const SpecificEnergyTable table({ energies, ConstantPolyline(0.0) });
  double cost = 0.0;
  double missing = 0.0;
  std::size_t n = 0;
  for (const std::uint8_t fraction : CopyTissue(scene.Removal->Bricks, volume.View.Dimensions))
  {
    const auto i = static_cast<std::int64_t>(n++);
    const double value = volume(i % 64, i / 64 % 64, i / 4096);
    const double part =
      value >= 300.0 ? 0.4 * 0.4 * 0.4 * (1.0 - LeftOf(fraction, EdgeOf(value, 300.0, 0.0))) : 0.0;
    missing += part;
    cost += part * table(value)[0];
  }
  EXPECT_NEAR(cost, hand.Energy, 1e-9 * cost);
  EXPECT_NEAR(missing, hand.Removed, 1e-9 * missing);
}

/// B2: a point feels a cavity where it was carved, with the right normals, if the cavity's radius
/// is at least ten voxels. For smaller radii, the normals and the level of half of the tissue are
/// still right, but the condition of the edge, V(x_p) >= (V(x_s) + V(x_v))/2, is fulfilled early.
/// The reason is that x_s and x_v are one voxel to each side of x_p. While x_p is within half a
/// voxel of the edge, both are on the ramp of three voxels, where only the curvature decides.
TEST(Burr, ItsCavityIsFeltWithThePoint)
{
  TestVolume volume(ScalarType::Int16, { 48, 48, 48 });
  volume.Fill<std::int16_t>([](std::int64_t, std::int64_t, std::int64_t) { return 1000; });
  HapticModelDescription scene = Describe(volume);
  scene.Removal = std::make_shared<TissueRemoval>();
  scene.Material.SurfaceStrength = ConstantPolyline(1e6);
  scene.Material.Distinctness = { { 20.0, 0.0 }, { 100.0, 1.0 } };
  const HapticModel model(scene);
  for (const double radius : { 4.0, 8.0, 10.0, 12.0 })
  {
    scene.Removal->Request(RemovalRequest::Reset);
    while (scene.Removal->Serve())
    {
    }
    const Vector3 centre{ 23.6, 23.3, 24.1 };
    SphereCarver carver;
    const SpecificEnergyTable energies({ ConstantPolyline(10.0), ConstantPolyline(0.0) });
    carver.SetTissue(model, { 500.0, false, &energies });
    carver.Try(*scene.Removal, 0.001 * centre, 0.001 * radius);
    carver.Carve(*scene.Removal);
    double worst = 0.0;
    double angle = 0.0;
    double squares = 0.0;
    std::mt19937_64 engine(5);
    for (int i = 0; i < 100; ++i)
    {
      Vector3 ray = RandomIn(engine, 1.0);
      ray = (1.0 / Norm(ray)) * ray;
      ServoState state;
      TickRecord record;
      for (double r = 0.0; r <= radius + 1.5; r += 0.1)
      {
        Tick(model, state, 0.001 * (centre + r * ray), record);
      }
      EXPECT_GT(Norm(record.Force), 0.3);
      const Vector3 felt = 1000.0 * record.Proxy - centre;
      worst = std::max(worst, std::abs(Norm(felt) - radius));
      double low = 0.0;
      double high = radius + 3.0;
      for (int n = 0; n < 40; ++n)
      {
        const double r = 0.5 * (low + high);
        (model.Baked->Field.Value(centre + r * ray) < 500.0 ? low : high) = r;
      }
      squares += std::pow(low - radius, 2);
      const double cosine = Dot(record.Normal, felt) / Norm(felt);
      angle = std::max(angle, 180.0 / Pi * std::acos(std::min(1.0, cosine)));
    }
    EXPECT_LE(worst, radius < 10.0 ? 0.5 : 0.05) << "voxels, at a radius of " << radius;
    EXPECT_LE(std::sqrt(squares / 100.0), 0.05) << "voxels, at a radius of " << radius;
    EXPECT_LE(angle, 1.0) << "degrees";
  }
}

/// A drilled hole has the radius of the burr, not of the part that presses. In the hole's straight
/// part, one kernel away from its ends, the radius must be right within 0.05 voxel RMS, and the
/// normals within 0.5 degree on average. Burrs have radii of 4 and 8 voxels. In some volumes,
/// voxels are twice as long along one axis.
///
/// The gradients are differences over one voxel. The default kernel has a width in voxels, so in
/// such volumes it would turn the normals of curved surfaces by up to (s_x^2 - s_y^2)/(2 a^2),
/// where s is its standard deviation in mm.
TEST(Burr, ItsHoleHasItsRadius)
{
  struct Case
  {
    double Spacing; ///< mm along x; 0.25 mm along y and z
    double Voxels;  ///< radius of the burr, in edges of a cube with a voxel's volume
  };
  for (const auto& [spacing, voxels] : { Case{ 0.25, 4.0 }, Case{ 0.25, 8.0 }, Case{ 0.5, 8.0 } })
  {
    constexpr double size = 0.25;
    const double voxel = std::cbrt(spacing * size * size);
    const double radius = voxels * voxel;
    HalfSpace half({ 48, 48, 56 }, size, 16);
    half.Scene.IndexToWorld.Linear.Row[0].X = spacing;
    BurrInHand settings = MakeBurr(2e10, 100.0);
    settings.Radius = radius;
    BurrInVolume hand(half.Scene, settings, ConstantPolyline(0.3), 1000);
    const Vector3 middle{ 23.7 * spacing, 23.7 * size, half.Surface - radius - 0.3 };
    hand.Tick(middle);
    double depth = 0.0;
    const double wanted = radius + 9.0 * size;
    for (int i = 0; i < 20000 && depth < wanted; ++i)
    {
      hand.Press(2.0);
      depth = 1000.0 * hand.Record.Shell.Tool.Position.Z + radius - half.Surface;
    }
    ASSERT_GE(depth, wanted);
    HapticModelDescription scene = half.Scene;
    scene.Estimator = GradientEstimator::CentralDifference;
    scene.KernelRadius = 1;
    const HapticModel seen(scene);
    const bool isCube = spacing == size;
    const FieldSampler& field = seen.Baked->Field;
    double squares = 0.0;
    double angles = 0.0;
    double felt = 0.0;
    int rays = 0;
    for (double below = 4.1 * size; below < 6.5 * size; below += 0.3 * size)
    {
      for (int i = 0; i < 90; ++i, ++rays)
      {
        const Vector3 ray{ std::cos(Pi * i / 45.0), std::sin(Pi * i / 45.0), 0.0 };
        const auto toIndex = [&](double r)
        {
          const Vector3 at = Vector3{ middle.X, middle.Y, half.Surface + below } + r * ray;
          return Vector3{ at.X / spacing, at.Y / size, at.Z / size };
        };
        double low = 0.0;
        double high = radius + 4.0 * size;
        for (int n = 0; n < 40; ++n)
        {
          const double r = 0.5 * (low + high);
          (field.Value(toIndex(r)) < 100.0 ? low : high) = r;
        }
        squares += std::pow((low - radius) / voxel, 2);
        const auto angleOf = [&](const FieldSampler& sampler)
        {
          const Vector3 g = sampler.Gradient(toIndex(low)).Gradient;
          const Vector3 normal{ g.X / spacing, g.Y / size, g.Z / size };
          return 180.0 / Pi * std::acos(std::min(1.0, Dot(normal, ray) / Norm(normal)));
        };
        angles += angleOf(field);
        felt += isCube ? angleOf(hand.Model.Baked->Field) : 0.0;
      }
    }
    const double rms = std::sqrt(squares / rays);
    EXPECT_LE(rms, 0.05) << voxels << " voxels, spacing " << spacing;
    EXPECT_LE(felt / rays, 0.5) << voxels << " voxels";
    EXPECT_LE(angles / rays, 0.5) << voxels << " voxels, spacing " << spacing;
  }
}

TEST(Burr, ThatDoesNotSpinRemovesNothing)
{
  HalfSpace half({ 40, 40, 40 }, 0.4, 16);
  BurrInVolume hand(half.Scene, MakeBurr(5e9, 100.0), ConstantPolyline(10.0));
  hand.IsSpinning = false;
  const Vector3 above{ 8.0, 8.0, half.Surface - 2.5 };
  hand.Tick(above);
  hand.Lead(above + Vector3{ 0.0, 0.0, 4.0 });
  EXPECT_GT(Norm(hand.Record.Force), 1.0);
  EXPECT_TRUE(half.Removal->Bricks.IsEmpty());
  // A burr that spins beside the tissue removes nothing, nor does a tick without duration.
  hand.Lead(above);
  hand.IsSpinning = true;
  hand.Lead(above + Vector3{ 0.0, 0.0, 0.49 });
  EXPECT_EQ(hand.Record.Shell.Contacts, 0u);
  hand.Step = 0.0;
  hand.Lead(above + Vector3{ 0.0, 0.0, 4.0 });
  hand.Step = std::numeric_limits<double>::quiet_NaN();
  hand.Lead(above + Vector3{ 0.0, 0.0, 4.2 });
  EXPECT_EQ(hand.Removed, 0.0);
  EXPECT_TRUE(half.Removal->Bricks.IsEmpty());
  hand.Step = 1e-3;
  hand.Lead(above + Vector3{ 0.0, 0.0, 4.3 }, 1e-3);
  EXPECT_GT(hand.Removed, 0.0);
}

/// The burr meets tissue that nothing can remove, next to softer tissue. The energy that did not
/// suffice for the hard tissue must not be saved for the soft tissue.
TEST(Burr, SavesNothingUpAtWhatItCannotRemove)
{
  TestVolume volume(ScalarType::UInt8, { 80, 40, 40 });
  volume.Fill<std::uint8_t>([](std::int64_t i, std::int64_t, std::int64_t k)
    { return static_cast<std::uint8_t>(k < 16 ? 0 : (i < 40 ? 250 : 200)); });
  for (const double hard : { 1e9, std::numeric_limits<double>::infinity() })
  {
    HapticModelDescription scene = Describe(volume);
    scene.IndexToWorld.Linear = 0.4 * Matrix3{};
    scene.Removal = std::make_shared<TissueRemoval>();
    const Polyline energies{ { 200.0, 10.0 }, { 225.0, 10.0 }, { 225.0, hard } };
    BurrInVolume hand(scene, MakeBurr(5e9, 100.0), energies);
    hand.Tick({ 8.0, 8.0, 3.8 });
    for (int i = 0; i < 2000; ++i)
    {
      hand.Press(2.0);
    }
    EXPECT_LE(hand.Removed, 1e-3);
    hand.Lead({ 8.0, 8.0, 2.0 });
    hand.Lead({ 24.0, 8.0, 2.0 }, 0.2);
    hand.Lead({ 24.0, 8.0, 4.0 });
    const double before = hand.Earned;
    const double energy = hand.Energy;
    for (int i = 0; i < 500; ++i)
    {
      hand.Press(2.0);
    }
    const double earned = hand.Earned - before;
    EXPECT_NEAR(hand.Energy - energy + hand.State.Unspent, earned, 1e-9 * earned);
    EXPECT_GE(hand.Energy - energy, 0.9 * earned) << "it drills on, in steps of a share";
  }
}

/// A burr of 30 voxels needs more than one tick to examine its surroundings. Each tick may do at
/// most the bounded work, and the burr must remove the tissue that it can pay for (B3). In tissue
/// that costs almost nothing, the burr falls behind, loses no energy, and catches up as soon as the
/// hand rests.
TEST(Burr, DoesNoMoreInATickThanThereIsTimeFor)
{
  struct Case
  {
    double Energy; ///< J/mm^3
    double Speed;  ///< mm per tick, into the tissue
  };
  for (const auto& [energy, speed] : { Case{ 0.05, 0.016 }, Case{ 1e-4, 0.08 } })
  {
    HalfSpace half({ 96, 96, 96 }, 1.0, 40);
    BurrInHand settings = MakeBurr(5e9, 100.0);
    settings.Radius = 30.0;
    BurrInVolume hand(half.Scene, settings, ConstantPolyline(energy), 1000);
    const Vector3 above{ 47.6, 47.3, half.Surface - 30.5 };
    hand.Tick(above);
    std::size_t most = 0;
    int bounded = 0;
    const auto tick = [&](const Vector3& at)
    {
      const BurrRecord& record = hand.Tick(at);
      most = std::max(most, record.Work);
      bounded += record.Work >= MostBurrWork ? 1 : 0;
      EXPECT_TRUE(hand.State.Part == 0 || record.IsUnfinished);
    };
    for (double depth = 0.0; depth < 16.0; depth += speed)
    {
      tick(above + Vector3{ 0.25 * depth, 0.0, depth });
    }
    EXPECT_GT(bounded, 100) << "or it is not the case that is meant";
    EXPECT_NEAR(hand.Energy + hand.State.Unspent, hand.Earned, 1e-9 * hand.Earned);
    const double expected = hand.Earned / energy;
    if (energy > 1e-3)
    {
      EXPECT_NEAR(hand.Removed, expected, 0.01 * expected);
      EXPECT_LT(most, MostBurrWork + SphereCarver::MostWorkOfBrick);
      continue;
    }
    EXPECT_LT(hand.Removed, 0.9 * expected);
    const Vector3 at = 1000.0 * hand.Record.Shell.Hand.Position;
    for (int i = 0; i < 1500; ++i)
    {
      tick(at);
    }
    EXPECT_LT(most, MostBurrWork + SphereCarver::MostWorkOfBrick);
    EXPECT_LE(Norm(hand.Record.Shell.Force), 0.02) << "N";
    EXPECT_EQ(hand.State.Part, 0u);
  }
}

/// A step of a burr of 30 voxels takes several ticks. If a later tick meets a layer that nothing
/// can remove, the burr tries shorter steps. A sample of this layer takes energy as soon as it is a
/// quarter of a voxel in front of the sphere (1/12 of the ramp), so the burr must get at least as
/// near.
TEST(Burr, ComesToALayerThatALaterPartOfItsStepCannotRemove)
{
  TestVolume volume(ScalarType::UInt8, { 96, 96, 96 });
  volume.Fill<std::uint8_t>([](std::int64_t, std::int64_t, std::int64_t k)
    { return static_cast<std::uint8_t>(k < 40 ? 0 : (k < 50 ? 200 : 250)); });
  HapticModelDescription scene = Describe(volume);
  const Polyline energies{ { 200.0, 1e-5 }, { 225.0, 1e-5 },
    { 225.0, std::numeric_limits<double>::infinity() } };
  BurrInHand settings = MakeBurr(5e9, 100.0);
  settings.Radius = 30.0;
  const Vector3 nearest{ 48.0, 47.0, 50.0 };
  for (const double above : { 0.03, 0.12, 0.18 })
  {
    scene.Removal = std::make_shared<TissueRemoval>();
    BurrInVolume hand(scene, settings, energies, 1000);
    // Move so fast that the burr falls behind and makes steps of the largest length.
    const Vector3 begin{ 47.6, 47.3, 9.0 - above };
    hand.Tick(begin);
    int divided = 0;
    for (int i = 0; i < 800; ++i)
    {
      hand.Tick(begin + Vector3{ 0.0, 0.0, std::min(0.08 * i, 16.0) });
      divided += hand.State.Part > 0 ? 1 : 0;
    }
    EXPECT_GT(divided, 100);
    const double distance = Norm(nearest - 1000.0 * hand.State.Carved);
    // The tolerance is one portion of removal (3/255 voxel) plus the shortest step (1/128 voxel).
    EXPECT_NEAR(distance, 30.25, 3.0 / 255.0 + 1.0 / 128.0) << above;
  }
}

TEST(Burr, WithoutBricksRemovesNoMoreAndSaysSo)
{
  HalfSpace half({ 40, 40, 40 }, 0.4, 16);
  half.Scene.Removal = half.Removal = std::make_shared<TissueRemoval>(4);
  BurrInVolume hand(half.Scene, MakeBurr(5e9, 100.0), ConstantPolyline(0.1));
  hand.Tick({ 7.8, 7.8, half.Surface - 2.1 });
  for (int i = 0; i < 3000; ++i)
  {
    hand.Press(2.0);
  }
  EXPECT_TRUE(half.Removal->IsUsedUp());
  EXPECT_LE(half.Removal->Bricks.GetCount(), 4u);
  EXPECT_NEAR(Norm(hand.Record.Force), 2.0, 0.02) << "what is left holds the burr";
  const double depth = 1000.0 * hand.Record.Shell.Tool.Position.Z + 2.0 - half.Surface;
  EXPECT_LE(depth, 4.0);
}
