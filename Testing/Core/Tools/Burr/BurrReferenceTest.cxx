// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares random drilling with a slow reference that was written from the design alone. At every
 * sample of a small volume, in double precision, a burr of radius a that has moved along a line
 * from p to q leaves
 *
 *   rho <- min(rho, clamp(r + (d - a)/w)),   w = 3 voxels,
 *
 * where d is the distance to the line, and r = (V_c - V_air)/(V - V_air) of the sample, so that the
 * level V_c is at d = a (method.md, "The burr"). The reference copies two decisions of the removal:
 * how far the centre follows the head, and how much larger the sphere is that gives it room. It
 * returns the cost of the removal. No step is abandoned on the random path of this test.
 */

#include "Rigs/BurrRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// Removes tissue from all samples, without bricks (slow reference). Lengths are in mm.
class SlowRemoval
{
public:
  SlowRemoval(const TestVolume& volume, double level, const Vector3& spacing, double radius)
    : Volume(volume)
    , Level(level)
    , N{ volume.View.Dimensions[0], volume.View.Dimensions[1], volume.View.Dimensions[2] }
    , Left(static_cast<std::size_t>(N[0] * N[1] * N[2]), 1.0)
    , Spacing(spacing)
    , Radius(radius)
    , Width(3.0 * std::max(spacing.X, std::max(spacing.Y, spacing.Z)))
  {
  }

  void Move(const Vector3& from, const Vector3& to, double room = 0.0)
  {
    const Vector3 way = to - from;
    const double square = Dot(way, way);
    const double reach = this->Radius + room + this->Width;
    std::size_t at = 0;
    for (std::int64_t k = 0; k < this->N[2]; ++k)
    {
      for (std::int64_t j = 0; j < this->N[1]; ++j)
      {
        for (std::int64_t i = 0; i < this->N[0]; ++i, ++at)
        {
          const Vector3 x = this->PlaceOf(i, j, k);
          const double fraction =
            square > 0.0 ? std::clamp(Dot(x - from, way) / square, 0.0, 1.0) : 0.0;
          const double distance = Norm(x - (from + fraction * way));
          if (distance < reach)
          {
            const double rho =
              this->EdgeOf(i, j, k) + (distance - this->Radius - room) / this->Width;
            this->Left[at] = std::min(this->Left[at], std::max(rho, 0.0));
          }
        }
      }
    }
  }
  Vector3 PlaceOf(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return { double(i) * this->Spacing.X, double(j) * this->Spacing.Y,
      double(k) * this->Spacing.Z };
  }

  /// Returns the fraction r at which a sample reaches the level (CarvingRig.h).
  double EdgeOf(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return coretest::EdgeOf(this->Volume(i, j, k), this->Level, 0.0);
  }

  const TestVolume& Volume;
  const double Level;
  const std::int64_t N[3];
  std::vector<double> Left; ///< rho
  const Vector3 Spacing;
  const double Radius;
  const double Width;
};

/// Returns a lumpy body of tissue with values from 400 to 1700.
TestVolume MakeBody(std::mt19937_64& engine)
{
  TestVolume volume(ScalarType::Int16, { 40, 40, 40 });
  volume.Fill<std::int16_t>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const double bumps = 2.0 * std::sin(0.3 * i) * std::cos(0.35 * j);
      const double tissue = 1000.0 + 600.0 * std::sin(0.3 * i + 0.2 * k);
      return static_cast<std::int16_t>(k > 16.0 + bumps ? tissue + (engine() % 100) : 0.0);
    });
  return volume;
}
} // namespace

class DrilledAtRandom : public testing::TestWithParam<Vector3>
{
};

/// The tolerance has two parts. The burr moves in steps s of at most a quarter of a voxel, so its
/// nearest centre may be farther from x than the line by s^2/(8 d), with d >= a - w/2. Fractions
/// have 8 bits, which adds half a fraction. The cost of a voxel that is not completely removed may
/// be wrong by six times as much.
TEST_P(DrilledAtRandom, LeavesWhatTheReferenceLeaves)
{
  const Vector3 spacing = GetParam();
  const double voxel = std::cbrt(spacing.X * spacing.Y * spacing.Z);
  std::mt19937_64 engine(28);
  const TestVolume volume = MakeBody(engine);
  const std::int64_t* const n = volume.View.Dimensions;
  HapticModelDescription scene = Describe(volume);
  scene.IndexToWorld.Linear = { { { spacing.X, 0, 0 }, { 0, spacing.Y, 0 }, { 0, 0, spacing.Z } } };
  scene.Removal = std::make_shared<TissueRemoval>();
  BurrInHand settings = MakeBurr(5e9, 300.0);
  const Polyline energies{ { 400.0, 0.2 }, { 1700.0, 2.0 } };
  BurrInVolume hand(scene, settings, energies, 1000);
  SlowRemoval reference(volume, settings.Shell.Level, spacing, settings.Radius);
  const Vector3 middle = reference.PlaceOf(19, 19, 10);
  Vector3 at{ middle.X, middle.Y, 0.0 };
  hand.Tick(at);
  int begun = 0;
  int unfinished = 0;
  for (int leg = 0; leg < 24; ++leg)
  {
    const Vector3 goal = middle + RandomIn(engine, 6.0 * voxel) + Vector3{ 0.0, 0.0, 2.0 };
    hand.IsSpinning = leg % 5 != 4;
    for (int i = 0; i < 150; ++i)
    {
      // Limit the speed to 0.02 mm per tick and the force to 3 N.
      const Vector3 tool = 1000.0 * hand.Record.Shell.Tool.Position;
      at = tool + ClampNorm(at + ClampNorm(goal - at, 0.02) - tool, 6.0);
      const BurrState before = hand.State;
      hand.Tick(at);
      const BurrState& after = hand.State;
      const Vector3& head = hand.Record.Shell.Tool.Position;
      const bool begins =
        !before.IsCarving || 1000.0 * Norm(before.Carved - head) > 2.0 * settings.Radius;
      if (!after.IsCarving || !after.IsRemoved)
      {
        continue;
      }
      Vector3 from = 1000.0 * before.Carved;
      if (begins)
      {
        // The removal begins half a ramp away from the contact.
        const ShellContacts& contacts = hand.Points.GetCurrent();
        double depth = 0.0;
        for (std::size_t c = 0; c < contacts.Count; ++c)
        {
          depth = std::max(depth, 1000.0 * contacts.List[c].Depth);
        }
        const Vector3& force = hand.Record.Shell.Force;
        from = 1000.0 * head + ((depth + 0.5 * reference.Width) / Norm(force)) * force;
        ++begun;
      }
      else if (before.Part > 0)
      {
        // First complete the step for which the last tick had no time.
        if (Norm(after.Carved - before.Carved) > 0.0)
        {
          reference.Move(from, 1000.0 * before.Next);
          from = 1000.0 * before.Next;
        }
        else
        {
          ++unfinished;
        }
      }
      if (begins || Norm(after.Carved - before.Carved) > 0.0)
      {
        reference.Move(from, 1000.0 * after.Carved);
      }
      if (after.Room > 0.0 && after.Part == 0)
      {
        reference.Move(1000.0 * after.Carved, 1000.0 * after.Carved, 1000.0 * after.Room);
      }
    }
  }
  EXPECT_GT(begun, 3);
  const double step = 0.25 * voxel;
  const double nearest = settings.Radius - 0.5 * reference.Width;
  const double bound = 0.5 + 255.0 / reference.Width * step * step / (8.0 * nearest);
  const std::vector<std::uint8_t> fractions = CopyTissue(scene.Removal->Bricks, n);
  const SpecificEnergyTable table({ energies, ConstantPolyline(0.0) });
  const double whole = spacing.X * spacing.Y * spacing.Z;
  double worst = 0.0;
  double cost = 0.0;
  double uncertain = 0.0;
  int carved = 0;
  std::size_t s = 0;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i, ++s)
      {
        const double value = volume(i, j, k);
        if (value < 300.0)
        {
          continue; // bricks of air may differ
        }
        const double rho = reference.Left[s];
        worst = std::max(worst, std::abs(fractions[s] - 255.0 * rho));
        carved += rho < 1.0 ? 1 : 0;
        const double energy = whole * table(value)[0];
        const double edge = reference.EdgeOf(i, j, k);
        cost += energy * (1.0 - LeftOf(rho, edge));
        const bool isOnRamp = std::abs(rho - edge) < 1.0 / 12.0 + bound / 255.0;
        uncertain += isOnRamp ? energy * 6.0 * bound / 255.0 : 0.0;
      }
    }
  }
  EXPECT_GT(carved, 200);
  EXPECT_LE(worst, bound) << "shares of 255";
  EXPECT_NEAR(cost, hand.Energy, uncertain) << "J";
  EXPECT_LE(uncertain, 0.05 * cost);
  EXPECT_EQ(unfinished, 0) << "a step that was given up is not in the reference";
}

INSTANTIATE_TEST_SUITE_P(
  Voxels, DrilledAtRandom, testing::Values(Vector3{ 0.5, 0.5, 0.5 }, Vector3{ 0.4, 0.5, 0.6 }));
