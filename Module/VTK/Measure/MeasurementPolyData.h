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

/**
 * Makes the shape of one measurement: a vertex, a line or triangles, with point arrays of the
 * forces and values that were felt.
 */
void CopyShape(const Measurement& measurement, vtkPolyData* shape);

/**
 * Reads a measurement from a shape: for an area its triangles, otherwise its points in their order.
 * Also reads the arrays Time, Force and SurfaceValue of the points if the shape has them.
 */
Measurement ReadShape(MeasuredKind kind, vtkPolyData* shape);

/** Writes all measurements to a polydata, with names, values and units. */
void CopyToPolyData(
  const std::vector<Measurement>& measurements, double metersPerWorldUnit, vtkPolyData* all);

/**
 * Reads measurements from a polydata. Returns false and writes the reason and the cure to `error`
 * if CopyToPolyData can't have made it.
 */
bool ReadPolyData(vtkPolyData* all, std::vector<Measurement>& measurements, std::string& error);

} // namespace VolumeHaptics

#endif
