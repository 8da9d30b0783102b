// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A measurement: its kind, its points, and the value computed from them.
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

/** Kinds of measurements, in the order of vtkHapticMeasurements::KindType. */
enum class MeasuredKind
{
  Point,
  Distance,
  Angle,
  Path,
  Area
};
inline constexpr int MeasuredKinds = 5;

/** Force, value and time felt at a point; NaN stands for unknown. */
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
  std::vector<Vector3> Points;               ///< points in world coordinates
  std::vector<MeasuredSample> Samples;       ///< one sample per point, or empty
  std::vector<std::array<int, 3>> Triangles; ///< point indices of an area's triangles

  /**
   * Computes the value in world units, square world units or degrees. For a point, returns the felt
   * value. Returns NaN if there is none.
   */
  double Measure() const;
};

/** Returns the name of a kind, such as "Point" or "Distance". */
const char* GetKindName(MeasuredKind kind);
/** Finds a kind by its name, ignoring case. Returns false for an unknown name. */
bool FindKind(std::string_view name, MeasuredKind& kind);

/**
 * Returns the fault in a measurement's points, with the cure; empty if there is none. Coordinates
 * must be finite, and triangles must refer to existing points.
 */
std::string DetectFault(const Measurement& measurement);

/** Returns the number of points that a kind of measurement has; 0 stands for one or more. */
int CountPoints(MeasuredKind kind);

} // namespace VolumeHaptics

#endif
