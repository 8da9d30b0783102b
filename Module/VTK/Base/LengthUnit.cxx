// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/LengthUnit.h"

#include <cctype>
#include <map>

namespace VolumeHaptics
{
namespace
{

constexpr double Pico = 1e-9;
constexpr double Angstrom = 1e-7;
constexpr double Nano = 1e-6;
constexpr double Micro = 1e-3;
constexpr double Centi = 10.0;
constexpr double Metre = 1000.0;
constexpr double Inch = 25.4;

// The micro sign and the Greek letter mu, in UTF-8 and in Latin 1. ImageJ writes the micro sign as
// an escape sequence.
const std::map<std::string, double> Units = { { "pm", Pico }, { "picometer", Pico },
  { "angstrom", Angstrom }, { "\xc3\x85", Angstrom }, { "nm", Nano }, { "nanometer", Nano },
  { "nanometre", Nano }, { "um", Micro }, { "\xc2\xb5m", Micro }, { "\xce\xbcm", Micro },
  { "\xb5m", Micro }, { "\\u00b5m", Micro }, { "micron", Micro }, { "micrometer", Micro },
  { "micrometre", Micro }, { "mm", 1.0 }, { "millimeter", 1.0 }, { "millimetre", 1.0 },
  { "cm", Centi }, { "centimeter", Centi }, { "centimetre", Centi }, { "m", Metre },
  { "meter", Metre }, { "metre", Metre }, { "in", Inch }, { "inch", Inch }, { "inche", Inch } };

} // namespace

double MillimetresPerUnit(const std::string& unit)
{
  std::string name;
  for (const char letter : unit)
  {
    if (letter != ' ' && letter != '"')
    {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  if (name.size() > 2 && name.back() == 's')
  {
    name.pop_back(); // removes the plural "s"
  }
  const auto found = Units.find(name);
  return found == Units.end() ? 0.0 : found->second;
}

} // namespace VolumeHaptics
