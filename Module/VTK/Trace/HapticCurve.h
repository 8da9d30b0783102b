// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Curves by their length, which is what a hand of constant speed goes by.
 */
#ifndef HapticCurve_h
#define HapticCurve_h

#include "Core/Math/Vector3.h"

#include <functional>
#include <vector>

namespace VolumeHaptics
{

/** The places of a curve, by the way from its beginning (0 to Length). */
struct HapticCurve
{
  double Length = 0.0;
  std::function<Vector3(double)> Place;
};

/** Straight from corner to corner; there are two at least. */
HapticCurve MakePolygonCurve(const std::vector<Vector3>& corners);

/**
 * Around a centre, in the plane across a normal (of any length but 0), counterclockwise seen from
 * its tip.
 */
HapticCurve MakeCircleCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns);

/** The spiral of Archimedes, from the centre out to the radius. */
HapticCurve MakeSpiralCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns);

} // namespace VolumeHaptics

#endif
