// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plans which region of a remote volume to fetch, and when.
 *
 * With the latency t from the request for a region until it is felt, no hand slower than v_max
 * leaves a cube with the half-width
 *
 *   h = v_max t + T_N/k + r + b
 *
 * around its position while the next region is being fetched: T_N/k is the proxy's largest lag, r
 * the reach of the samples that are read around tip and proxy, b the band over which the residency
 * falls (Residency.h). The centre of the cube is the position of the tip when the region comes,
 * x + t v (|v| is at most v_max); the cube is clipped to the volume. If h is cut, the centre is no
 * farther ahead than h - T_N/k - r - b: a hand that stops still has its data.
 *
 * The room of a region is the distance of the centre from the region's nearest border that is not
 * the volume's own, less T_N/k + r + b. The wanted region is fetched when the resident one gives
 * less than half of its room. So a hand at rest fetches nothing, and at any steady speed the next
 * region comes while the tip still has half its room. If h is cut so far that the wanted region has
 * no room, it is fetched when the nearest border of the resident one is half as far as its own.
 */
#ifndef RegionPlan_h
#define RegionPlan_h

#include "Core/Math/Vector3.h"

#include <cstdint>

namespace VolumeHaptics
{

/** The extent of a volume (indices, both ends included) and its position in the world. */
struct WholeGeometry
{
  int Extent[6] = { 0, -1, 0, -1, 0, -1 };
  Affine3 IndexToWorld; ///< maps indices to the world; index (0, 0, 0) maps to the offset
};

/**
 * Speed, latency and lengths that decide how large a region must be. Lengths are in world units.
 */
struct RegionNeeds
{
  double MaximumSpeed = 500.0;   ///< v_max (per second)
  double Latency = 0.2;          ///< t, s
  double SpringLength = 0.0;     ///< T_N/k
  double Reach = 0.0;            ///< r
  double Band = 0.0;             ///< b
  double MostVoxels = 2097152.0; ///< limit of a region's voxels; at least LeastVoxels
};

/** Number of voxels that a region may always have, so that a kernel fits into it. */
constexpr double LeastVoxels = 4096.0;

/** Returns the half-width h (above). It is finite and not negative for any needs. */
double ComputeHalfWidth(const RegionNeeds& needs) noexcept;

/**
 * Computes the wanted region (indices) for a tip (world) with a velocity (world units per second).
 * Returns whether to fetch it now. `resident` is the region in memory; it may be empty.
 *
 * The wanted region is the whole volume if that has at most MostVoxels; otherwise h is cut to that
 * size. Whatever the input, it is not empty and lies in the volume. If the tip is not finite, it
 * counts as at rest in the middle of the volume. For an empty volume, the function returns false
 * and an empty region.
 */
bool PlanRegion(const WholeGeometry& whole, const RegionNeeds& needs, const Vector3& tip,
  const Vector3& velocity, const int resident[6], int wanted[6]) noexcept;

/**
 * Returns the room of a region for a tip (both above; world units). If the room is negative, a tick
 * at this tip may lack samples. Returns a large negative number for an empty region, and a large
 * positive number for the whole volume.
 */
double ComputeSpareRoom(const WholeGeometry& whole, const RegionNeeds& needs, const Vector3& tip,
  const int region[6]) noexcept;

/**
 * Returns the smoothed latency (s) after a new measurement. It rises fast and falls slowly. Ignores
 * measurements that are negative or not finite.
 */
double SmoothLatency(double latency, double measured) noexcept;

/** The largest latency (s) that a plan accounts for. */
constexpr double MostLatency = 10.0;

} // namespace VolumeHaptics

#endif
