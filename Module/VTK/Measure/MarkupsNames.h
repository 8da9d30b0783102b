// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Names in files of markups, for writing and reading.
 */
#ifndef MarkupsNames_h
#define MarkupsNames_h

#include "VTK/Measure/Measurement.h"

namespace VolumeHaptics
{

/** Name of this library's own member; the schema allows members that it does not name. */
inline constexpr const char* OwnMember = "volumeHaptics";

/** Names of the quantities that were felt, in the order of a sample. */
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
