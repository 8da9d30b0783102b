// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A sphere and a triangle: how near, and when a moving one meets the other.
 *
 * The centre of a sphere that touches a triangle lies on the triangle's rounded hull, its sum with
 * the sphere. That is convex: a straight way enters it once, through an offset face, round an edge
 * or round a corner, and a way that begins on it and does not lead inward never does.
 */
#ifndef SweptSphere_h
#define SweptSphere_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

struct Triangle
{
  Vector3 Corner[3];
};

/** A point of a triangle. */
struct TrianglePoint
{
  Vector3 Position;
  double Weight[3]; ///< barycentric
};

/** No meeting. */
constexpr double Never = 2.0;

TrianglePoint NearestPoint(const Triangle& triangle, const Vector3& to) noexcept;

/**
 * The share of a way, 0 to 1, after which a sphere's centre is within `radius` of the triangle;
 * Never where it isn't. Never, too, where it begins there and the way does not lead nearer, and
 * where a meeting would come after `latest`, or before it by a rounding only.
 */
double MeetingTime(const Triangle& triangle, const Vector3& centre, const Vector3& way,
  double radius, double latest = Never) noexcept;

} // namespace VolumeHaptics

#endif
