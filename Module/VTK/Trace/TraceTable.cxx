// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TraceTable.h"

#include "VTK/Trace/HapticTraceColumns.h"

#include <iomanip>
#include <limits>
#include <locale>

namespace VolumeHaptics
{

TraceTable::TraceTable()
{
  this->Line.imbue(std::locale::classic());
  this->Line << std::setprecision(std::numeric_limits<double>::max_digits10);
}

void TraceTable::AddTitle(const std::string& array, int components)
{
  static const char* const axes[] = { " w", " x", " y", " z" };
  const bool hasAxes = components == 3 || components == 4; // a vector has no w
  for (int c = 0; c < components; ++c)
  {
    this->Line << this->Separator << array << (hasAxes ? axes[c + 4 - components] : "")
               << GetTraceUnit(array);
    this->Separator = ",";
  }
}

void TraceTable::AddNumber(double number)
{
  this->Line << this->Separator << number;
  this->Separator = ",";
}

std::string TraceTable::EndLine()
{
  std::string line = this->Line.str() + "\n";
  this->Line.str({});
  this->Separator = "";
  return line;
}

} // namespace VolumeHaptics
