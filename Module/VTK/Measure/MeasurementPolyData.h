// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts measurements to polydata and back: see vtkHapticMeasurements::CopyToPolyData.
 */
#ifndef MeasurementPolyData_h
#define MeasurementPolyData_h

#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

/** Makes the shape of one measurement: a vertex, a line or triangles, with what was felt. */
void CopyShape(const Measurement& measurement, vtkPolyData* shape);

/**
 * Reads the points of a shape in their order, or the triangles of an area, with Time, Force and
 * SurfaceValue of the points if the shape has them.
 */
Measurement ReadShape(MeasuredKind kind, vtkPolyData* shape);

/** Writes all measurements, with names, values and units. */
void CopyToPolyData(
  const std::vector<Measurement>& measurements, double metersPerWorldUnit, vtkPolyData* all);

/** Reads polydata. False, with the reason and the cure, if CopyToPolyData can't have made it. */
bool ReadPolyData(vtkPolyData* all, std::vector<Measurement>& measurements, std::string& error);

} // namespace VolumeHaptics

#endif
