// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Curves parametrised by their arc length, for a hand of constant speed.
 */
#ifndef HapticCurve_h
#define HapticCurve_h

#include "Core/Math/Vector3.h"

#include <functional>
#include <vector>

namespace VolumeHaptics
{

/** Gives the positions on a curve, by the distance along it (0 to Length). */
struct HapticCurve
{
  double Length = 0.0;
  std::function<Vector3(double)> Place;
};

/** Makes straight lines from corner to corner; there must be at least two corners. */
HapticCurve MakePolygonCurve(const std::vector<Vector3>& corners);

/**
 * Makes a circle around a centre, in the plane across a normal (of any length but 0),
 * counterclockwise seen from the normal's tip.
 */
HapticCurve MakeCircleCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns);

/** Makes the spiral of Archimedes, from the centre outward to the radius. */
HapticCurve MakeSpiralCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns);

} // namespace VolumeHaptics

#endif
