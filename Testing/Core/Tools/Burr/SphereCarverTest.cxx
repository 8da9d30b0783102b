// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares removed spheres with loops over all samples, and with the exact sphere.
 */

#include "Core/Tools/Burr/SphereCarver.h"
#include "Rigs/CarvingRig.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// Returns a volume of tissue with the value 1000.
TestVolume MakeTissue(std::int64_t samples)
{
  TestVolume volume(ScalarType::Int16, { samples, samples, samples });
  volume.Fill<std::int16_t>([](std::int64_t, std::int64_t, std::int64_t) { return 1000; });
  return volume;
}

class CarvedSphere : public testing::Test
{
protected:
  CarvingCost Try(
    const HapticModel& model, const Vector3& centre, double radius, const Vector3* from = nullptr)
  {
    this->Carver.SetTissue(model, { 500.0, false, &this->Energies });
    return this->Carver.Try(this->Removal, centre, radius, from);
  }
  CarvingCost Carve(
    const HapticModel& model, const Vector3& centre, double radius, const Vector3* from = nullptr)
  {
    const CarvingCost cost = this->Try(model, centre, radius, from);
    this->Carver.Carve(this->Removal);
    return cost;
  }

  TissueRemoval Removal{ 4096 };
  SphereCarver Carver;
  SpecificEnergyTable Energies{ { ConstantPolyline(10.0), ConstantPolyline(0.0) } };
};

struct SurfaceError
{
  double Rms = 0.0;       ///< voxels
  double MeanAngle = 0.0; ///< degrees
  double MostAngle = 0.0;
};

/// Follows rays from the centre to the level of half of the tissue. Returns the errors of their
/// lengths and of the normals there.
SurfaceError MeasureSurface(const TestVolume& left, const Vector3& centre, double radius)
{
  const GradientKernel kernel(GradientEstimator::CentralDifference, 1);
  const FieldSampler field(left.View, kernel);
  SurfaceError error;
  constexpr int rays = 2000;
  const double golden = Pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < rays; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / rays;
    const double r = std::sqrt(1.0 - z * z);
    const Vector3 ray{ r * std::cos(golden * i), r * std::sin(golden * i), z };
    double low = 0.0;
    double high = radius + 3.0;
    for (int n = 0; n < 50; ++n)
    {
      const double middle = 0.5 * (low + high);
      (field.Value(centre + middle * ray) < 500.0 ? low : high) = middle;
    }
    error.Rms += std::pow(low - radius, 2);
    const Vector3 g = field.Gradient(centre + low * ray).Gradient;
    const double angle = 180.0 / Pi * std::acos(std::min(1.0, Dot(g, ray) / Norm(g)));
    error.MeanAngle += angle / rays;
    error.MostAngle = std::max(error.MostAngle, angle);
  }
  error.Rms = std::sqrt(error.Rms / rays);
  return error;
}
} // namespace

/// Spheres that are not centred on samples, with radii of 4 voxels and more. The design has errors
/// of 0.044 voxel and 0.22 degrees for 4 voxels, and of 0.022 voxel and 0.17 degrees for 8 voxels.
TEST_F(CarvedSphere, HasASmoothSurfaceInItsPlace)
{
  const TestVolume tissue = MakeTissue(32);
  const HapticModel model(Describe(tissue));
  std::mt19937_64 engine(14);
  for (const double radius : { 4.0, 8.0, 11.3 })
  {
    SurfaceError worst;
    for (int n = 0; n < 5; ++n)
    {
      TissueRemoval removal(512);
      const Vector3 centre = Vector3{ 15.5, 15.5, 15.5 } + RandomIn(engine, 0.5);
      this->Carver.SetTissue(model, { 500.0, false, &this->Energies });
      this->Carver.Try(removal, 0.001 * centre, 0.001 * radius);
      this->Carver.Carve(removal);
      const SurfaceError error =
        MeasureSurface(MakeLeft(tissue, removal.Bricks, 0.0), centre, radius);
      worst.Rms = std::max(worst.Rms, error.Rms);
      worst.MeanAngle = std::max(worst.MeanAngle, error.MeanAngle);
      worst.MostAngle = std::max(worst.MostAngle, error.MostAngle);
    }
    RecordProperty("rms_of_" + std::to_string(radius), std::to_string(worst.Rms));
    EXPECT_LE(worst.Rms, 0.05) << radius;
    EXPECT_LE(worst.MeanAngle, 0.5) << radius;
    EXPECT_LE(worst.MostAngle, 1.0) << radius;
  }
}

/// The remaining tissue must begin at the sphere, for any level. The tissue is grainy: its samples
/// reach the level at fractions of 0.27 to 0.8.
TEST_F(CarvedSphere, HasTheLevelOfContactInItsPlace)
{
  TestVolume tissue(ScalarType::Int16, { 32, 32, 32 });
  std::mt19937_64 engine(52);
  tissue.Fill<std::int16_t>([&](std::int64_t, std::int64_t, std::int64_t)
    { return static_cast<std::int16_t>(900 + engine() % 201); });
  const HapticModel model(Describe(tissue));
  constexpr double radius = 8.0;
  const Vector3 centre{ 15.6, 15.3, 15.8 };
  const GradientKernel kernel(GradientEstimator::CentralDifference, 1);
  for (const double level : { 300.0, 500.0, 700.0 })
  {
    TissueRemoval removal(512);
    this->Carver.SetTissue(model, { level, false, &this->Energies });
    this->Carver.Try(removal, 0.001 * centre, 0.001 * radius);
    this->Carver.Carve(removal);
    const TestVolume left = MakeLeft(tissue, removal.Bricks, 0.0);
    const FieldSampler field(left.View, kernel);
    double squares = 0.0;
    constexpr int rays = 500;
    for (int i = 0; i < rays; ++i)
    {
      const Vector3 random = RandomIn(engine, 1.0);
      const Vector3 ray = (1.0 / Norm(random)) * random;
      double low = 0.0;
      double high = radius + 3.0;
      for (int n = 0; n < 50; ++n)
      {
        const double middle = 0.5 * (low + high);
        (field.Value(centre + middle * ray) < level ? low : high) = middle;
      }
      squares += std::pow(low - radius, 2);
    }
    EXPECT_LE(std::sqrt(squares / rays), 0.05) << "voxels, at the level " << level;
  }
}

/// Compare random spheres, and a sphere that moves in steps of a quarter of a voxel, with loops
/// over all samples.
TEST_F(CarvedSphere, IsThatOfLoopsOverAllSamples)
{
  const TestVolume tissue = MakeTissue(40);
  const HapticModel model(Describe(tissue));
  const std::int64_t* const n = tissue.View.Dimensions;
  std::vector<std::uint8_t> expected(40 * 40 * 40, 255);
  std::mt19937_64 engine(15);
  double volume = 0.0;
  for (int way = 0; way < 12; ++way)
  {
    const double radius = std::uniform_real_distribution<double>(1.0, 7.0)(engine);
    Vector3 at = Vector3{ 19.5, 19.5, 19.5 } + RandomIn(engine, 24.0);
    const Vector3 step = RandomIn(engine, 0.14);
    const Vector3* from = nullptr;
    Vector3 last;
    for (int i = 0; i < 20; ++i)
    {
      const CarvingCost cost = this->Carve(model, 0.001 * at, 0.001 * radius, from);
      CarveSlowly(expected, n, at, radius);
      volume += cost.Volume;
      EXPECT_NEAR(cost.Energy, 10.0 * cost.Volume, 1e-9 * cost.Energy);
      EXPECT_TRUE(cost.Next == 0 && !cost.IsUsedUp);
      last = 0.001 * at;
      from = &last;
      at += step;
    }
  }
  const std::vector<std::uint8_t> fractions = CopyTissue(this->Removal.Bricks, n);
  double removed = 0.0;
  int different = 0;
  for (std::size_t i = 0; i < fractions.size(); ++i)
  {
    ASSERT_LE(std::abs(fractions[i] - expected[i]), 1);
    different += fractions[i] != expected[i] ? 1 : 0; // differs by a rounded distance
    removed += 1.0 - LeftOf(fractions[i]);
  }
  EXPECT_LE(different, 5);
  EXPECT_GT(removed, 3000.0);
  EXPECT_NEAR(volume, removed, 1e-9 * removed);
}

/// In an image with any placement, the removed volume is 4 pi/3 a^3.
TEST_F(CarvedSphere, HasItsVolumeInAnyImage)
{
  const TestVolume tissue = MakeTissue(64);
  HapticModelDescription scene = Describe(tissue);
  const Matrix3 turn = ToMatrix(TurnAbout({ 1.0, 2.0, -0.5 }, 0.7));
  scene.IndexToWorld.Linear = turn * Matrix3{ { { 0.4, 0, 0 }, { 0, -0.5, 0 }, { 0, 0, 0.7 } } };
  scene.IndexToWorld.Offset = { 10.0, -20.0, 5.0 };
  const HapticModel model(scene);
  const Vector3 centre = 0.001 * scene.IndexToWorld(Vector3{ 30.2, 31.7, 32.4 });
  constexpr double a = 5.0; // mm
  const CarvingCost cost = this->Try(model, centre, 0.001 * a);
  const double expected = 4.0 * Pi / 3.0 * a * a * a;
  EXPECT_NEAR(cost.Volume, expected, 0.008 * expected);
  EXPECT_TRUE(this->Removal.Bricks.IsEmpty()) << "it was only tried";
}

/// Half of the sphere is in tissue of 5 J/mm^3, the other half in tissue of 20 J/mm^3. Samples
/// below the level cost nothing.
TEST_F(CarvedSphere, CostsTheEnergyOfItsTissues)
{
  TestVolume layers(ScalarType::Float32, { 40, 40, 40 });
  const auto fill = [&](double low)
  {
    layers.Fill<float>([low](std::int64_t, std::int64_t, std::int64_t k)
      { return static_cast<float>(k < 20 ? low : 2000.0); });
  };
  this->Energies =
    SpecificEnergyTable({ Polyline{ { 1000.0, 5.0 }, { 2000.0, 20.0 } }, ConstantPolyline(0.0) });
  const Vector3 centre{ 0.0193, 0.0197, 0.0195 };
  const double volume = 4.0 * Pi / 3.0 * 512.0;
  fill(1000.0);
  const CarvingCost both = this->Try(HapticModel(Describe(layers)), centre, 0.008);
  EXPECT_NEAR(both.Volume, volume, 0.008 * volume);
  EXPECT_NEAR(both.Energy, 12.5 * volume, 0.008 * 12.5 * volume);
  fill(499.0);
  const CarvingCost one = this->Try(HapticModel(Describe(layers)), centre, 0.008);
  EXPECT_NEAR(one.Volume, 0.5 * volume, 0.008 * volume);
  EXPECT_NEAR(one.Energy, 10.0 * volume, 0.008 * 10.0 * volume);
}

/// The carver must also remove the edge of a structure, but must not allocate bricks far from solid
/// samples.
TEST_F(CarvedSphere, LeavesAirAlone)
{
  TestVolume plate(ScalarType::Int16, { 48, 48, 48 });
  plate.Fill<std::int16_t>([](std::int64_t, std::int64_t, std::int64_t k)
    { return static_cast<std::int16_t>(k == 23 ? 400 : (k > 23 && k < 28 ? 1000 : 0)); });
  this->Carve(HapticModel(Describe(plate)), { 0.0235, 0.0235, 0.0255 }, 0.010);
  EXPECT_EQ(this->Removal.Bricks.GetFraction(23, 23, 26), 0);
  EXPECT_EQ(this->Removal.Bricks.GetFraction(23, 23, 23), 0) << "a film of 400 would be left";
  for (std::uint32_t brick = 0; brick < this->Removal.Bricks.GetCount(); ++brick)
  {
    const BrickPlace place = CarvedBricks::PlaceOf(this->Removal.Bricks.GetKey(brick));
    EXPECT_TRUE(place.Z == 2 || place.Z == 3) << "16 to 31";
  }
}

TEST_F(CarvedSphere, WithoutRoomForItsBricksIsNotCarved)
{
  const TestVolume tissue = MakeTissue(40);
  const HapticModel model(Describe(tissue));
  TissueRemoval small(20);
  this->Carver.SetTissue(model, { 500.0, false, &this->Energies });
  EXPECT_FALSE(this->Carver.Try(small, { 0.0159, 0.0159, 0.0159 }, 0.002).IsUsedUp);
  this->Carver.Carve(small);
  EXPECT_EQ(small.Bricks.GetCount(), 8u);
  const std::vector<std::uint8_t> before = CopyTissue(small.Bricks, tissue.View.Dimensions);
  EXPECT_TRUE(this->Carver.Try(small, { 0.0195, 0.0195, 0.0195 }, 0.008).IsUsedUp);
  this->Carver.SetTissue(model, { 500.0, false, &this->Energies });
  this->Carver.Carve(small);
  EXPECT_EQ(CopyTissue(small.Bricks, tissue.View.Dimensions), before);
}

/// Carving in parts of any size must give the same result at the same cost, and no part may do more
/// work than its limit.
TEST_F(CarvedSphere, IsTheSameInParts)
{
  const TestVolume tissue = MakeTissue(96);
  const HapticModel model(Describe(tissue));
  const Vector3 centre{ 0.0471, 0.0484, 0.0467 };
  const Vector3 from{ 0.0469, 0.0484, 0.0468 };
  constexpr double radius = 44.0; // mm
  const std::int64_t* const n = tissue.View.Dimensions;
  std::vector<std::uint8_t> expected(96 * 96 * 96, 255);
  CarveSlowly(expected, n, 1000.0 * from, radius);
  CarveSlowly(expected, n, 1000.0 * centre, radius);
  std::vector<double> volumes;
  for (const std::size_t most : { std::size_t{ 1 }, std::size_t{ 5000 }, ~std::size_t{ 0 } })
  {
    TissueRemoval removal(4096);
    this->Carver.SetTissue(model, { 500.0, false, &this->Energies });
    double volume = 0.0;
    int parts = 0;
    for (const Vector3* const last : { static_cast<const Vector3*>(nullptr), &from })
    {
      CarvingPart part{ 0, most };
      do
      {
        const CarvingCost cost =
          this->Carver.Try(removal, last ? centre : from, 0.001 * radius, last, part);
        EXPECT_TRUE(most == ~std::size_t{ 0 } || cost.Work < most + SphereCarver::MostWorkOfBrick);
        EXPECT_NEAR(cost.Energy, 10.0 * cost.Volume, 1e-9 * cost.Energy);
        EXPECT_TRUE(cost.Next == 0 || cost.Next > part.First);
        this->Carver.Carve(removal);
        volume += cost.Volume;
        part.First = cost.Next;
        ASSERT_LT(++parts, 10000);
      } while (part.First != 0);
    }
    EXPECT_GT(parts, 2) << "more rows change than there is room for";
    volumes.push_back(volume);
    const std::vector<std::uint8_t> fractions = CopyTissue(removal.Bricks, n);
    int different = 0;
    for (std::size_t i = 0; i < fractions.size(); ++i)
    {
      ASSERT_LE(std::abs(fractions[i] - expected[i]), 1) << i;
      different += fractions[i] != expected[i] ? 1 : 0; // differs by a rounded distance
    }
    EXPECT_LE(different, 20);
  }
  EXPECT_NEAR(volumes[0], volumes[2], 1e-9 * volumes[2]);
  EXPECT_NEAR(volumes[1], volumes[2], 1e-9 * volumes[2]);
}

/// A replay does not know what the hand has drilled before, but its parts must end at the same
/// places.
TEST_F(CarvedSphere, EndsItsPartsWhateverIsRemembered)
{
  TestVolume tissue(ScalarType::Int16, { 64, 64, 64 });
  tissue.Fill<std::int16_t>(
    [](std::int64_t i, std::int64_t, std::int64_t k) { return i + k < 70 ? 0 : 1000; });
  const HapticModel model(Describe(tissue));
  const Vector3 centre{ 0.031, 0.032, 0.033 };
  const auto findParts = [&]()
  {
    std::vector<std::size_t> parts;
    this->Carver.SetTissue(model, { 500.0, false, &this->Energies });
    CarvingPart part{ 0, 3000 };
    do
    {
      const CarvingCost cost = this->Carver.Try(this->Removal, centre, 0.025, nullptr, part);
      parts.push_back(cost.Work);
      parts.push_back(cost.Next);
      part.First = cost.Next;
    } while (part.First != 0 && parts.size() < 1000);
    return parts;
  };
  const std::vector<std::size_t> fresh = findParts();
  EXPECT_GT(fresh.size(), 6U);
  EXPECT_EQ(findParts(), fresh);
}

TEST_F(CarvedSphere, ThatIsNoSphereRemovesNothing)
{
  const TestVolume tissue = MakeTissue(24);
  const HapticModel model(Describe(tissue));
  constexpr double bad = std::numeric_limits<double>::quiet_NaN();
  for (const Vector3& centre : { Vector3{ bad, 0.01, 0.01 }, Vector3{ 0.01, 1e300, 0.01 },
         Vector3{ -0.02, 0.01, 0.01 }, Vector3{ 0.01, 0.05, 0.01 } })
  {
    EXPECT_EQ(this->Carve(model, centre, 0.003).Volume, 0.0);
  }
  EXPECT_TRUE(this->Removal.Bricks.IsEmpty());
  // A sphere may extend beyond the volume's border.
  EXPECT_GT(this->Carve(model, { 0.0, 0.0, 0.023 }, 0.003).Volume, 0.0);
}
