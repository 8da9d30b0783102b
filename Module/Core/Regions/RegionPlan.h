// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which region of a volume that is somewhere else is to be fetched, and when.
 *
 * With the latency t from asking for a region to its being felt, no hand faster than v_max leaves a
 * cube with the half-width
 *
 *   h = v_max t + T_N/k + r + b
 *
 * round where it is while the next one is on its way: T_N/k is how far the proxy lags behind the
 * tip, r how far around both is read, b the band over which the residency falls (Residency.h). The
 * cube stands where the tip will be when it comes, x + t v (|v| is at most v_max), and is clipped
 * to the volume. Where h is cut, it is no farther ahead than h - T_N/k - r - b: a hand that stops
 * still has its data.
 *
 * A region is asked for once it is worth it. The room of a region is how far that place is from its
 * nearest border that is not the volume's own, less T_N/k + r + b; when the resident region gives
 * it less than half the room of the wanted one, the wanted one is fetched. So a hand that rests
 * fetches nothing, and at any steady speed the next region comes while the tip still has half its
 * room.
 */
#ifndef RegionPlan_h
#define RegionPlan_h

#include "Core/Math/Vector3.h"

#include <cstdint>

namespace VolumeHaptics
{

/** A volume, by indices (both ends included), and where these are in the world. */
struct WholeGeometry
{
  int Extent[6] = { 0, -1, 0, -1, 0, -1 };
  Affine3 IndexToWorld; ///< from index (0, 0, 0)
};

/** Lengths in world units. */
struct RegionNeeds
{
  double MaximumSpeed = 500.0;   ///< v_max, per second
  double Latency = 0.2;          ///< t, s
  double SpringLength = 0.0;     ///< T_N/k
  double Reach = 0.0;            ///< r
  double Band = 0.0;             ///< b
  double MostVoxels = 2097152.0; ///< of a region; no fewer than LeastVoxels
};

/** So that kernels fit, whatever the limit. */
constexpr double LeastVoxels = 4096.0;

/** h above; finite, and 0 or more, for any needs. */
double FindHalfWidth(const RegionNeeds& needs) noexcept;

/**
 * The region that is wanted for a tip (world) with a velocity (world units per second), as indices;
 * whole where the volume has no more than MostVoxels, else with h cut so that it has not. Whether
 * it is to be fetched now, with another one resident (empty: none). For any input: with a volume
 * that is not empty, so is the region, and it lies in it; what is not finite counts as at rest in
 * the middle of the volume. False, with an empty region, for an empty volume.
 */
bool PlanRegion(const WholeGeometry& whole, const RegionNeeds& needs, const Vector3& tip,
  const Vector3& velocity, const int resident[6], int wanted[6]) noexcept;

/**
 * The latency (s) after another one was measured: rises soon, falls slowly. Nonsense leaves it as
 * it is.
 */
double SmoothLatency(double latency, double measured) noexcept;

/** The largest latency that is planned for (s). */
constexpr double MostLatency = 10.0;

} // namespace VolumeHaptics

#endif
