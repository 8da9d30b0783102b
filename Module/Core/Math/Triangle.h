// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the point of a triangle that is nearest to a position, and the contact of a moving
 * sphere with a triangle.
 *
 * While a sphere touches a triangle, its centre is on the triangle's rounded hull, the sum of
 * triangle and sphere. The hull is convex, so a straight path enters it only once: through an
 * offset face, or near an edge or a corner. A path that begins on the hull and does not lead inward
 * never enters it.
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

struct TrianglePoint
{
  Vector3 Position;
  double Weight[3]; ///< barycentric weights
};

/** Value of MeetingTime() if the sphere does not meet the triangle. */
constexpr double Never = 2.0;

/** Returns the point of a triangle that is nearest to a position. */
TrianglePoint NearestPoint(const Triangle& triangle, const Vector3& to) noexcept;

/**
 * Returns the fraction (0 to 1) of a displacement after which a moving sphere touches the triangle.
 *
 * Returns Never if the sphere does not touch the triangle, if it touches the triangle from the
 * beginning and does not come nearer, and if it touches the triangle not clearly before `latest`.
 */
double MeetingTime(const Triangle& triangle, const Vector3& centre, const Vector3& displacement,
  double radius, double latest = Never) noexcept;

} // namespace VolumeHaptics

#endif
