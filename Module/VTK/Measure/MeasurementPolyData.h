// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts measurements to vtkPolyData and back: see vtkHapticMeasurements::CopyToPolyData.
 */
#ifndef MeasurementPolyData_h
#define MeasurementPolyData_h

#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

/**
 * Makes the shape of one measurement: a vertex, a line or triangles, with point arrays of the felt
 * forces and values.
 */
void CopyShape(const Measurement& measurement, vtkPolyData* shape);

/**
 * Makes a measurement from a shape: from its triangles for an area, otherwise from its points in
 * their order. Includes the point arrays Time, Force and SurfaceValue if the shape has them.
 */
Measurement ReadShape(MeasuredKind kind, vtkPolyData* shape);

/** Writes all measurements to a vtkPolyData, with names, values and units. */
void CopyToPolyData(
  const std::vector<Measurement>& measurements, double metersPerWorldUnit, vtkPolyData* all);

/**
 * Reads measurements from a vtkPolyData. Returns false, with the reason and the cure in `error`, if
 * the data do not come from CopyToPolyData.
 */
bool ReadPolyData(vtkPolyData* all, std::vector<Measurement>& measurements, std::string& error);

} // namespace VolumeHaptics

#endif
