// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/MeasurementFiles.h"

#include "VTK/Base/FileReplacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/PolyDataReading.h"
#include "VTK/Measure/MeasurementPolyData.h"
#include "VTK/Measure/MeasurementTable.h"
#include "VTK/Trace/TraceWriter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtksys/SystemTools.hxx"

#include <cstddef>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t LargestFile = std::size_t{ 256 } << 20; // bytes
constexpr const char* Unknown =
  "its ending tells no format. Choose a name that ends in .csv, .vtp or .mrk.json.";

enum class FileKind
{
  Unknown,
  Table,
  PolyData,
  Markups
};

FileKind FindFileKind(const std::string& file)
{
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
  return ending == ".csv" ? FileKind::Table
    : ending == ".vtp"    ? FileKind::PolyData
    : ending == ".json"   ? FileKind::Markups
                          : FileKind::Unknown;
}

bool WriteText(const std::string& text, const std::string& file, std::string& error)
{
  FileReplacement written;
  if (!written.Open(file, error))
  {
    return false;
  }
  written.Write(text);
  return written.Commit(error);
}

bool ReadVtp(const std::string& file, std::vector<Measurement>& measurements, std::string& error)
{
  bool failed = false;
  const vtkSmartPointer<vtkPolyData> data = ReadXmlPolyData(file, failed);
  error = "it is not a complete .vtp file. Write it again.";
  return !failed && ReadPolyData(data, measurements, error);
}

} // namespace

bool WriteMeasurements(const std::string& file, const std::vector<Measurement>& measurements,
  const MarkupsFrame& frame, std::string& error)
{
  const FileKind kind = FindFileKind(file);
  if (kind == FileKind::Table)
  {
    return WriteText(WriteMeasurementTable(measurements, frame.MetersPerWorldUnit), file, error);
  }
  if (kind == FileKind::Markups)
  {
    return WriteText(WriteMarkups(measurements, frame), file, error);
  }
  if (kind == FileKind::PolyData)
  {
    vtkNew<vtkPolyData> data;
    CopyToPolyData(measurements, frame.MetersPerWorldUnit, data);
    return WriteTracePolyData(data, file, error);
  }
  error = Unknown;
  return false;
}

bool ReadMeasurements(const std::string& file, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error)
{
  const FileKind kind = FindFileKind(file);
  if (kind == FileKind::Unknown)
  {
    error = Unknown;
    return false;
  }
  std::string text;
  if (!ReadSmallFile(file, LargestFile, text, error))
  {
    error = "it " + error + ". Choose a file that exists and may be read by you.";
    return false;
  }
  return kind == FileKind::Table ? ReadMeasurementTable(text, measurements, error)
    : kind == FileKind::Markups  ? ReadMarkups(text, frame, measurements, notes, error)
                                 : ReadVtp(file, measurements, error);
}

} // namespace VolumeHaptics
