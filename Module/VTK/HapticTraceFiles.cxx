// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticTraceFiles.h"

#include "HapticTipPath.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDelimitedTextReader.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkXMLPolyDataReader.h"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

const char* const Axes[] = { " x", " y", " z" };

/** The title of a column without its unit: "Tip x (world)" is "Tip x". */
std::string WithoutUnit(const std::string& title)
{
  return title.substr(0, title.find(" ("));
}

/** The columns of a table that a replay needs: numbers, or an empty vector where one is missing. */
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

/** Vectors of three columns; empty where they are not all there. */
std::vector<Vector3> ReadVectors(vtkTable* table, const std::string& name)
{
  const std::vector<double> x = ReadColumn(table, name + Axes[0]);
  const std::vector<double> y = ReadColumn(table, name + Axes[1]);
  const std::vector<double> z = ReadColumn(table, name + Axes[2]);
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

std::vector<double> ReadNumbers(vtkDataArray* array)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    numbers.push_back(array->GetComponent(i, 0));
  }
  return numbers;
}

/** What a file holds, before it is judged. */
struct Contents
{
  std::vector<Vector3> DeviceTips;
  std::vector<Vector3> WorldTips;
  std::vector<double> Times;
};

Contents ReadPolyData(const std::string& file, bool& failed)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  // The reader's own complaints are replaced by one that says what to do.
  struct Observer : vtkCommand
  {
    static Observer* New() { return new Observer; }
    void Execute(vtkObject*, unsigned long, void*) override { *this->Failed = true; }
    bool* Failed = nullptr;
  };
  vtkNew<Observer> observer;
  observer->Failed = &failed;
  reader->SetReaderErrorObserver(observer);
  reader->SetParserErrorObserver(observer);
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->SetFileName(file.c_str());
  reader->Update();
  Contents contents;
  vtkPolyData* const data = reader->GetOutput();
  contents.DeviceTips = ReadVectors(data->GetPointData()->GetArray(RecordingNames::DeviceTip));
  contents.WorldTips = ReadVectors(data->GetPointData()->GetArray("Tip"));
  if (contents.WorldTips.empty() && data->GetPoints())
  {
    contents.WorldTips = ReadVectors(data->GetPoints()->GetData());
  }
  contents.Times = ReadNumbers(data->GetPointData()->GetArray("Time"));
  return contents;
}

Contents ReadTable(const std::string& file)
{
  vtkNew<vtkDelimitedTextReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetHaveHeaders(true);
  reader->DetectNumericColumnsOn();
  reader->ForceDoubleOn();
  // A missing cell is no zero: it is found out as a number that is not finite.
  reader->SetDefaultDoubleValue(std::numeric_limits<double>::quiet_NaN());
  reader->Update();
  vtkTable* const table = reader->GetOutput();
  return { ReadVectors(table, RecordingNames::DeviceTip), ReadVectors(table, "Tip"),
    ReadColumn(table, "Time") };
}

/** A table that was cut off shows in its last line, which has no end. */
bool EndsWithLine(const std::string& file)
{
  vtksys::ifstream stream(file.c_str(), std::ios::binary);
  stream.seekg(-1, std::ios::end);
  return stream.get() == '\n';
}

/** What is wrong with the contents; empty where nothing is. */
std::string Judge(const std::vector<Vector3>& tips, const std::vector<double>& times)
{
  if (tips.empty())
  {
    return "holds no tip positions (point array or columns \"Tip\" or \"DeviceTip\", three numbers "
           "a "
           "tick)";
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

} // namespace

bool ReadTraceFile(const std::string& file, RecordedTips& result, std::string& error)
{
  const std::string ending = GetTraceEnding(file);
  error.clear();
  if (ending.empty())
  {
    error = "has an unknown ending: a recording is a .vtp or a .csv";
  }
  else if (!vtksys::SystemTools::FileExists(file, true))
  {
    error = "does not exist";
  }
  else if (vtksys::SystemTools::FileLength(file) == 0)
  {
    error = "is empty";
  }
  else if (ending == ".csv" && !EndsWithLine(file))
  {
    error = "is cut off: its last line has no end";
  }
  else
  {
    bool failed = false;
    Contents contents = ending == ".vtp" ? ReadPolyData(file, failed) : ReadTable(file);
    result.InDeviceSpace = !contents.DeviceTips.empty();
    result.Tips = std::move(result.InDeviceSpace ? contents.DeviceTips : contents.WorldTips);
    error = failed ? "cannot be read as VTK polydata: it is cut off or something else"
                   : Judge(result.Tips, contents.Times);
  }
  if (error.empty())
  {
    return true;
  }
  result = {};
  error = "The recording " + file + " " + error +
    ". Record again with vtkHapticDevice::StartRecording, or give another file.";
  return false;
}

} // namespace VolumeHaptics
