// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/MeasurementFiles.h"

#include "Core/Platform/FileReplacement.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/XmlFiles.h"
#include "VTK/Material/Labels/CsvRows.h"
#include "VTK/Material/Labels/LabelText.h"
#include "VTK/Measure/Measurement.h"
#include "VTK/Measure/MeasurementPolyData.h"
#include "VTK/Measure/MeasurementUnits.h"
#include "VTK/Trace/TraceWriter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

enum Column
{
  Group,
  Name,
  Kind,
  PointId,
  X,
  Y,
  Z,
  Time,
  ForceX,
  ForceY,
  ForceZ,
  SurfaceValue,
  Columns
};

/** Titles of the columns, in the normalised form of MakeKey(). */
constexpr const char* Keys[Columns] = { "measurement", "name", "kind", "point", "x", "y", "z",
  "time", "forcex", "forcey", "forcez", "surfacevalue" };

constexpr const char* Titles = "measurement,name,kind,value,unit,point,x,y,z,time (s),force x (N),"
                               "force y (N),force z (N),surface value\n";

/** Writes the rows of the table, with empty cells for unknown quantities. */
class TableLines
{
public:
  TableLines()
  {
    this->Text.imbue(std::locale::classic());
    this->Text.precision(std::numeric_limits<double>::max_digits10);
    this->Text << Titles;
  }

  void Add(const std::string& head, const Measurement& measurement, std::size_t point)
  {
    const Vector3& p = measurement.Points[point];
    const MeasuredSample sample =
      measurement.Samples.empty() ? MeasuredSample() : measurement.Samples[point];
    this->Text << head << point << "," << p.X << "," << p.Y << "," << p.Z;
    for (const double number :
      { sample.Time, sample.Force.X, sample.Force.Y, sample.Force.Z, sample.SurfaceValue })
    {
      this->Text << ",";
      if (std::isfinite(number))
      {
        this->Text << number;
      }
    }
    this->Text << "\n";
  }

  std::string Get() const { return this->Text.str(); }

private:
  std::ostringstream Text;
};

std::string MakeHead(std::size_t number, const Measurement& measurement, double metersPerWorldUnit)
{
  const double value = GetValue(measurement, metersPerWorldUnit);
  std::ostringstream head;
  head.imbue(std::locale::classic());
  head.precision(std::numeric_limits<double>::max_digits10);
  head << number << "," << WriteCell(measurement.Name) << "," << GetKindName(measurement.Kind)
       << ",";
  if (std::isfinite(value))
  {
    head << value;
  }
  head << "," << GetUnit(measurement.Kind, metersPerWorldUnit) << ",";
  return head.str();
}

/** Index of each column in the rows; -1 for a missing column. */
struct TableColumns
{
  explicit TableColumns(const std::vector<std::string>& titles)
  {
    std::fill(std::begin(this->Place), std::end(this->Place), -1);
    for (std::size_t i = 0; i < titles.size(); ++i)
    {
      const auto* const found = std::find(std::begin(Keys), std::end(Keys), MakeKey(titles[i]));
      if (found != std::end(Keys) && this->Place[found - std::begin(Keys)] == -1)
      {
        this->Place[found - std::begin(Keys)] = static_cast<int>(i);
      }
    }
  }
  std::string Cell(const std::vector<std::string>& cells, int column) const
  {
    const int place = this->Place[column];
    return place >= 0 && static_cast<std::size_t>(place) < cells.size()
      ? cells[static_cast<std::size_t>(place)]
      : std::string();
  }
  bool Has(int column) const { return this->Place[column] >= 0; }

private:
  int Place[Columns];
};

/** Combines the rows of a measurement. */
class TableReader
{
public:
  TableReader(const std::vector<std::string>& titles, bool allowsCommas)
    : Place(titles)
    , AllowsCommas(allowsCommas)
  {
  }

  bool Check(std::string& error) const
  {
    if (this->Place.Has(X) && this->Place.Has(Y) && this->Place.Has(Z))
    {
      return true;
    }
    error = "its first line has no columns x, y and z. Name them there";
    return false;
  }

  bool ReadRow(const std::vector<std::string>& cells, std::string& error)
  {
    const std::string group = this->Place.Cell(cells, Group);
    if (this->Measurements.empty() || group.empty() || group != this->GroupOfLast)
    {
      this->GroupOfLast = group;
      this->PointOfId.clear();
      this->Corners.clear();
      this->Measurements.emplace_back();
      Measurement& begun = this->Measurements.back();
      begun.Name = MakeLabelName(this->Place.Cell(cells, Name));
      const std::string kind = this->Place.Cell(cells, Kind);
      if (!kind.empty() && !FindKind(kind, begun.Kind))
      {
        error = "the kind is " + Quote(kind) + ". Write Point, Distance, Angle, Path or Area";
        return false;
      }
    }
    double numbers[Columns] = {};
    for (int column = X; column < Columns; ++column)
    {
      if (!this->ReadCell(cells, column, numbers[column], error))
      {
        return false;
      }
    }
    this->AddPoint(cells, numbers);
    return true;
  }

  std::vector<Measurement> Measurements;

private:
  bool ReadCell(
    const std::vector<std::string>& cells, int column, double& number, std::string& error) const
  {
    std::string cell = this->Place.Cell(cells, column);
    number = MeasuredSample::Unknown;
    if (cell.empty() && column > Z)
    {
      return true;
    }
    if (this->AllowsCommas)
    {
      std::replace(cell.begin(), cell.end(), ',', '.');
    }
    const std::optional<double> read = ReadNumber(cell);
    if (!read)
    {
      error = std::string("column ") + Keys[column] + " has " + Quote(cell) + ". Write a number";
      return false;
    }
    number = *read;
    return true;
  }

  void AddPoint(const std::vector<std::string>& cells, const double (&numbers)[Columns])
  {
    Measurement& last = this->Measurements.back();
    if (last.Kind == MeasuredKind::Area)
    {
      const std::string id = this->Place.Cell(cells, PointId);
      const auto [place, isNew] = this->PointOfId.emplace(
        id.empty() ? std::to_string(this->PointOfId.size()) : id, last.Points.size());
      if (isNew)
      {
        last.Points.push_back({ numbers[X], numbers[Y], numbers[Z] });
      }
      this->Corners.push_back(static_cast<int>(place->second));
      if (this->Corners.size() == 3)
      {
        last.Triangles.push_back({ this->Corners[0], this->Corners[1], this->Corners[2] });
        this->Corners.clear();
      }
      return;
    }
    last.Points.push_back({ numbers[X], numbers[Y], numbers[Z] });
    last.Samples.push_back({ numbers[Time], { numbers[ForceX], numbers[ForceY], numbers[ForceZ] },
      numbers[SurfaceValue] });
  }

  const TableColumns Place;
  const bool AllowsCommas;
  std::string GroupOfLast;
  /** Indices of an area's points, by the identifiers in the file. */
  std::map<std::string, std::size_t> PointOfId;
  std::vector<int> Corners; ///< corners read so far of an incomplete triangle
};

bool IsKnown(const MeasuredSample& sample)
{
  return std::isfinite(sample.Time) || IsFinite(sample.Force) || std::isfinite(sample.SurfaceValue);
}

/** Writes a table. Numbers have enough digits to be restored exactly. */
std::string WriteMeasurementTable(
  const std::vector<Measurement>& measurements, double metersPerWorldUnit)
{
  TableLines lines;
  for (std::size_t i = 0; i < measurements.size(); ++i)
  {
    const Measurement& measurement = measurements[i];
    const std::string head = MakeHead(i + 1, measurement, metersPerWorldUnit);
    for (const std::array<int, 3>& triangle : measurement.Triangles)
    {
      for (const int corner : triangle)
      {
        lines.Add(head, measurement, static_cast<std::size_t>(corner));
      }
    }
    for (std::size_t p = 0; measurement.Triangles.empty() && p < measurement.Points.size(); ++p)
    {
      lines.Add(head, measurement, p);
    }
  }
  return lines.Get();
}

/** Reads a table. On failure, returns false, with the reason and the cure in `error`. */
bool ReadMeasurementTable(
  std::string_view text, std::vector<Measurement>& measurements, std::string& error)
{
  const char separator = DetectSeparator(text);
  CsvRows rows(text, separator);
  std::vector<std::string> cells;
  while (rows.Next(cells) && IsEmptyRow(cells))
  {
  }
  TableReader reader(cells, separator == ';');
  if (!reader.Check(error))
  {
    error += ".";
    return false;
  }
  while (rows.Next(cells) && !rows.IsCutOff())
  {
    if (!IsEmptyRow(cells) && !reader.ReadRow(cells, error))
    {
      error = InLine(rows.GetLine()) + error + ".";
      return false;
    }
  }
  if (rows.IsCutOff())
  {
    error = InLine(rows.GetLine()) +
      "a quote is opened and never closed. Close it, or check that the file is complete.";
    return false;
  }
  for (Measurement& measurement : reader.Measurements)
  {
    if (std::none_of(measurement.Samples.begin(), measurement.Samples.end(), IsKnown))
    {
      measurement.Samples.clear();
    }
  }
  measurements = std::move(reader.Measurements);
  return true;
}

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

FileKind DetectFileKind(const std::string& file)
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
  const FileKind kind = DetectFileKind(file);
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
  const FileKind kind = DetectFileKind(file);
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
