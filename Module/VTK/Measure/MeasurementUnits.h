// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts values of measurements to numbers and texts with units. Lengths are in the unit of the
 * world if it has a name, otherwise in millimetres.
 */
#ifndef MeasurementUnits_h
#define MeasurementUnits_h

#include "VTK/Measure/Measurement.h"

#include <string>

namespace VolumeHaptics
{

struct LengthUnit
{
  const char* Name;    ///< UCUM symbol
  double PerWorldUnit; ///< exactly 1 if it is the unit of the world
};

LengthUnit ChooseLengthUnit(double metersPerWorldUnit);

/** Returns the UCUM unit for a kind of measurement: "mm", "mm2", "deg", or an empty text. */
std::string GetUnit(MeasuredKind kind, double metersPerWorldUnit);
/** Returns the value in the unit of GetUnit(); NaN if there is no value. */
double GetValue(const Measurement& measurement, double metersPerWorldUnit);
/** Returns the value with its unit for display, such as "42.5 mm"; empty if there is no value. */
std::string DescribeValue(const Measurement& measurement, double metersPerWorldUnit);

} // namespace VolumeHaptics

#endif
