// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plans which region of a remote volume to fetch, and when.
 *
 * Let t be the latency from the request for a region until it is felt. A hand that is slower than
 * v_max then stays within a cube with the half-width
 *
 *   h = v_max t + T_N/k + r + b
 *
 * around its position while the next region is being fetched. T_N/k is the proxy's largest lag, r
 * the reach of the samples that are read around tip and proxy, and b the band over which the
 * residency falls (Residency.h). The centre of the cube is the predicted position of the tip when
 * the region arrives, x + t v (|v| is at most v_max); the cube is clipped to the volume. If h has
 * to be cut, the centre is at most h - T_N/k - r - b ahead of the tip, so that a hand that stops
 * still has its data.
 *
 * The room of a region is the distance of the centre from the region's nearest border inside the
 * volume, minus T_N/k + r + b. The wanted region is fetched when the room in the resident one is
 * less than half of its own. A hand at rest therefore fetches nothing, and at any constant speed
 * the next region arrives while the tip still has half its room. If h is cut so far that the wanted
 * region has no room, the region is fetched when the distance from the nearest border of the
 * resident one has fallen to half of that of the wanted one.
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
 * Speed, latency and lengths that determine how large a region must be. Lengths are in world units.
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

/** Least limit of a region's voxels, so that a kernel fits into it. */
constexpr double LeastVoxels = 4096.0;

/** Returns the half-width h (see above). It is finite and not negative for any needs. */
double ComputeHalfWidth(const RegionNeeds& needs) noexcept;

/**
 * Computes the wanted region (indices) for a tip (world) with a velocity (world units per second).
 * Returns whether to fetch the region now. `resident` is the region in memory; it may be empty.
 *
 * The wanted region is the whole volume if it has at most MostVoxels; otherwise h is cut to this
 * limit. For any input, the region is inside the volume and not empty. A tip that is not finite
 * counts as at rest in the middle of the volume. For an empty volume, the function returns false
 * and an empty region.
 */
bool PlanRegion(const WholeGeometry& whole, const RegionNeeds& needs, const Vector3& tip,
  const Vector3& velocity, const int resident[6], int wanted[6]) noexcept;

/**
 * Returns the room (world units, see above) of a tip in a region. If it is negative, a tick at this
 * tip may lack samples. Returns a large negative number for an empty region, and a large positive
 * number for the whole volume.
 */
double ComputeSpareRoom(const WholeGeometry& whole, const RegionNeeds& needs, const Vector3& tip,
  const int region[6]) noexcept;

/**
 * Returns the smoothed latency (s) after a new measurement. It rises fast and falls slowly.
 * Negative measurements and those that are not finite are ignored.
 */
double SmoothLatency(double latency, double measured) noexcept;

/** The largest latency (s) in a plan. */
constexpr double MostLatency = 10.0;

} // namespace VolumeHaptics

#endif
