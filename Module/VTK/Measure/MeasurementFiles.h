// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads files of measurements. The ending selects the format: .csv, .vtp, or .json for
 * markups.
 *
 * A .csv has a line of titles, then a line for each point:
 *
 *   measurement,name,kind,value,unit,point,x,y,z,time (s),force x (N),...,surface value
 *   1,Nasion,Point,53,,0,1.5,-82,31,...
 *   2,Distance 1,Distance,42.5,mm,0,...
 *   2,Distance 1,Distance,42.5,mm,1,...
 *
 * An area has a line for each corner of its triangles, one triangle after the other, and `point`
 * shows which corners are the same point. The columns measurement, name, kind, point and the
 * following ones are read; only x, y and z are needed. Lines belong together as long as
 * `measurement` stays the same; without it, each line is a point of its own.
 */
#ifndef MeasurementFiles_h
#define MeasurementFiles_h

#include "VTK/Measure/MarkupsJson.h"
#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Writes the file completely or not at all; false, with the reason and the cure, on failure. */
bool WriteMeasurements(const std::string& file, const std::vector<Measurement>& measurements,
  const MarkupsFrame& frame, std::string& error);

/**
 * Reads a file. False, with the reason and the cure, if it can't be read. The notes say what was
 * left out.
 */
bool ReadMeasurements(const std::string& file, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error);

} // namespace VolumeHaptics

#endif
