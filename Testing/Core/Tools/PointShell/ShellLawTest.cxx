// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the law of contacts for many points at a time with the same law computed point by point,
 * as ShellContacts.h describes it. The bits must be the same on each processor.
 */

#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace coretest;

namespace
{
constexpr std::size_t Points = 61; // not a multiple of four
constexpr double Voxel = 1e-3;

/// A point with its last contact, its properties, and the expected results of the slow reference.
struct SlowPoint
{
  ShellContact Before{};
  bool IsSolid = false;
  double Area = 0.0; // m^2
  double Depth = 0.0;
  double Beyond = 0.0;
  double Stiffness = 0.0; // N/m
  double Strength = 0.0;  // strength (N) after all reductions
};

double Pressure(double kappa, double most, double u)
{
  return std::min(kappa * u, most);
}

/// Returns the energy (J/m^2) of a stretch u (m): the integral of the pressure, which rises by
/// kappa and is limited to `most`.
double EnergyOf(double kappa, double most, double u)
{
  const double yield = most / kappa;
  return u < yield ? kappa * u * u / 2.0 : most * yield / 2.0 + most * (u - yield);
}

/// Searches for the stretch (m) with a given energy.
double DepthOf(double kappa, double most, double energy)
{
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    (EnergyOf(kappa, most, middle) < energy ? low : high) = middle;
  }
  return high;
}

/// Returns the expected stretch u (m) of a point, or -1 if the point is not held.
double StretchOf(const SlowPoint& p, const ShellLaw& law)
{
  const double kappa = p.Stiffness * law.PerContactArea;
  const double most = p.Strength * law.PerContactArea;
  double u = 0.0;
  if (p.Stiffness > law.LeastStiffness && p.Strength > 0.0 && !law.IsStart)
  {
    const bool isSame =
      p.Before.Stiffness == kappa && p.Before.Strength == most && law.Fraction == 1.0;
    const double kept = isSame
      ? p.Before.Stretch
      : std::min(p.Before.Depth, DepthOf(kappa, most, law.Fraction * p.Before.Energy / p.Area));
    const double deeper = p.Depth - p.Before.Depth;
    const bool isFollowed = std::abs(p.Beyond) < law.FarthestFollowed;
    u = std::max(0.0, kept + (isFollowed ? deeper : std::min(deeper, 0.0)));
  }
  return p.IsSolid || (u > 0.0 && kappa * u <= most) ? u : -1.0;
}

/// Returns materials whose strength and stiffness change with the value, also in a step. Below 100,
/// both are zero.
MaterialTable MakeMaterials()
{
  return MaterialTable({ Polyline{ { 100.0, 0.0 }, { 200.0, 300.0 }, { 400.0, 800.0 } },
    ConstantPolyline(0.3), Polyline{ { 300.0, 0.5 }, { 300.0, 2.0 }, { 500.0, 1.0 } },
    ConstantPolyline(0.0), Polyline{ { 0.0, 0.5 }, { 500.0, 1.0 } } });
}

DistinctnessTable MakeDistinctness()
{
  return DistinctnessTable({ Polyline{ { 10.0, 0.0 }, { 30.0, 1.0 } }, ConstantPolyline(1.0) });
}

/// Results of the law for all points.
struct Found
{
  std::vector<ShellContact> Contacts{ Points };
  ShellPushes Pushes{};
  ShellSum Sum;
  std::uint64_t Held = 0;
};

class LawOfShells : public testing::TestWithParam<int>
{
protected:
  LawOfShells()
  {
    std::mt19937_64 engine(static_cast<std::uint64_t>(this->GetParam()));
    const auto between = [&engine](double low, double high)
    { return std::uniform_real_distribution<double>(low, high)(engine); };
    this->Law.Materials = this->GetParam() % 4 == 1 ? nullptr : &this->Materials;
    this->Law.Distinctness = &this->Distinctness;
    this->Law.LastMaterial = this->Materials.FindSegment(0.0);
    this->Law.LastDistinctness = this->Distinctness.FindSegment(0.0);
    this->Law.LeastStiffness = HapticModel::MinimumStiffness;
    this->Law.PerContactArea = 4e4;
    this->Law.SquareMeters = 1e-6;
    this->Law.FadePerVoxel = { 0.5, 0.5, 0.5 };
    this->Law.Fraction = this->GetParam() % 4 == 2 ? 0.7 : 1.0;
    this->Law.FarthestFollowed = 0.75 * Voxel;
    this->Law.IsStart = this->GetParam() % 4 == 3;
    this->Batch.Count = Points;
    for (std::size_t i = 0; i < Points; ++i)
    {
      SlowPoint& p = this->Slow[i];
      const double value = i < 20 ? between(210.0, 290.0) : between(0.0, 600.0);
      const double magnitude = between(5.0, 60.0);
      const MaterialTable::Values material = this->Materials(value);
      const DistinctnessTable::Values distinct = this->Distinctness(magnitude);
      // The volume has 20 samples along each axis. The strength rises within two voxels from the
      // border.
      const double x = between(-0.5, 10.0);
      const double fade = std::clamp(0.5 * x, 0.0, 1.0);
      p.Stiffness = material[0];
      p.Strength = material[2] * (distinct[0] * fade) * (material[4] * distinct[1]);
      p.IsSolid = i % 3 != 0;
      p.Area = 1e-6 * between(0.1, 2.0);
      p.Depth = between(p.IsSolid ? 0.0 : Voxel, 2.0 * Voxel);
      p.Beyond = between(-Voxel, Voxel);
      if (i % 5 != 0)
      {
        ShellContact& before = p.Before;
        before.Depth = p.Depth + between(-0.2, 0.2) * Voxel;
        before.Stretch = between(0.0, 1.0) * before.Depth;
        const bool isSame = i % 2 == 0;
        before.Stiffness = isSame ? p.Stiffness * this->Law.PerContactArea : 1e7;
        before.Strength = isSame ? p.Strength * this->Law.PerContactArea : 1e4;
        before.Energy = p.Area * EnergyOf(before.Stiffness, before.Strength, before.Stretch);
        before.Energy = before.Energy > 0.0 ? before.Energy : 0.0; // where the stiffness is zero
      }
      const Vector3 normal = ToMatrix(RandomTurn(engine)) * Vector3{ 1.0, 0.0, 0.0 };
      const Vector3 arm = RandomIn(engine, 5e-3);
      const double normals[3] = { normal.X, normal.Y, normal.Z };
      const double arms[3] = { arm.X, arm.Y, arm.Z };
      const double foot[3] = { x, 10.0, 10.0 };
      for (int a = 0; a < 3; ++a)
      {
        this->Batch.Normal[a][i] = normals[a];
        this->Batch.Arm[a][i] = arms[a];
        this->Batch.Foot[a][i] = foot[a];
      }
      this->Batch.Solid |= std::uint64_t{ p.IsSolid } << i;
      this->Batch.Point[i] = static_cast<std::uint32_t>(3 * i);
      this->Batch.Before[i] = &p.Before;
      this->Batch.Was[i] = p.Before.Depth;
      this->Batch.Area[i] = 1e6 * p.Area;
      this->Batch.Depth[i] = p.Depth;
      this->Batch.Beyond[i] = p.Beyond;
      this->Batch.Magnitude[i] = magnitude;
      this->Batch.Inside[i] = value;
      this->Batch.Material[0][i] = material[0];
      this->Batch.Material[1][i] = material[2];
      this->Batch.Material[2][i] = material[4];
    }
  }

  Found Hold(InstructionSet set) const
  {
    Found found;
    ShellBatch batch = this->Batch;
    ShellLaw law = this->Law;
    ShellContact* next = found.Contacts.data();
    found.Held = ShellReader(this->Volume.View, 0.0, false, set)
                   .Hold(law, batch, next, found.Pushes, found.Sum);
    found.Contacts.resize(static_cast<std::size_t>(next - found.Contacts.data()));
    return found;
  }

  const TestVolume Volume{ ScalarType::Int16, { 21, 21, 21 } };
  const MaterialTable Materials = MakeMaterials();
  const DistinctnessTable Distinctness = MakeDistinctness();
  SlowPoint Slow[Points];
  ShellLaw Law{};
  ShellBatch Batch{};
};
} // namespace

TEST_P(LawOfShells, IsThatOfEachPoint)
{
  const Found found = this->Hold(DetectInstructionSet());
  std::size_t next = 0;
  std::size_t pressed = 0;
  std::uint32_t yielding = 0;
  double energy = 0.0;
  for (std::size_t i = 0; i < Points; ++i)
  {
    const SlowPoint& p = this->Slow[i];
    const double u = StretchOf(p, this->Law);
    ASSERT_EQ((found.Held >> i & 1) != 0, u >= 0.0) << i;
    if (u < 0.0)
    {
      continue;
    }
    const double kappa = p.Stiffness * this->Law.PerContactArea;
    const double most = p.Strength * this->Law.PerContactArea;
    const ShellContact& contact = found.Contacts.at(next++);
    EXPECT_EQ(contact.Point, 3 * i);
    EXPECT_EQ(contact.Depth, p.Depth);
    EXPECT_EQ(contact.Offset.X, p.Depth * this->Batch.Normal[0][i]);
    EXPECT_EQ(contact.Offset.Y, p.Depth * this->Batch.Normal[1][i]);
    EXPECT_EQ(contact.Offset.Z, p.Depth * this->Batch.Normal[2][i]);
    EXPECT_NEAR(contact.Stretch, u, 1e-12 * Voxel);
    EXPECT_NEAR(contact.Stiffness, kappa, 1e-12 * kappa);
    EXPECT_NEAR(contact.Strength, most, 1e-12 * most);
    const double stored = u > 0.0 ? p.Area * EnergyOf(kappa, most, u) : 0.0;
    EXPECT_NEAR(contact.Energy, stored, 1e-10 * stored);
    energy += stored;
    if (u > 0.0)
    {
      const double force = p.Area * Pressure(kappa, most, u);
      const bool yields = kappa * u > most;
      EXPECT_NEAR(found.Pushes.Force[pressed], force, 1e-10 * force);
      EXPECT_NEAR(found.Pushes.Stiffness[pressed], yields ? 0.0 : p.Area * kappa, 1e-12 * kappa);
      EXPECT_EQ(found.Pushes.Wrench[0][pressed], this->Batch.Normal[0][i]);
      const double turn = this->Batch.Arm[0][i] * this->Batch.Normal[1][i] -
        this->Batch.Arm[1][i] * this->Batch.Normal[0][i];
      EXPECT_NEAR(found.Pushes.Wrench[5][pressed], turn, 1e-17);
      yielding += yields ? 1 : 0;
      ++pressed;
    }
  }
  EXPECT_EQ(found.Contacts.size(), next);
  EXPECT_EQ(found.Pushes.Count, pressed);
  EXPECT_EQ(found.Sum.Contacts, pressed);
  EXPECT_EQ(found.Sum.Yielding, yielding);
  EXPECT_NEAR(found.Sum.Energy, energy, 1e-10 * energy);
  EXPECT_EQ(pressed > 10, !this->Law.IsStart);
}

TEST_P(LawOfShells, HasTheSameBitsOnEveryProcessor)
{
  const Found one = this->Hold(InstructionSet::Baseline);
  const Found other = this->Hold(DetectInstructionSet());
  EXPECT_EQ(one.Held, other.Held);
  ASSERT_EQ(one.Contacts.size(), other.Contacts.size());
  for (std::size_t i = 0; i < one.Contacts.size(); ++i)
  {
    EXPECT_EQ(std::memcmp(&one.Contacts[i], &other.Contacts[i], 8 * sizeof(double)), 0) << i;
    EXPECT_EQ(one.Contacts[i].Point, other.Contacts[i].Point);
  }
  EXPECT_EQ(std::memcmp(&one.Sum.Energy, &other.Sum.Energy, sizeof(double)), 0);
  ASSERT_EQ(one.Pushes.Count, other.Pushes.Count);
  const std::size_t bytes = one.Pushes.Count * sizeof(double);
  for (int row = 0; row < 6; ++row)
  {
    EXPECT_EQ(std::memcmp(one.Pushes.Wrench[row], other.Pushes.Wrench[row], bytes), 0) << row;
  }
  EXPECT_EQ(std::memcmp(one.Pushes.Force, other.Pushes.Force, bytes), 0);
  EXPECT_EQ(std::memcmp(one.Pushes.Stiffness, other.Pushes.Stiffness, bytes), 0);
}

INSTANTIATE_TEST_SUITE_P(Random, LawOfShells, testing::Range(0, 12));
