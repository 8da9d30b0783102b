// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a shell feels the same in a partly removed volume as in a volume of the remaining
 * samples.
 */

#include "Rigs/CarvingRig.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
constexpr double Air = -100.0;

/// A ball of tissue, from which three balls with radii of 5 voxels have been carved.
struct CarvedBall
{
  CarvedBall()
    : Volume(ScalarType::Int16, { 48, 48, 48 })
    , Removal(std::make_shared<TissueRemoval>(300))
  {
    this->Volume.Fill<std::int16_t>(
      [](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        const double r = Norm(Vector3{ i - 23.5, j - 23.5, k - 23.5 });
        return static_cast<std::int16_t>(std::clamp(500.0 + 300.0 * (16.0 - r), 0.0, 1000.0));
      });
    std::vector<std::uint8_t> fractions(48 * 48 * 48, 255);
    for (const Vector3& centre :
      { Vector3{ 34.0, 26.0, 23.0 }, Vector3{ 24.0, 38.5, 23.7 }, Vector3{ 31.2, 34.0, 24.1 } })
    {
      CarveSlowly(fractions, this->Volume.View.Dimensions, centre, 5.0);
    }
    for (std::int64_t at = 0; at < 48 * 48 * 48; ++at)
    {
      if (fractions[static_cast<std::size_t>(at)] < 255)
      {
        SetFraction(this->Removal->Bricks, at % 48, at / 48 % 48, at / 2304,
          fractions[static_cast<std::size_t>(at)]);
      }
    }
  }

  HapticModelDescription DescribeCarved() const
  {
    HapticModelDescription scene = Describe(this->Volume);
    scene.Removal = this->Removal;
    scene.AirValue = Air;
    return scene;
  }

  TestVolume Volume;
  std::shared_ptr<TissueRemoval> Removal;
};
} // namespace

TEST(CarvedShell, FeelsWhatIsLeft)
{
  const CarvedBall ball;
  const TestVolume left = MakeLeft(ball.Volume, ball.Removal->Bricks, Air);
  const HapticModelDescription carved = ball.DescribeCarved();
  const HapticModelDescription expected = Describe(left);
  ShellSettings settings;
  settings.Level = 500.0;
  ShellHand hand(carved, MakeSphere(3.0, 700), settings);
  ShellHand other(expected, MakeSphere(3.0, 700), settings);
  std::mt19937_64 engine(4);
  double most = 0.0;
  Vector3 at{ 44.0, 44.0, 24.0 };
  for (int leg = 0; leg < 40; ++leg)
  {
    const Vector3 goal = Vector3{ 32.0, 34.0, 24.0 } + RandomIn(engine, 9.0);
    for (int i = 0; i < 40; ++i)
    {
      at += (1.0 / 40.0) * (goal - at);
      const Vector3 force = hand.Tick(at).Force;
      const Vector3 wanted = other.Tick(at).Force;
      most = std::max(most, Norm(wanted));
      ASSERT_EQ(force.X, wanted.X);
      ASSERT_EQ(force.Y, wanted.Y);
      ASSERT_EQ(force.Z, wanted.Z);
      ASSERT_EQ(hand.Record.Contacts, other.Record.Contacts);
    }
  }
  EXPECT_GT(most, 0.5);
}

/// Where nothing was removed from the ball, the contacts must equal those without bricks.
TEST(CarvedShell, FeelsNoDifferenceWhereNothingWasRemoved)
{
  const CarvedBall ball;
  ShellSettings settings;
  settings.Level = 500.0;
  ShellHand hand(ball.DescribeCarved(), MakeSphere(3.0, 700), settings);
  ShellHand other(Describe(ball.Volume), MakeSphere(3.0, 700), settings);
  double most = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    const double angle = 3.3 + 0.003 * i;
    const double r = 19.5 - 0.01 * i;
    const Vector3 at{ 23.5 + r * std::cos(angle), 23.5 + r * std::sin(angle), 23.5 };
    const Vector3 force = hand.Tick(at).Force;
    const Vector3 wanted = other.Tick(at).Force;
    most = std::max(most, Norm(wanted));
    ASSERT_EQ(std::memcmp(&force, &wanted, sizeof(force)), 0);
  }
  EXPECT_GT(most, 0.5);
}

/// Compares readings at random positions with the remaining tissue, for each scalar type and
/// instruction set.
TEST(CarvedShell, ReadsWhatIsLeft)
{
  for (const ScalarType type : AllScalarTypes)
  {
    for (const InstructionSet set : { InstructionSet::Baseline, DetectInstructionSet() })
    {
      TestVolume volume(type, { 20, 21, 22 });
      volume.FillRandom(7);
      CarvedBricks bricks(64);
      std::mt19937_64 engine(12);
      for (int s = 0; s < 2000; ++s)
      {
        SetFraction(bricks, static_cast<std::int64_t>(engine() % 16),
          static_cast<std::int64_t>(engine() % 21), static_cast<std::int64_t>(engine() % 22),
          static_cast<std::uint8_t>(engine()));
      }
      const double air = -1e6;
      const TestVolume left = MakeLeft(volume, bricks, air);
      const double level = left(10, 10, 10);
      const ShellReader carved(volume.View, level, false, CarvedView{ &bricks, air }, set);
      const ShellReader expected(left.View, level, false, set);
      std::vector<double> places[3];
      for (int s = 0; s < 600; ++s)
      {
        const Vector3 at = Vector3{ 10.0, 10.0, 10.0 } + RandomIn(engine, 12.0);
        places[0].push_back(at.X);
        places[1].push_back(at.Y);
        places[2].push_back(at.Z);
      }
      std::vector<double> values[2] = { std::vector<double>(600), std::vector<double>(600) };
      const ShellNumbers all{ places[0].data(), places[1].data(), places[2].data(), 600 };
      carved.ReadValues(all, values[0].data());
      expected.ReadValues(all, values[1].data());
      EXPECT_EQ(std::memcmp(values[0].data(), values[1].data(), 600 * sizeof(double)), 0);
      const ShellFrame frame{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, 1.0,
        1.0, 2.0 };
      for (std::size_t first = 0; first < 600; first += 60)
      {
        ShellBatch batches[2] = {};
        for (ShellBatch& batch : batches)
        {
          batch.Count = 60;
          for (std::size_t i = 0; i < 60; ++i)
          {
            for (std::size_t a = 0; a < 3; ++a)
            {
              batch.Place[a][i] = batch.Index[a][i] = places[a][first + i];
            }
          }
        }
        carved.ComputeAllFeet(frame, batches[0]);
        expected.ComputeAllFeet(frame, batches[1]);
        for (std::size_t i = 0; i < 60; ++i)
        {
          EXPECT_EQ(batches[0].Value[i], batches[1].Value[i]);
          for (int a = 0; a < 3; ++a)
          {
            EXPECT_EQ(batches[0].Gradient[a][i], batches[1].Gradient[a][i]);
            EXPECT_EQ(batches[0].Cell[a][i], batches[1].Cell[a][i]);
          }
        }
      }
    }
  }
}
