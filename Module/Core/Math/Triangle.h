// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Triangles: the distance of a point, and the contact of a moving sphere.
 *
 * The centre of a sphere that touches a triangle lies on the triangle's rounded hull, the sum of
 * triangle and sphere. The hull is convex: a straight path enters it once, through an offset face,
 * round an edge or round a corner; a path that begins on the hull and does not lead inward never
 * enters it.
 */
#ifndef Triangle_h
#define Triangle_h

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
  double Weight[3]; ///< barycentric weights
};

/** Returned by MeetingTime if the sphere does not meet the triangle. */
constexpr double Never = 2.0;

/** Returns the point of a triangle that is nearest to a position. */
TrianglePoint NearestPoint(const Triangle& triangle, const Vector3& to) noexcept;

/**
 * Returns the fraction (0 to 1) of a displacement after which a moving sphere touches the triangle.
 *
 * Returns Never if the sphere does not touch the triangle, if it touches the triangle from the
 * beginning and does not come nearer, and if it would touch the triangle only after `latest` (or
 * before it by rounding only).
 */
double MeetingTime(const Triangle& triangle, const Vector3& centre, const Vector3& displacement,
  double radius, double latest = Never) noexcept;

} // namespace VolumeHaptics

#endif
