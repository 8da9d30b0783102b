// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticStateLog.h"

#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <iomanip>
#include <limits>

namespace VolumeHapticsLive
{

namespace
{
/** Of the device's states; a view may read them, too. */
constexpr int Reader = 1;
} // namespace

bool HapticStateLog::Start(const std::string& file, vtkHapticDevice* device, std::string& error)
{
  const auto dot = file.rfind('.');
  if (dot == std::string::npos || file.substr(dot) != ".csv")
  {
    error = "What is felt of a region of a server's volume can't be replayed, and is written as "
            "numbers: let "
            "RecordingFile, now \"" +
      file + "\", end in .csv.";
    return false;
  }
  this->Name = file;
  this->File.clear();
  this->File.open(file);
  if (!this->File)
  {
    error =
      "The file \"" + file + "\" can't be written. Choose a RecordingFile in a folder that can be.";
    return false;
  }
  this->File << std::setprecision(std::numeric_limits<double>::max_digits10);
  this->HasHeader = false;
  vtkNew<vtkTable> before;
  device->DrainStates(nullptr, Reader);
  device->DrainStates(before, Reader);
  return true;
}

void HapticStateLog::Continue(vtkHapticDevice* device)
{
  if (!this->IsOpen())
  {
    return;
  }
  vtkNew<vtkTable> table;
  device->DrainStates(table, Reader);
  const auto write = [this, &table](auto&& value)
  {
    const char* comma = "";
    for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
    {
      auto* const column = vtkDataArray::SafeDownCast(table->GetColumn(c));
      const int components = column ? column->GetNumberOfComponents() : 0;
      for (int i = 0; i < components; ++i, comma = ",")
      {
        this->File << comma;
        value(column, i);
      }
    }
    this->File << "\n";
  };
  if (!this->HasHeader && table->GetNumberOfColumns() > 0)
  {
    write(
      [this](vtkDataArray* column, int i)
      {
        this->File << column->GetName();
        if (column->GetNumberOfComponents() > 1)
        {
          this->File << ":" << i;
        }
      });
    this->HasHeader = true;
  }
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    write([this, row](vtkDataArray* column, int i) { this->File << column->GetComponent(row, i); });
  }
}

bool HapticStateLog::Stop(vtkHapticDevice* device, std::string& error)
{
  if (!this->IsOpen())
  {
    return true;
  }
  device->DrainStates(nullptr, Reader);
  this->File.close(); // also tells whether the last of it could be written
  if (!this->File)
  {
    error = "The file \"" + this->Name +
      "\" lacks what was felt: it could not be written to its end. Make room on its disk, or "
      "choose "
      "a RecordingFile on another one.";
    return false;
  }
  return true;
}

} // namespace VolumeHapticsLive
