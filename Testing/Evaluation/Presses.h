// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Straight presses from all sides onto the outer surface of a volume: what the hand meets, and what
 * the eye sees there.
 */
#ifndef Evaluation_Presses_h
#define Evaluation_Presses_h

#include "Figure.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace VolumeHaptics
{
class HapticModel;
}

namespace evaluation
{

/** N, from which on the hand feels something. */
constexpr double FeltForce = 0.1;
/** N, from which on the hand is on a surface, though it may slide off before it feels it. */
constexpr double TouchedForce = 0.01;

/** What is pressed, by positions in the world. */
struct PressedVolume
{
  std::shared_ptr<const VolumeHaptics::HapticModel> Model; ///< of what is felt
  std::shared_ptr<const VolumeHaptics::HapticModel> Shape; ///< the values that have the surface
  /** The same values, but nothing above the level that is no larger than noise. */
  std::shared_ptr<const VolumeHaptics::HapticModel> Structures;
  double Level = 0.0; ///< of the surface; more is inside
  double Scale = 1.0; ///< mm of the hand's space in a unit
  std::array<double, 6> Box{};
  Vector3 Middle;   ///< that the rays go by
  Vector3 Voxel;    ///< lengths of its edges along the world's axes
  Field Extinction; ///< of the picture, per unit: 1 - exp(-extinction d) is the opacity of a layer
};

/** What was found by rays that meet the surface within 45 degrees of its normal. */
struct Presses
{
  int Count = 0;
  int Unfelt = 0;                      ///< less than 0.1 N until 5 mm under the surface
  int UnfeltThoughSeen = 0;            ///< of these, seen at most 2 voxels behind the surface
  std::vector<double> OffSurface;      ///< voxels from the isosurface to the felt place, inwards
  int Astray = 0;                      ///< felt more than 2 voxels from all structures' isosurfaces
  std::vector<double> OffSeen;         ///< voxels along the ray from there to half of the opacity
  std::vector<double> OffSeenStraight; ///< of these, where what is seen is within 45 degrees, too
  std::vector<double> OffSeenTouched;  ///< voxels from the first place with 0.01 N, of all rays
  double LargestStep = 0.0;            ///< N, of the force from one tick to the next
};

/**
 * The hand comes along a ray at 100 mm/s, from outside of the volume and 40 mm away at least,
 * so that it meets all that the eye sees; it presses 5 mm deep, and goes back. It feels the
 * surface at the proxy of the first tick with 0.1 N. Rays that enter the volume inside of the
 * body are left out, and so are those beside which the body goes on beyond the volume.
 *
 * A ray's own surface is that of the values that the kernel smooths. A thin structure in front of
 * it or beside it is felt, and seen, though the kernel smooths it below the level: it has an
 * isosurface of the samples, between which values are linear. Specks of noise have one, too, but
 * are no structures.
 *
 * A ray that grazes a strand sees it along a chord, however little of the strand is beside it. The
 * press is that deep alone, and slides off: 0.1 N at 500 N/m take 0.2 mm.
 */
Presses PressFromAllSides(const PressedVolume& volume, int rays);

/** Where values rise, seen from a place (mm of the hand's space); none if they are even there. */
std::optional<Vector3> ComputeInwards(const PressedVolume& volume, const Vector3& at);

/**
 * Voxels along a way from a felt place (mm of the hand's space) to half of the opacity, for an eye
 * that looks along the way from 10 mm before the place; none if it sees nothing within 40 mm.
 */
std::optional<double> MeasureSeenBehind(
  const PressedVolume& volume, const Vector3& felt, const Vector3& way);

/** The magnitude that a fraction of the values does not exceed; 0 without values. */
double FindLargest(std::vector<double> values, double fraction);
/** Half of the values are less; 0 without values. */
double ComputeMedian(std::vector<double> values);

} // namespace evaluation

#endif
