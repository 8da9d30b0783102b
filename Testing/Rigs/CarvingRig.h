// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Removes tissue from small volumes, and provides a reference implementation with loops over all
 * samples.
 */
#ifndef CarvingRig_h
#define CarvingRig_h

#include "Core/Carving/TissueRemoval.h"
#include "TestVolume.h"

#include <cmath>
#include <vector>

namespace coretest
{
/// Sets the fraction of one sample.
inline void SetFraction(
  CarvedBricks& bricks, std::int64_t i, std::int64_t j, std::int64_t k, std::uint8_t fraction)
{
  const std::uint32_t brick = bricks.FindOrAdd(CarvedBricks::KeyOf({ i / 8, j / 8, k / 8 }));
  const auto row = static_cast<int>(j % 8 + 8 * (k % 8));
  const auto shift = static_cast<int>(8 * (i % 8));
  const std::uint64_t others = bricks.GetRow(brick, row) & ~(std::uint64_t{ 255 } << shift);
  bricks.SetRow(brick, row, others | std::uint64_t{ fraction } << shift);
  bricks.MarkChanged(brick);
}

/// Returns a volume with the values after removal, V - (1 - rho) (V - V_air), as doubles.
inline TestVolume MakeLeft(const TestVolume& volume, const CarvedBricks& bricks, double air)
{
  const std::int64_t* const n = volume.View.Dimensions;
  const std::int64_t* const first = volume.View.First;
  TestVolume left(ScalarType::Float64, { n[0], n[1], n[2] });
  left.Fill<double>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const double value = volume(i, j, k);
      const std::uint8_t fraction = bricks.GetFraction(first[0] + i, first[1] + j, first[2] + k);
      return value - 1.0 / 255.0 * (255 - fraction) * (value - air);
    });
  std::copy(first, first + 3, left.View.First);
  std::copy(volume.View.Whole, volume.View.Whole + 3, left.View.Whole);
  left.View.BorderValue = volume.View.BorderValue;
  return left;
}

/// Returns the fractions of all samples. x varies fastest.
inline std::vector<std::uint8_t> CopyTissue(const CarvedBricks& bricks, const std::int64_t* n)
{
  std::vector<std::uint8_t> fractions;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        fractions.push_back(bricks.GetFraction(i, j, k));
      }
    }
  }
  return fractions;
}

/// Returns the fraction r = (V_c - V_air)/(V - V_air) at which a sample of a solid value V reaches
/// the level V_c. r is limited to a range from half a 255th to one minus half a 255th.
inline double EdgeOf(double value, double level, double air)
{
  return std::clamp((level - air) / (value - air), 0.5 / 255.0, 1.0 - 0.5 / 255.0);
}

/// Returns the remaining fraction of a voxel's volume at the sample fraction rho. It decreases
/// linearly from 1 at r + 1/12 to 0 at r - 1/12; both ends are clamped to the range from 0 to 1.
inline double LeftOf(double rho, double edge)
{
  const double low = std::max(edge - 1.0 / 12.0, 0.0);
  const double high = std::min(edge + 1.0 / 12.0, 1.0);
  return std::clamp((rho - low) / (high - low), 0.0, 1.0);
}
inline double LeftOf(std::uint8_t fraction, double edge = 0.5)
{
  return LeftOf(fraction / 255.0, edge);
}

/// Sets rho = min(rho, clamp(1/2 + (|x - c| - a)/w)) at all samples, for a sphere of radius a
/// around c (slow reference). The level is half of the samples' value; voxels have size 1, and w is
/// 3.
inline void CarveSlowly(
  std::vector<std::uint8_t>& fractions, const std::int64_t* n, const Vector3& centre, double radius)
{
  std::size_t at = 0;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i, ++at)
      {
        const Vector3 from = Vector3{ double(i), double(j), double(k) } - centre;
        const double rho = std::clamp(0.5 + (Norm(from) - radius) / 3.0, 0.0, 1.0);
        fractions[at] =
          std::min(fractions[at], static_cast<std::uint8_t>(std::lround(255.0 * rho)));
      }
    }
  }
}
} // namespace coretest

#endif
