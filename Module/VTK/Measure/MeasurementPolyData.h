// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measurements as polydata: see vtkHapticMeasurements::CopyToPolyData.
 */
#ifndef MeasurementPolyData_h
#define MeasurementPolyData_h

#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

/** The shape of one measurement: a vertex, a line or triangles, with what was felt. */
void CopyShape(const Measurement& measurement, vtkPolyData* shape);

/**
 * The points of a shape in their order, or of an area its triangles, with Time, Force and
 * SurfaceValue of the points if it has them.
 */
Measurement ReadShape(MeasuredKind kind, vtkPolyData* shape);

/** All of them, with names, values and units. */
void CopyToPolyData(
  const std::vector<Measurement>& measurements, double metersPerWorldUnit, vtkPolyData* all);

/** False, with the reason and the cure, if the polydata is not what CopyToPolyData makes. */
bool ReadPolyData(vtkPolyData* all, std::vector<Measurement>& measurements, std::string& error);

} // namespace VolumeHaptics

#endif
