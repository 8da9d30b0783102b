// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Makes straight presses from all sides onto the outer surface of a volume, which tell what
 * the hand meets and what the eye sees there; and random walks through the volume, which tell how
 * much the force changes in a tick.
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

/** Force (N) above which the user is assumed to feel something. */
constexpr double FeltForce = 0.1;
/**
 * Force (N) above which the hand touches a surface, although it may slide off before the user feels
 * the surface.
 */
constexpr double TouchedForce = 0.01;

/** The volume that rays press. Positions are in world coordinates. */
struct PressedVolume
{
  std::shared_ptr<const VolumeHaptics::HapticModel> Model; ///< model under test
  std::shared_ptr<const VolumeHaptics::HapticModel> Shape; ///< values that contain the surface
  /** The values of Shape without structures above Level that are as small as noise. */
  std::shared_ptr<const VolumeHaptics::HapticModel> Structures;
  /** The values of Shape without structures above HeldLevel that are as small as noise. */
  std::shared_ptr<const VolumeHaptics::HapticModel> Held;
  double Level = 0.0;     ///< value of the surface; higher values are inside
  double HeldLevel = 0.0; ///< least value whose material resists with FeltForce
  double Scale = 1.0;     ///< mm in the hand's space per world unit
  std::array<double, 6> Box{};
  Vector3 Middle; ///< point near which the rays pass
  Vector3 Voxel;  ///< edge lengths of a voxel along the world's axes
  /// extinction of the rendering per world unit: a layer of d has opacity 1 - exp(-extinction d)
  Field Extinction;
};

/** Results of rays that meet the surface within 45 degrees of its normal. */
struct Presses
{
  int Count = 0;
  int Unfelt = 0;                 ///< force below 0.1 N down to 5 mm under the surface
  int UnfeltThoughSeen = 0;       ///< unfelt, but visible within 2 voxels behind the surface
  int UnfeltBehindEdge = 0;       ///< unfelt, although 0.25 mm behind the middle of an edge
  std::vector<double> OffSurface; ///< voxels from the isosurface to the felt place, inwards
  int Astray = 0; ///< felt more than 2 voxels from the isosurface of Level of any structure
  /// presses among Astray that are also more than 2 voxels from the isosurface of HeldLevel
  int AstrayOfHeld = 0;
  /// voxels along the ray from the felt place to half of the opacity
  std::vector<double> OffSeen;
  std::vector<double> OffSeenStraight; ///< OffSeen where the seen surface is also within 45 degrees
  std::vector<double> OffSeenTouched;  ///< voxels from the first 0.01 N to half of the opacity
  double LargestStep = 0.0;            ///< N: largest change of the force between two ticks
};

/**
 * Presses along rays. The hand moves along a ray at 100 mm/s, starting outside of the volume and at
 * least 40 mm away, so that it meets everything that is visible. It presses 5 mm deep and returns.
 * The felt place is the proxy of the first tick with 0.1 N. Rays that enter the volume inside the
 * body are left out, as are rays beside which the body continues beyond the volume; a press that is
 * felt there has no felt place.
 *
 * A ray's own surface is that of the values smoothed by the kernel. A thin structure in front of or
 * beside this surface can be felt and seen although the kernel smooths it below the level: it has
 * an isosurface of the samples, between which values are linear. Specks of noise have such
 * isosurfaces as well, but do not count as structures. HeldLevel depends on the materials under
 * test, so only Astray decides about them.
 *
 * A ray that grazes a strand sees it along a chord, even if only a little of the strand is beside
 * the ray. The press is only as deep as that little and slides off: 0.1 N at 500 N/m require 0.2
 * mm.
 */
Presses PressFromAllSides(const PressedVolume& volume, int rays);

/** Changes of the force in a tick (N). */
struct Steps
{
  double Largest = 0.0;
  /// part of a step that neither a release (0.25 N) nor the hand's step explains
  double Beyond = 0.0;
  /// largest step beyond stiffness times the hand's step
  double BeyondSpring = 0.0;
};

/**
 * Walks through the body in random directions at up to 0.45 m/s. At that speed, a spring of 400 N/m
 * changes by 0.18 N per tick. If the volume's stiffest material (N/m) is stiffer, the walks are
 * slower in proportion, because no law can limit a spring's change to less than stiffness times the
 * hand's step: a force that falls more slowly gives the hand energy.
 */
Steps WalkAtRandom(const PressedVolume& pressed, int walks, double stiffest);

/**
 * Returns the direction in which values increase at a place (mm in the hand's space), or nothing if
 * they are constant there.
 */
std::optional<Vector3> ComputeInwards(const PressedVolume& volume, const Vector3& at);

/**
 * Returns the number of voxels along `way` from a felt place (mm in the hand's space) to half of
 * the opacity, for an eye that looks along `way` from 10 mm in front of the place. Returns nothing
 * if nothing is visible within 40 mm behind the place.
 */
std::optional<double> MeasureSeenBehind(
  const PressedVolume& volume, const Vector3& felt, const Vector3& way);

/**
 * Returns the magnitude that the given fraction of the values does not exceed; 0 without values.
 */
double FindLargest(std::vector<double> values, double fraction);
/** Returns the median; 0 without values. */
double ComputeMedian(std::vector<double> values);

} // namespace evaluation

#endif
