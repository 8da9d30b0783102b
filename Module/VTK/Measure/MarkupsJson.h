// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads measurements as markups of 3D Slicer (.mrk.json), following its published
 * schema, version 1.0.3.
 *
 * | measurement | markup |
 * | --- | --- |
 * | consecutive points with the same known quantities | one Fiducial with a point for each |
 * | distance, angle, path | Line, Angle, Curve |
 * | area | ClosedCurve along its longest border, with the triangles in the member volumeHaptics |
 *
 * What was felt at the control points is in `measurements`, as controlPointValues. A quantity that
 * is not known at every control point is left out. Positions are in the coordinate system of the
 * world, in millimetres or micrometres.
 *
 * A ClosedCurve of another program is read as a path that ends where it begins. Planes, regions of
 * interest, and markups without points are skipped with a note.
 */
#ifndef MarkupsJson_h
#define MarkupsJson_h

#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Length unit and axes of the world coordinates of measurements. */
struct MarkupsFrame
{
  double MetersPerWorldUnit = 1e-3;
  bool IsRAS = false; ///< false: LPS
};

std::string WriteMarkups(const std::vector<Measurement>& measurements, const MarkupsFrame& frame);

/**
 * Reads markups. Returns false, with the reason and the cure in `error`, if the text is not a
 * markups file. Adds a line to `notes` for everything that is skipped.
 */
bool ReadMarkups(const std::string& text, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error);

/** Name of this library's own member; the schema allows additional members. */
inline constexpr const char* OwnMember = "volumeHaptics";

/** Names of the quantities felt at a point, in the order of the numbers of a MeasuredSample. */
inline constexpr const char* SampleNames[] = { "time", "force x", "force y", "force z",
  "surface value" };
inline constexpr const char* SampleUnits[] = { "s", "N", "N", "N", "" };
inline constexpr int SampleNumbers = 5;

inline double& NumberOf(MeasuredSample& sample, int i)
{
  double* const numbers[SampleNumbers] = { &sample.Time, &sample.Force.X, &sample.Force.Y,
    &sample.Force.Z, &sample.SurfaceValue };
  return *numbers[i];
}

inline const char* TypeOf(MeasuredKind kind)
{
  static const char* const types[MeasuredKinds] = { "Fiducial", "Line", "Angle", "Curve",
    "ClosedCurve" };
  return types[static_cast<int>(kind)];
}

} // namespace VolumeHaptics

#endif
