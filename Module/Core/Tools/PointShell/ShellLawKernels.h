// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Applies the law of contacts to four points at a time, for ShellKernels.h. The rules of
 * FieldKernels.h hold here, too.
 */
#ifndef ShellLawKernels_h
#define ShellLawKernels_h

#include "Core/Math/LowestBit.h"
#include "Core/State/ShellState.h"
#include "Core/Tools/PointShell/FourCells.h"
#include "Core/Tools/PointShell/ShellReader.h"

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{
namespace
{

constexpr std::uint64_t AllLanes = 0b1111;
VOLUME_HAPTICS_INLINE std::uint32_t CountLanes(std::uint64_t bits)
{
  return static_cast<std::uint32_t>(
    (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1) + (bits >> 3 & 1));
}

/**
 * Loads four of the eight numbers of four contacts, beginning with number `first` (0 or 4). Each
 * result contains one of the numbers, with one contact per lane.
 */
VOLUME_HAPTICS_INLINE void LoadContacts(const ShellContact* const* from, std::size_t first,
  Double4& a, Double4& b, Double4& c, Double4& d)
{
  const auto load = [from, first](int lane)
  { return LoadDouble4(reinterpret_cast<const double*>(from[lane]) + first); };
  a = load(0);
  b = load(1);
  c = load(2);
  d = load(3);
  Transpose(a, b, c, d);
}

/** The segments of a table that contain four numbers. */
template <typename Segment>
struct FourSegments
{
  const Segment* Of[4];
  Double4 Way; ///< distances of the numbers from the segments' beginnings
  bool IsOne;  ///< whether all four numbers are in the same segment
};
/** Returns a channel of the table at the four numbers. */
template <typename Segment>
VOLUME_HAPTICS_INLINE Double4 Evaluate(const FourSegments<Segment>& segments, int channel)
{
  const Segment* const* const of = segments.Of;
  if (segments.IsOne)
  {
    return Spread(of[0]->Value[channel]) + of[0]->Slope[channel] * segments.Way;
  }
  return MakeDouble4(of[0]->Value[channel], of[1]->Value[channel], of[2]->Value[channel],
           of[3]->Value[channel]) +
    MakeDouble4(
      of[0]->Slope[channel], of[1]->Slope[channel], of[2]->Slope[channel], of[3]->Slope[channel]) *
    segments.Way;
}
/**
 * Finds the segments of four numbers. Tries the segment of the last numbers first, because usually
 * it contains these, too.
 */
template <typename Table>
VOLUME_HAPTICS_INLINE FourSegments<typename Table::Segment> FindSegments(
  const Table& table, const Double4& x, const typename Table::Segment*& last)
{
  FourSegments<typename Table::Segment> found;
  const Double4 begin = Spread(last->Begin);
  found.IsOne = (IsAbove(x, begin) & ~IsAbove(x, Spread(last[1].Begin)) & AllLanes) == AllLanes;
  if (found.IsOne)
  {
    found.Of[0] = last;
    found.Way = x - begin;
    return found;
  }
  for (int lane = 0; lane < 4; ++lane)
  {
    found.Of[lane] = FindSegmentOf(table, x[lane]);
  }
  last = found.Of[3];
  found.Way =
    x - MakeDouble4(found.Of[0]->Begin, found.Of[1]->Begin, found.Of[2]->Begin, found.Of[3]->Begin);
  return found;
}

/** Like HapticModel::BorderFade(), for four points. */
VOLUME_HAPTICS_INLINE Double4 FadeAtBorder(
  const ShellReading& reading, const FourVectors& index, const Vector3& perVoxel)
{
  const auto least = [](const Double4& p, double last, double per)
  { return Spread(per) * Smaller(Spread(last) - p, p); };
  const Double4 x = least(index.X, reading.Border[0], perVoxel.X);
  const Double4 y = least(index.Y, reading.Border[1], perVoxel.Y);
  const Double4 z = least(index.Z, reading.Border[2], perVoxel.Z);
  const Double4 fade = Smaller(z, Smaller(y, x));
  const Double4 one = Spread(1.0);
  const Double4 zero = Spread(0.0);
  return ChooseAbove(one, fade, ChooseAbove(fade, zero, fade, zero), one);
}

/** The law of four contacts: stiffness (N/m^3) and strength (N/m^2) per unit of area. */
struct FourLaws
{
  Double4 Stiffness;
  Double4 Strength;
  Double4 IsFelt; ///< 1 for a contact that is felt, else 0

  /**
   * Returns the energy (J/m^2) at depths u. `pull` is the stiffness times u. `yielding` has a bit
   * for each contact that yields.
   */
  Double4 EnergyAt(const Double4& u, const Double4& pull, std::uint64_t yielding) const
  {
    const Double4 stored = 0.5 * this->Stiffness * u * u;
    if (yielding == 0)
    {
      return stored;
    }
    const Double4 most = this->Strength / this->Stiffness;
    return ChooseAbove(pull, this->Strength, this->Strength * (u - 0.5 * most), stored);
  }
  /** Returns the depths at which contacts have the given energies (J/m^2). */
  Double4 DepthOf(const Double4& energy) const
  {
    const Double4 most = this->Strength / this->Stiffness;
    return ChooseAbove(energy, 0.5 * this->Strength * most, energy / this->Strength + 0.5 * most,
      Root(2.0 * energy / this->Stiffness));
  }
};
VOLUME_HAPTICS_INLINE FourLaws ComputeLaws(
  const ShellReading& reading, const ShellBatch& batch, std::size_t i, ShellLaw& law)
{
  Double4 stiffness;
  Double4 strength;
  Double4 visibility;
  if (law.Materials)
  {
    const auto segments =
      FindSegments(*law.Materials, LoadDouble4(batch.Inside + i), law.LastMaterial);
    stiffness = Evaluate(segments, 0);
    strength = Evaluate(segments, 2);
    visibility = Evaluate(segments, 4);
  }
  else
  {
    stiffness = LoadDouble4(batch.Material[0] + i);
    strength = LoadDouble4(batch.Material[1] + i);
    visibility = LoadDouble4(batch.Material[2] + i);
  }
  const auto distinct =
    FindSegments(*law.Distinctness, LoadDouble4(batch.Magnitude + i), law.LastDistinctness);
  const Double4 fade = FadeAtBorder(reading, LoadVectors(batch.Foot, i), law.FadePerVoxel);
  const Double4 perArea = Spread(law.PerContactArea);
  FourLaws laws;
  laws.Stiffness = stiffness * perArea;
  laws.Strength =
    strength * (Evaluate(distinct, 0) * fade) * (visibility * Evaluate(distinct, 1)) * perArea;
  const Double4 zero = Spread(0.0);
  const Double4 one = Spread(1.0);
  laws.IsFelt = ChooseAbove(
    stiffness, Spread(law.LeastStiffness), ChooseAbove(laws.Strength, zero, one, zero), zero);
  return laws;
}

/** Returns the depth u of four points (ShellContacts.h). */
VOLUME_HAPTICS_INLINE Double4 ComputeStretches(const ShellLaw& law, const FourLaws& laws,
  const Double4& area, const ShellBatch& batch, std::size_t i)
{
  const Double4 zero = Spread(0.0);
  if (law.IsStart)
  {
    return zero;
  }
  Double4 energy;
  Double4 kept;
  Double4 stiffness;
  Double4 strength;
  LoadContacts(batch.Before + i, 4, energy, kept, stiffness, strength);
  const Double4 was = LoadDouble4(batch.Was + i);
  const bool isWhole = law.Fraction == 1.0;
  const bool areSame =
    isWhole && (IsEqual(stiffness, laws.Stiffness) & IsEqual(strength, laws.Strength)) == AllLanes;
  if (!areSame)
  {
    // If the material has changed, a contact keeps its energy.
    const Double4 other = Smaller(was, laws.DepthOf(law.Fraction * energy / area));
    const Double4 same = ChooseEqual(strength, laws.Strength, kept, other);
    kept = isWhole ? ChooseEqual(stiffness, laws.Stiffness, same, other) : other;
  }
  const Double4 deeper = LoadDouble4(batch.Depth + i) - was;
  const Double4 beyond = LoadDouble4(batch.Beyond + i);
  const Double4 distance = Larger(beyond, -1.0 * beyond);
  const Double4 change =
    ChooseAbove(Spread(law.FarthestFollowed), distance, deeper, Smaller(zero, deeper));
  return ChooseAbove(laws.IsFelt, zero, Larger(zero, kept + change), zero);
}

/** Four points and the results of their law, before they are appended. */
struct FourHolds
{
  FourVectors Normal;
  Double4 Energy;
  Double4 Force;
  Double4 Stiffness;
  std::uint64_t Held;     ///< bit for each lane whose point is in contact
  std::uint64_t Pressed;  ///< bit for each lane whose point is pressed
  std::uint64_t Yielding; ///< bit for each lane whose point is at the limit of its material
};

/** Appends the forces of the pressed points. */
VOLUME_HAPTICS_INLINE void Push(const FourHolds& holds, const FourVectors& arm, ShellPushes& to)
{
  const FourVectors& n = holds.Normal;
  const Double4 numbers[8] = { n.X, n.Y, n.Z, arm.Y * n.Z - arm.Z * n.Y, arm.Z * n.X - arm.X * n.Z,
    arm.X * n.Y - arm.Y * n.X, holds.Force, holds.Stiffness };
  std::size_t& f = to.Count;
  double* const places[8] = { to.Wrench[0], to.Wrench[1], to.Wrench[2], to.Wrench[3], to.Wrench[4],
    to.Wrench[5], to.Force, to.Stiffness };
  if (holds.Pressed == AllLanes)
  {
    VOLUME_HAPTICS_UNROLL
    for (int k = 0; k < 8; ++k)
    {
      StoreDouble4(numbers[k], places[k] + f);
    }
    f += 4;
    return;
  }
  for (std::uint64_t pressed = holds.Pressed; pressed != 0; pressed &= pressed - 1)
  {
    const int lane = LowestBit(pressed);
    for (int k = 0; k < 8; ++k)
    {
      places[k][f] = numbers[k][lane];
    }
    ++f;
  }
}

/** Implements HoldFunction. */
std::uint64_t HoldPoints(const ShellReading& reading, ShellLaw& law, ShellBatch& batch,
  ShellContact*& to, ShellPushes& pushes, ShellSum& sum) noexcept
{
  for (std::size_t i = batch.Count; i % 4 != 0; ++i)
  {
    // Fill up with the last point, so that no other material is looked up.
    const std::size_t last = batch.Count - 1;
    batch.Before[i] = batch.Before[last];
    batch.Magnitude[i] = batch.Magnitude[last];
    batch.Inside[i] = batch.Inside[last];
    batch.Area[i] = batch.Area[last];
    batch.Depth[i] = batch.Beyond[i] = batch.Was[i] = 0.0;
    for (int n = 0; n < 3; ++n)
    {
      batch.Material[n][i] = batch.Material[n][last];
      batch.Foot[n][i] = batch.Normal[n][i] = batch.Arm[n][i] = 0.0;
    }
  }
  const Double4 zero = Spread(0.0);
  ShellContact* next = to;
  double energy = sum.Energy;
  std::uint32_t contacts = 0;
  std::uint32_t yielding = 0;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < batch.Count; i += 4)
  {
    FourLaws laws = ComputeLaws(reading, batch, i, law);
    const Double4 area = Spread(law.SquareMeters) * LoadDouble4(batch.Area + i);
    const Double4 stretch = ComputeStretches(law, laws, area, batch, i);
    const Double4 pull = laws.Stiffness * stretch;
    FourHolds holds;
    holds.Yielding = IsAbove(pull, laws.Strength);
    // A point outside a wall leaves it if the force back is zero or too large.
    const std::uint64_t left = ~(batch.Solid >> i) & (IsEqual(stretch, zero) | holds.Yielding);
    const std::size_t rest = batch.Count - i;
    holds.Held = ~left & (rest < 4 ? AllLanes >> (4 - rest) : AllLanes);
    holds.Pressed = holds.Held & IsAbove(stretch, zero);
    holds.Yielding &= holds.Pressed;
    holds.Normal = LoadVectors(batch.Normal, i);
    holds.Energy =
      ChooseAbove(stretch, zero, area * laws.EnergyAt(stretch, pull, holds.Yielding), zero);
    holds.Force = area * Smaller(laws.Strength, pull);
    holds.Stiffness = ChooseAbove(pull, laws.Strength, zero, area * laws.Stiffness);
    Push(holds, LoadVectors(batch.Arm, i), pushes);

    const Double4 depth = LoadDouble4(batch.Depth + i);
    const FourVectors offset = Scaled(depth, holds.Normal);
    Double4 first[4] = { offset.X, offset.Y, offset.Z, depth };
    Double4 second[4] = { holds.Energy, stretch, laws.Stiffness, laws.Strength };
    Transpose(first[0], first[1], first[2], first[3]);
    Transpose(second[0], second[1], second[2], second[3]);
    // Append the contacts one by one, in the order of the list.
    const auto append = [&](int lane)
    {
      auto* const numbers = reinterpret_cast<double*>(next);
      StoreDouble4(first[lane], numbers);
      StoreDouble4(second[lane], numbers + 4);
      next->Point = batch.Point[i + static_cast<std::size_t>(lane)];
      ++next;
      energy += second[lane][0];
    };
    if (holds.Held == AllLanes)
    {
      append(0);
      append(1);
      append(2);
      append(3);
    }
    else
    {
      for (std::uint64_t held = holds.Held; held != 0; held &= held - 1)
      {
        append(LowestBit(held));
      }
    }
    contacts += CountLanes(holds.Pressed);
    yielding += CountLanes(holds.Yielding);
    all |= holds.Held << i;
  }
  to = next;
  sum.Energy = energy;
  sum.Contacts += contacts;
  sum.Yielding += yielding;
  return all;
}

} // namespace
} // namespace VolumeHaptics

#endif
