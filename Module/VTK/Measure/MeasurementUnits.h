// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Values of measurements in units, and as texts. Lengths are in the unit of the world if it has a
 * name, else in millimetres.
 */
#ifndef MeasurementUnits_h
#define MeasurementUnits_h

#include "VTK/Measure/Measurement.h"

#include <string>

namespace VolumeHaptics
{

struct LengthUnit
{
  const char* Name;    ///< as in UCUM
  double PerWorldUnit; ///< 1 to the bit if it is that of the world
};

LengthUnit FindLengthUnit(double metersPerWorldUnit);

/** "mm", "deg", "mm2", or empty, as in UCUM. */
std::string GetUnit(MeasuredKind kind, double metersPerWorldUnit);
/** In that unit; NaN if there is no value. */
double GetValue(const Measurement& measurement, double metersPerWorldUnit);
/** The value and its unit for people, such as "42.5 mm"; empty if there is no value. */
std::string DescribeValue(const Measurement& measurement, double metersPerWorldUnit);

} // namespace VolumeHaptics

#endif
