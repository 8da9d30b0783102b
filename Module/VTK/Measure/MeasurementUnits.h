// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Values of measurements with units, as numbers and as texts. Lengths are in the unit of the world
 * if the unit has a name, otherwise in millimetres.
 */
#ifndef MeasurementUnits_h
#define MeasurementUnits_h

#include "VTK/Measure/Measurement.h"

#include <string>

namespace VolumeHaptics
{

struct LengthUnit
{
  const char* Name;    ///< name in UCUM
  double PerWorldUnit; ///< exactly 1 for the unit of the world
};

LengthUnit ChooseLengthUnit(double metersPerWorldUnit);

/** Returns the unit of a kind as in UCUM: "mm", "mm2", "deg", or an empty text. */
std::string GetUnit(MeasuredKind kind, double metersPerWorldUnit);
/** Returns the value, in the unit that GetUnit() returns; NaN if there is no value. */
double GetValue(const Measurement& measurement, double metersPerWorldUnit);
/** Describes the value and its unit for display, such as "42.5 mm"; empty if there is no value. */
std::string DescribeValue(const Measurement& measurement, double metersPerWorldUnit);

} // namespace VolumeHaptics

#endif
