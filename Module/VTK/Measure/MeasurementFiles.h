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
 * An area has a line for each corner of its triangles, one triangle after another; corners with the
 * same `point` are one point. The columns measurement, name, kind, point and all columns after it
 * are read; only x, y and z must exist. Consecutive lines with the same `measurement` belong
 * together. Without that column, each line is a separate point.
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
 * Writes the file completely or not at all. Returns false and writes the reason and the cure to
 * `error` if that fails.
 */
bool WriteMeasurements(const std::string& file, const std::vector<Measurement>& measurements,
  const MarkupsFrame& frame, std::string& error);

/**
 * Reads a file. On failure, returns false and writes the reason and the cure to `error`. `notes`
 * lists the parts that were left out.
 */
bool ReadMeasurements(const std::string& file, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error);

} // namespace VolumeHaptics

#endif
