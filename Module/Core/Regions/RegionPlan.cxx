// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Regions/RegionPlan.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** The longest length (world units) in a plan. Longer lengths are shortened to it. */
constexpr double Longest = 1e12;
/**
 * The smallest useful width of a region along an axis (samples). A narrower volume is fetched as a
 * whole.
 */
constexpr double LeastWidth = 16.0;
constexpr int MostHalvings = 60;
constexpr double LeastRoom = 0.5;
constexpr double RisingFraction = 0.5;
constexpr double FallingFraction = 0.1;

double Length(double value) noexcept
{
  // The comparison is false for NaN, too.
  return value > 0.0 ? std::min(value, Longest) : 0.0;
}

struct Cube
{
  double Centre[3];  // the index of the cube's centre
  double PerUnit[3]; // index steps per world unit
};

/**
 * Computes the cube around a position (world), or around the volume's centre if the position is not
 * finite.
 */
Cube ComputeCube(const WholeGeometry& whole, const Matrix3& inverse, const Vector3& centre) noexcept
{
  const Vector3 at = inverse * (centre - whole.IndexToWorld.Offset);
  const double place[3] = { at.X, at.Y, at.Z };
  Cube cube;
  for (int a = 0; a < 3; ++a)
  {
    const double first = whole.Extent[2 * a];
    const double last = whole.Extent[2 * a + 1];
    const double steps = Norm(inverse.Row[a]);
    cube.Centre[a] =
      std::isfinite(place[a]) ? std::clamp(place[a], first, last) : 0.5 * (first + last);
    cube.PerUnit[a] = std::isfinite(steps) ? std::min(steps, Longest) : 1.0;
  }
  return cube;
}

double CountVoxels(const int extent[6]) noexcept
{
  const auto count = [&](int a) { return double{ extent[2 * a + 1] + 1.0 } - extent[2 * a]; };
  return count(0) * count(1) * count(2);
}

/**
 * Computes the part of a volume within a half-width (world units), as indices. The part is never
 * empty. Returns its number of voxels.
 */
double Cut(const WholeGeometry& whole, const Cube& cube, double halfWidth, int region[6]) noexcept
{
  for (int a = 0; a < 3; ++a)
  {
    const double first = whole.Extent[2 * a];
    const double last = whole.Extent[2 * a + 1];
    const double half = std::max(halfWidth * cube.PerUnit[a], 0.5 * LeastWidth - 1.0);
    const double low = std::clamp(std::floor(cube.Centre[a] - half), first, last);
    const double high = std::clamp(std::ceil(cube.Centre[a] + half), first, last);
    region[2 * a] = static_cast<int>(low);
    region[2 * a + 1] = static_cast<int>(high);
  }
  return CountVoxels(region);
}

bool IsEmpty(const int extent[6]) noexcept
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

/**
 * Returns the distance (world units) from the cube's centre to the nearest border inside the
 * volume.
 */
double FindRoom(const WholeGeometry& whole, const Cube& cube, const int region[6]) noexcept
{
  double room = Longest;
  for (int a = 0; a < 3; ++a)
  {
    const double perUnit = std::max(cube.PerUnit[a], 1.0 / Longest);
    if (region[2 * a] > whole.Extent[2 * a])
    {
      room = std::min(room, (cube.Centre[a] - region[2 * a]) / perUnit);
    }
    if (region[2 * a + 1] < whole.Extent[2 * a + 1])
    {
      room = std::min(room, (region[2 * a + 1] - cube.Centre[a]) / perUnit);
    }
  }
  return room;
}

} // namespace

double ComputeHalfWidth(const RegionNeeds& needs) noexcept
{
  return Length(needs.MaximumSpeed) * std::min(Length(needs.Latency), MostLatency) +
    Length(needs.SpringLength) + Length(needs.Reach) + Length(needs.Band);
}

bool PlanRegion(const WholeGeometry& whole, const RegionNeeds& needs, const Vector3& tip,
  const Vector3& velocity, const int resident[6], int wanted[6]) noexcept
{
  std::copy(whole.Extent, whole.Extent + 6, wanted);
  if (IsEmpty(whole.Extent))
  {
    return false;
  }
  const Matrix3 inverse = Inverse(whole.IndexToWorld.Linear);
  const double speed = Norm(velocity);
  const double needed = Length(needs.SpringLength) + Length(needs.Reach) + Length(needs.Band);
  const auto place = [&](double halfWidth)
  {
    const double time = std::min(Length(needs.Latency), MostLatency);
    const double way = std::min(speed, Length(needs.MaximumSpeed)) * time;
    const double ahead = std::min(way, std::max(halfWidth - needed, 0.0));
    // A speed that is not finite counts as zero.
    const Vector3 shift =
      std::isfinite(speed) && speed > 0.0 ? (ahead / speed) * velocity : Vector3{};
    return ComputeCube(whole, inverse, tip + shift);
  };
  const double limit = needs.MostVoxels > LeastVoxels ? needs.MostVoxels : LeastVoxels;
  double half = ComputeHalfWidth(needs);
  const bool isWhole = CountVoxels(whole.Extent) <= limit;
  if (!isWhole && Cut(whole, place(half), half, wanted) > limit)
  {
    double low = 0.0;
    double high = half;
    for (int i = 0; i < MostHalvings; ++i)
    {
      const double middle = 0.5 * (low + high);
      (Cut(whole, place(middle), middle, wanted) > limit ? high : low) = middle;
    }
    half = low;
    Cut(whole, place(half), half, wanted);
  }
  if (!resident || IsEmpty(resident))
  {
    return true;
  }
  const Cube cube = place(half);
  const bool isSame = std::equal(wanted, wanted + 6, resident);
  const double now = FindRoom(whole, cube, resident) - needed;
  const double then = FindRoom(whole, cube, wanted) - needed;
  // A cut region may have no room at all. Then the next region is fetched when the tip's distance
  // from the nearest border has fallen to half of the wanted centre's distance, so that the region
  // arrives before the tip leaves.
  const double enough = LeastRoom * (then > 0.0 ? then : then - needed);
  return !isSame && now < enough;
}

double ComputeSpareRoom(const WholeGeometry& whole, const RegionNeeds& needs, const Vector3& tip,
  const int region[6]) noexcept
{
  if (IsEmpty(whole.Extent) || IsEmpty(region))
  {
    return -Longest;
  }
  const Cube cube = ComputeCube(whole, Inverse(whole.IndexToWorld.Linear), tip);
  return FindRoom(whole, cube, region) - Length(needs.SpringLength) - Length(needs.Reach) -
    Length(needs.Band);
}

double SmoothLatency(double latency, double measured) noexcept
{
  if (!(measured >= 0.0) || !std::isfinite(measured))
  {
    return latency;
  }
  const double sample = std::min(measured, MostLatency);
  const double fraction = sample > latency ? RisingFraction : FallingFraction;
  return latency + fraction * (sample - latency);
}

} // namespace VolumeHaptics
