// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A measurement: points with a meaning, and the value that follows from them.
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

/** In the order of vtkHapticMeasurements::KindType. */
enum class MeasuredKind
{
  Point,
  Distance,
  Angle,
  Path,
  Area
};
inline constexpr int MeasuredKinds = 5;

/** What was felt at a point; NaN: not known. */
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
  std::vector<Vector3> Points;               ///< world
  std::vector<MeasuredSample> Samples;       ///< of every point, or none
  std::vector<std::array<int, 3>> Triangles; ///< of an area

  /**
   * World units, squared world units or degrees; of a point the value that was felt there. NaN if
   * there is none.
   */
  double Measure() const;
};

/** "Point", "Distance" and so on. */
const char* GetKindName(MeasuredKind kind);
/** False if there is no such kind; case does not matter. */
bool FindKind(std::string_view name, MeasuredKind& kind);

/**
 * How the points of a kind are wrong, and the cure; empty if they are not. Coordinates have to be
 * finite, and triangles to have points that exist.
 */
std::string FindFault(const Measurement& measurement);

/** The number of points of a kind; 0: any, but one at least. */
int CountPoints(MeasuredKind kind);

} // namespace VolumeHaptics

#endif
