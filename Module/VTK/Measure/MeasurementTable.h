// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads measurements as CSV: a line of titles, then a line for each point.
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
#ifndef MeasurementTable_h
#define MeasurementTable_h

#include "VTK/Measure/Measurement.h"

#include <string>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{

/** Writes a table. Numbers are restored exactly when it is read. */
std::string WriteMeasurementTable(
  const std::vector<Measurement>& measurements, double metersPerWorldUnit);

/** Reads a table. False, with the reason and the cure, if the text can't be read. */
bool ReadMeasurementTable(
  std::string_view text, std::vector<Measurement>& measurements, std::string& error);

} // namespace VolumeHaptics

#endif
