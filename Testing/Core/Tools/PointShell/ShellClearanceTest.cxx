// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that stored data about points only save time. A tool whose memory is cleared before each
 * tick must feel the same force, to the bit.
 */

#include "Rigs/CarvingRig.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace coretest;

namespace
{
struct ClearanceScene
{
  ScalarType Type;
  double Noise;  ///< noise, in a volume whose values rise by 100 per voxel
  bool IsShorn;  ///< whether the axes are oblique and have three different spacings
  bool IsCarved; ///< whether some tissue has been removed
  bool HasHoles; ///< whether some samples are NaN
};

/// Returns a rough, curved wall. Values above 1000 are solid.
TestVolume MakeWall(const ClearanceScene& scene)
{
  TestVolume volume(scene.Type, { 40, 40, 40 });
  std::mt19937_64 engine(31);
  std::uniform_real_distribution<double> noise(-scene.Noise, scene.Noise);
  const auto value = [&](std::int64_t i, std::int64_t j, std::int64_t k)
  {
    const double bend = 3.0 * std::sin(0.3 * static_cast<double>(i));
    return 1000.0 + 100.0 * (19.0 - static_cast<double>(k) + bend + 0.2 * static_cast<double>(j)) +
      noise(engine);
  };
  WithSampleType(scene.Type,
    [&](auto sample)
    {
      using T = decltype(sample);
      volume.template Fill<T>(
        [&](std::int64_t i, std::int64_t j, std::int64_t k)
        {
          const bool isHole = scene.HasHoles && i < 15 && (7 * i + 11 * j + 13 * k) % 97 == 0;
          return isHole ? static_cast<T>(std::nan("")) : static_cast<T>(value(i, j, k));
        });
    });
  return volume;
}

class ClearanceOfShells : public testing::TestWithParam<ClearanceScene>
{
};
} // namespace

TEST_P(ClearanceOfShells, ChangesNoBit)
{
  const ClearanceScene& scene = this->GetParam();
  const TestVolume volume = MakeWall(scene);
  HapticModelDescription description = Describe(volume);
  if (scene.IsShorn)
  {
    description.IndexToWorld.Linear =
      Matrix3{ { { 1.0, 0.3, 0.1 }, { 0.0, 0.7, -0.2 }, { 0.2, 0.0, 1.6 } } };
  }
  if (scene.IsCarved)
  {
    description.Removal = std::make_shared<TissueRemoval>(200);
    std::mt19937_64 fractions(8);
    for (int n = 0; n < 400; ++n)
    {
      const auto at = [&]() { return static_cast<std::int64_t>(8 + fractions() % 24); };
      const std::int64_t i = at();
      const std::int64_t j = at();
      SetFraction(
        description.Removal->Bricks, i, j, at(), static_cast<std::uint8_t>(fractions() % 255));
    }
  }
  ShellSettings settings;
  settings.Level = 1000.0;
  const std::vector<ShellPoint> points = MakeSphere(4.0, 1501);
  ShellHand hand(description, points, settings);
  ShellHand forgetful(description, points, settings);
  const Vector3 middle = description.IndexToWorld(Vector3{ 20.0, 20.0, 24.0 });
  std::mt19937_64 engine(32);
  Vector3 at = middle + Vector3{ 0.0, 0.0, 6.0 };
  Quaternion turn;
  double contacts = 0.0;
  std::size_t skipped = 0;
  std::size_t known = 0;
  constexpr int ticks = 1500;
  for (int tick = 0; tick < ticks; ++tick)
  {
    // The tool moves around the wall. In turn, it rests, moves slowly, and moves fast.
    const double speed = tick % 300 < 60 ? 0.0 : (tick % 300 < 200 ? 0.03 : 0.6);
    at += RandomIn(engine, speed) + 0.002 * (middle - at);
    turn = TurnAbout(RandomIn(engine, 1.0) + Vector3{ 0.0, 0.0, 1e-3 }, 0.03 * speed) * turn;
    turn = (1.0 / std::sqrt(SquaredNorm(turn))) * turn;
    const ShellClearance& clearance = hand.Memory.Clearance;
    for (std::size_t block = 0; block < clearance.Until.size(); ++block)
    {
      known += clearance.PerValue[block] > 0.0 ? 1 : 0;
      const double* const until = clearance.MarksUntil.data() + ShellBlock::Size * block;
      skipped += until[0] > clearance.Travelled + 0.05 ? 1 : 0;
    }
    forgetful.Memory.Clearance.Reset();
    const ShellRecord& one = hand.Tick(at, turn);
    const ShellRecord& other = forgetful.Tick(at, turn);
    ASSERT_EQ(one.Looks, other.Looks) << tick;
    ASSERT_EQ(one.Contacts, other.Contacts) << tick;
    ASSERT_EQ(one.Energy, other.Energy) << tick;
    ASSERT_EQ(std::memcmp(&one.Force, &other.Force, sizeof(one.Force)), 0) << tick;
    ASSERT_EQ(std::memcmp(&one.Torque, &other.Torque, sizeof(one.Torque)), 0) << tick;
    contacts += one.Contacts;
  }
  EXPECT_GT(contacts / ticks, 50.0);
  EXPECT_GT(known, 0U);
  EXPECT_GT(skipped, 0U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ClearanceOfShells,
  testing::Values(ClearanceScene{ ScalarType::Int16, 0.0, false, false, false },
    ClearanceScene{ ScalarType::Int16, 300.0, false, false, false },
    ClearanceScene{ ScalarType::UInt16, 30.0, true, false, false },
    ClearanceScene{ ScalarType::Float32, 30.0, true, false, false },
    ClearanceScene{ ScalarType::Float64, 300.0, false, true, false },
    ClearanceScene{ ScalarType::Int16, 30.0, false, true, false },
    ClearanceScene{ ScalarType::Float32, 30.0, false, false, true }));

/// The largest difference between neighbouring samples must equal that of a loop over all samples.
/// Infinite samples do not count.
TEST(SlopesOfShells, AreThoseOfAllNeighbours)
{
  TestVolume volume(ScalarType::Float64, { 12, 11, 10 });
  volume.FillRandom(21);
  const ShellReader reader(volume.View, 0.0, false);
  double most[3] = { 0.0, 0.0, 0.0 };
  for (std::int64_t k = 2; k <= 6; ++k)
  {
    for (std::int64_t j = 3; j <= 6; ++j)
    {
      for (std::int64_t i = 1; i <= 8; ++i)
      {
        const double here = volume(i, j, k);
        most[0] = i < 8 ? std::max(most[0], std::abs(volume(i + 1, j, k) - here)) : most[0];
        most[1] = j < 6 ? std::max(most[1], std::abs(volume(i, j + 1, k) - here)) : most[1];
        most[2] = k < 6 ? std::max(most[2], std::abs(volume(i, j, k + 1) - here)) : most[2];
      }
    }
  }
  double slopes[3];
  const Vector3 centre{ 4.6, 4.5, 4.0 };
  const Vector3 half{ 3.1, 1.2, 1.9 };
  ASSERT_TRUE(reader.ComputeSlopes(centre, half, slopes));
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(slopes[axis], most[axis]) << axis;
  }
  EXPECT_FALSE(reader.ComputeSlopes(centre, { 5.0, 1.0, 1.0 }, slopes)) << "beyond the samples";
  volume.Fill<double>([](std::int64_t i, std::int64_t j, std::int64_t k)
    { return i == 8 && j == 6 && k == 6 ? HUGE_VAL : 1.0 * (i + j + k); });
  EXPECT_FALSE(reader.ComputeSlopes(centre, half, slopes));
}
