// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads files of measurements. The extension selects the format: .csv, .vtp, or .json
 * for markups.
 *
 * A .csv has a line of titles, then one line per point:
 *
 *   measurement,name,kind,value,unit,point,x,y,z,time (s),force x (N),...,surface value
 *   1,Nasion,Point,53,,0,1.5,-82,31,...
 *   2,Distance 1,Distance,42.5,mm,0,...
 *   2,Distance 1,Distance,42.5,mm,1,...
 *
 * An area has one line per corner of its triangles, triangle after triangle; corners with the same
 * `point` are the same point. The columns value and unit are ignored when a file is read; only x, y
 * and z are required. Consecutive lines with the same `measurement` belong together. Without that
 * column, each line is a separate point.
 */
#ifndef MeasurementFiles_h
#define MeasurementFiles_h

#include "VTK/Measure/MarkupsJson.h"
#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Writes the whole file or none of it. On failure, returns false, with the reason and the cure in
 * `error`.
 */
bool WriteMeasurements(const std::string& file, const std::vector<Measurement>& measurements,
  const MarkupsFrame& frame, std::string& error);

/**
 * Reads a file. On failure, returns false, with the reason and the cure in `error`. `notes` lists
 * the parts that were skipped.
 */
bool ReadMeasurements(const std::string& file, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error);

} // namespace VolumeHaptics

#endif
