// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/MeasurementUnits.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

struct NamedUnit
{
  const char* Name;
  double Meters;
};
constexpr NamedUnit Units[] = { { "mm", 1e-3 }, { "um", 1e-6 }, { "m", 1.0 }, { "cm", 1e-2 },
  { "nm", 1e-9 }, { "km", 1e3 } };

/** Returns a unit as users see it: replaces "um" with the micro sign and "m". */
std::string ForPeople(const std::string& unit)
{
  return unit.rfind("um", 0) == 0 ? "\xC2\xB5" + unit.substr(1) : unit;
}

} // namespace

LengthUnit ChooseLengthUnit(double metersPerWorldUnit)
{
  for (const NamedUnit& unit : Units)
  {
    if (std::abs(metersPerWorldUnit - unit.Meters) <= 1e-9 * unit.Meters)
    {
      return { unit.Name, 1.0 };
    }
  }
  return { "mm", metersPerWorldUnit / 1e-3 };
}

std::string GetUnit(MeasuredKind kind, double metersPerWorldUnit)
{
  const std::string length = ChooseLengthUnit(metersPerWorldUnit).Name;
  switch (kind)
  {
    case MeasuredKind::Point:
      return {};
    case MeasuredKind::Angle:
      return "deg";
    case MeasuredKind::Area:
      return length + "2";
    default:
      return length;
  }
}

double GetValue(const Measurement& measurement, double metersPerWorldUnit)
{
  const double length = ChooseLengthUnit(metersPerWorldUnit).PerWorldUnit;
  const double value = measurement.Measure();
  switch (measurement.Kind)
  {
    case MeasuredKind::Distance:
    case MeasuredKind::Path:
      return length * value;
    case MeasuredKind::Area:
      return length * length * value;
    default:
      return value;
  }
}

std::string DescribeValue(const Measurement& measurement, double metersPerWorldUnit)
{
  const double value = GetValue(measurement, metersPerWorldUnit);
  if (!std::isfinite(value))
  {
    return {};
  }
  // Write at least three significant digits: 0.123, 1.23, 12.3, 1234.
  const double size = std::max(std::abs(value), 1e-6);
  const int digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 8);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed;
  text.precision(value == 0.0 ? 0 : digits);
  text << value;
  switch (measurement.Kind)
  {
    case MeasuredKind::Point:
      return "value " + text.str();
    case MeasuredKind::Angle:
      return text.str() + "\xC2\xB0"; // UTF-8: degree sign
    case MeasuredKind::Area:
    {
      const std::string length = ChooseLengthUnit(metersPerWorldUnit).Name;
      return text.str() + " " + ForPeople(length) + "\xC2\xB2"; // UTF-8: superscript two
    }
    default:
      return text.str() + " " + ForPeople(GetUnit(measurement.Kind, metersPerWorldUnit));
  }
}

} // namespace VolumeHaptics
