// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticStateLog.h"

#include "VTK/Trace/TraceWriter.h"

#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <vector>

namespace VolumeHapticsLive
{

namespace
{
/** The log's number as a reader of the device's states; a view may be another reader. */
constexpr int Reader = 1;
} // namespace

bool HapticStateLog::Start(const std::string& file, vtkHapticDevice* device, std::string& error)
{
  const auto dot = file.rfind('.');
  if (dot == std::string::npos || file.substr(dot) != ".csv")
  {
    error = "What is felt of a region of a server's volume can't be replayed, and is written as "
            "numbers: let RecordingFile, now \"" +
      file + "\", end in .csv.";
    return false;
  }
  this->Name = file;
  this->File.clear();
  this->File.open(file);
  if (!this->File)
  {
    error = "The file \"" + file +
      "\" can't be written. Choose a RecordingFile in a folder that you may write to.";
    return false;
  }
  this->HasTitles = false;
  vtkNew<vtkTable> before;
  device->GetState()->Drain(nullptr, Reader);
  device->GetState()->Drain(before, Reader);
  return true;
}

void HapticStateLog::Continue(vtkHapticDevice* device)
{
  if (!this->IsOpen())
  {
    return;
  }
  vtkNew<vtkTable> table;
  device->GetState()->Drain(table, Reader);
  std::vector<vtkDataArray*> columns;
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    if (auto* const column = vtkDataArray::SafeDownCast(table->GetColumn(c)))
    {
      columns.push_back(column);
    }
  }
  VolumeHaptics::TraceTable text;
  if (!this->HasTitles && !columns.empty())
  {
    for (vtkDataArray* const column : columns)
    {
      text.AddTitle(column->GetName(), column->GetNumberOfComponents());
    }
    this->File << text.EndLine();
    this->HasTitles = true;
  }
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkDataArray* const column : columns)
    {
      for (int i = 0; i < column->GetNumberOfComponents(); ++i)
      {
        text.AddNumber(column->GetComponent(row, i));
      }
    }
    this->File << text.EndLine();
  }
}

bool HapticStateLog::Stop(vtkHapticDevice* device, std::string& error)
{
  if (!this->IsOpen())
  {
    return true;
  }
  device->GetState()->Drain(nullptr, Reader);
  this->File.close(); // closing also detects whether the end of the file could be written
  if (!this->File)
  {
    error = "The file \"" + this->Name +
      "\" is incomplete: it could not be written to the end. Make room on its disk, or "
      "choose a RecordingFile on another one.";
    return false;
  }
  return true;
}

} // namespace VolumeHapticsLive
