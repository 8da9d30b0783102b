// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/HapticTraceFiles.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/XmlFiles.h"
#include "VTK/Trace/RecordingNames.h"

#include "vtkDataArray.h"
#include "vtkDelimitedTextReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

/**
 * Titles of the three columns of positions, in order of preference: those of this library, of
 * ParaView, and of other tables.
 */
const char* const WorldColumns[][3] = { { "Tip x", "Tip y", "Tip z" },
  { "Points:0", "Points:1", "Points:2" }, { "x", "y", "z" } };
const char* const OrientationAxes[4] = { " w", " x", " y", " z" };
const char* const DeviceColumns[3] = { "DeviceTip x", "DeviceTip y", "DeviceTip z" };

/** Removes the unit from the title of a column: "Tip x (world)" becomes "Tip x". */
std::string WithoutUnit(const std::string& title)
{
  return title.substr(0, title.find(" ("));
}

/** Returns the numbers of a column that a replay needs; empty if the column is missing. */
std::vector<double> ReadColumn(vtkTable* table, const std::string& wanted)
{
  std::vector<double> values;
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    const char* const title = table->GetColumnName(c);
    auto* const numbers = vtkDataArray::SafeDownCast(table->GetColumn(c));
    if (title && numbers && WithoutUnit(title) == wanted)
    {
      for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
      {
        values.push_back(numbers->GetComponent(i, 0));
      }
      break;
    }
  }
  return values;
}

/** Returns the vectors in three columns; empty if a column is missing. */
std::vector<Vector3> ReadVectors(vtkTable* table, const char* const columns[3])
{
  const std::vector<double> x = ReadColumn(table, columns[0]);
  const std::vector<double> y = ReadColumn(table, columns[1]);
  const std::vector<double> z = ReadColumn(table, columns[2]);
  std::vector<Vector3> vectors;
  for (std::size_t i = 0; i < x.size() && x.size() == y.size() && x.size() == z.size(); ++i)
  {
    vectors.push_back({ x[i], y[i], z[i] });
  }
  return vectors;
}

std::vector<Vector3> ReadVectors(vtkDataArray* array)
{
  std::vector<Vector3> vectors;
  for (vtkIdType i = 0;
       array && array->GetNumberOfComponents() == 3 && i < array->GetNumberOfTuples(); ++i)
  {
    vectors.push_back(
      { array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) });
  }
  return vectors;
}

///@{
/**
 * Return the quaternions in four columns or in an array; empty if a column or the array is missing.
 */
std::vector<Quaternion> ReadQuaternions(vtkTable* table, const std::string& name)
{
  std::vector<double> parts[4];
  for (int c = 0; c < 4; ++c)
  {
    parts[c] = ReadColumn(table, name + OrientationAxes[c]);
    if (parts[c].size() != parts[0].size())
    {
      return {};
    }
  }
  std::vector<Quaternion> quaternions;
  for (std::size_t i = 0; i < parts[0].size(); ++i)
  {
    quaternions.push_back({ parts[0][i], parts[1][i], parts[2][i], parts[3][i] });
  }
  return quaternions;
}

std::vector<Quaternion> ReadQuaternions(vtkDataArray* array)
{
  std::vector<Quaternion> quaternions;
  for (vtkIdType i = 0;
       array && array->GetNumberOfComponents() == 4 && i < array->GetNumberOfTuples(); ++i)
  {
    quaternions.push_back(ReadQuaternion(array, i));
  }
  return quaternions;
}
///@}

std::vector<double> ReadNumbers(vtkDataArray* array)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    numbers.push_back(array->GetComponent(i, 0));
  }
  return numbers;
}

/** Contents of a file before they are checked. */
struct Contents
{
  std::vector<Vector3> DeviceTips;
  std::vector<Vector3> WorldTips;
  std::vector<double> Times;
  std::vector<Quaternion> DeviceOrientations;
  std::vector<Quaternion> WorldOrientations;
};

Contents ReadPolyData(const std::string& file, bool& failed)
{
  const vtkSmartPointer<vtkPolyData> data = ReadXmlPolyData(file, failed);
  Contents contents;
  contents.DeviceTips = ReadVectors(data->GetPointData()->GetArray(RecordingNames::DeviceTip));
  contents.WorldTips = ReadVectors(data->GetPointData()->GetArray("Tip"));
  if (contents.WorldTips.empty() && data->GetPoints())
  {
    contents.WorldTips = ReadVectors(data->GetPoints()->GetData());
  }
  contents.Times = ReadNumbers(data->GetPointData()->GetArray("Time"));
  contents.DeviceOrientations =
    ReadQuaternions(data->GetPointData()->GetArray(RecordingNames::DeviceOrientation));
  contents.WorldOrientations =
    ReadQuaternions(data->GetPointData()->GetArray(RecordingNames::Orientation));
  return contents;
}

Contents ReadTable(const std::string& file)
{
  vtkNew<vtkDelimitedTextReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetHaveHeaders(true);
  reader->DetectNumericColumnsOn();
  reader->ForceDoubleOn();
  // Read a missing cell as NaN instead of 0, so that it is detected.
  reader->SetDefaultDoubleValue(std::numeric_limits<double>::quiet_NaN());
  reader->Update();
  vtkTable* const table = reader->GetOutput();
  Contents contents;
  contents.DeviceTips = ReadVectors(table, DeviceColumns);
  contents.Times = ReadColumn(table, "Time");
  contents.DeviceOrientations = ReadQuaternions(table, RecordingNames::DeviceOrientation);
  contents.WorldOrientations = ReadQuaternions(table, RecordingNames::Orientation);
  for (const auto& columns : WorldColumns)
  {
    if (contents.WorldTips.empty())
    {
      contents.WorldTips = ReadVectors(table, columns);
    }
  }
  return contents;
}

/**
 * Returns whether the last line of a table ends with a line break, which is usually missing in a
 * truncated table.
 */
bool EndsWithLine(const std::string& file)
{
  vtksys::ifstream stream(file.c_str(), std::ios::binary);
  stream.seekg(-1, std::ios::end);
  return stream.get() == '\n';
}

/** Returns the first fault in the contents; empty if they are valid. */
std::string Judge(const std::vector<Vector3>& tips, const std::vector<double>& times)
{
  if (tips.empty())
  {
    return "holds no tip positions (point array or columns \"Tip\" or \"DeviceTip\", three numbers "
           "a "
           "tick; or columns \"x\", \"y\" and \"z\")";
  }
  if (!times.empty() && times.size() != tips.size())
  {
    return "has another number of times than of tips: it is cut off";
  }
  for (std::size_t i = 0; i < tips.size(); ++i)
  {
    if (!IsFinite(tips[i]) || (!times.empty() && !std::isfinite(times[i])))
    {
      return "has a number that is NaN or infinite in tick " + std::to_string(i);
    }
    if (i > 0 && !times.empty() && times[i] < times[i - 1])
    {
      return "runs backwards in time at tick " + std::to_string(i) + ": its lines were reordered";
    }
  }
  return {};
}

/** Reads the tips. Returns the fault of the file; empty if it is valid. */
std::string ReadTips(const std::string& file, bool isPath, RecordedTips& result)
{
  const std::string ending = GetTraceEnding(file);
  if (ending.empty())
  {
    return std::string("has an unknown extension: a ") + (isPath ? "path" : "recording") +
      " is a .vtp or a .csv";
  }
  std::string error;
  if (!CheckRegular(file, error))
  {
    return error;
  }
  if (vtksys::SystemTools::FileLength(file) == 0)
  {
    return "is empty";
  }
  if (ending == ".csv" && !isPath && !EndsWithLine(file))
  {
    return "is cut off: its last line has no end";
  }
  bool failed = false;
  Contents contents = ending == ".vtp" ? ReadPolyData(file, failed) : ReadTable(file);
  if (failed)
  {
    return "cannot be read as VTK polydata: it is cut off or something else";
  }
  result.InDeviceSpace = !isPath && !contents.DeviceTips.empty();
  result.Tips = std::move(result.InDeviceSpace ? contents.DeviceTips : contents.WorldTips);
  result.Times = std::move(contents.Times);
  if (!isPath)
  {
    result.Orientations =
      std::move(result.InDeviceSpace ? contents.DeviceOrientations : contents.WorldOrientations);
  }
  return Judge(result.Tips, result.Times);
}

} // namespace

std::string GetTraceEnding(const std::string& file)
{
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
  return ending == ".vtp" || ending == ".csv" ? ending : std::string();
}

bool ReadTraceFile(const std::string& file, RecordedTips& result, std::string& error)
{
  error = ReadTips(file, false, result);
  if (error.empty())
  {
    return true;
  }
  result = {};
  error = "The recording " + file + " " + error +
    ". Record again with vtkHapticRecorder::Start, or give another file.";
  return false;
}

bool ReadPathFile(const std::string& file, RecordedTips& result, std::string& error)
{
  error = file.empty() ? "(no name was given) does not exist" : ReadTips(file, true, result);
  if (error.empty())
  {
    return true;
  }
  result = {};
  error = "The path file " + file + (file.empty() ? "" : " ") + error + ". Give another FileName.";
  return false;
}

} // namespace VolumeHaptics
