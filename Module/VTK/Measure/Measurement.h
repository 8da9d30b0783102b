// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A measurement: points of a kind, and the value that follows from them.
 */
#ifndef Measurement_h
#define Measurement_h

#include "Core/Math/Vector3.h"

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{

/** Kinds in the order of vtkHapticMeasurements::KindType. */
enum class MeasuredKind
{
  Point,
  Distance,
  Angle,
  Path,
  Area
};
inline constexpr int MeasuredKinds = 5;

/** Force, value and time at a point when it was measured; NaN stands for unknown. */
struct MeasuredSample
{
  static constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

  double Time = Unknown;                      ///< s
  Vector3 Force{ Unknown, Unknown, Unknown }; ///< N
  double SurfaceValue = Unknown;              ///< V(x_s)
};

struct Measurement
{
  MeasuredKind Kind = MeasuredKind::Point;
  std::string Name;
  std::vector<Vector3> Points;               ///< points in the world
  std::vector<MeasuredSample> Samples;       ///< one sample for every point, or no samples
  std::vector<std::array<int, 3>> Triangles; ///< triangles of an area

  /**
   * Computes the value, in world units, square world units or degrees; for a point, returns the
   * value that was felt there. Returns NaN if there is none.
   */
  double Measure() const;
};

/** Returns "Point", "Distance" and so on. */
const char* GetKindName(MeasuredKind kind);
/**
 * Looks up a kind by its name; the case of letters does not matter. Returns false if there is no
 * such kind.
 */
bool FindKind(std::string_view name, MeasuredKind& kind);

/**
 * Returns the fault in the points of a measurement, and the cure; empty if there is none.
 * Coordinates have to be finite, and triangles must refer to existing points.
 */
std::string DetectFault(const Measurement& measurement);

/** Returns the number of points of a measurement of this kind; 0 means one or more. */
int CountPoints(MeasuredKind kind);

} // namespace VolumeHaptics

#endif
