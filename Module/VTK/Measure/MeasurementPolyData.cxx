// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/MeasurementPolyData.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Measure/MeasurementUnits.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Names of the arrays: see vtkHapticMeasurements::CopyToPolyData. */
constexpr const char* TimeArray = "Time";
constexpr const char* ForceArray = "Force";
constexpr const char* ValueArray = "SurfaceValue";
constexpr const char* NumberArray = "Measurement";
constexpr const char* NameField = "MeasurementName";
constexpr const char* KindField = "MeasurementKind";

/**
 * Returns whether an array has any finite number. VTK can't read a file with an array that has
 * none.
 */
bool HasNumber(vtkDoubleArray* array)
{
  const double* const begin = array->GetPointer(0);
  return std::any_of(
    begin, begin + array->GetNumberOfValues(), [](double number) { return std::isfinite(number); });
}

/** Builds points and cells, with arrays of the forces and values measured at the points. */
class ShapeMaker
{
public:
  ShapeMaker()
  {
    this->Points->SetDataTypeToDouble();
    this->Times->SetName(TimeArray);
    this->Forces->SetName(ForceArray);
    this->Forces->SetNumberOfComponents(3);
    this->Values->SetName(ValueArray);
  }

  /** Adds a measurement's points without cells. Returns the index of the first point. */
  vtkIdType Add(const Measurement& measurement)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (std::size_t i = 0; i < measurement.Points.size(); ++i)
    {
      const Vector3& p = measurement.Points[i];
      const MeasuredSample sample =
        measurement.Samples.empty() ? MeasuredSample() : measurement.Samples[i];
      this->Points->InsertNextPoint(p.X, p.Y, p.Z);
      this->Times->InsertNextValue(sample.Time);
      this->Forces->InsertNextTuple3(sample.Force.X, sample.Force.Y, sample.Force.Z);
      this->Values->InsertNextValue(sample.SurfaceValue);
    }
    return first;
  }

  ///@{
  /** Add the cells of a measurement whose points start at index `first`. */
  void AddVertex(vtkIdType first) { this->Verts->InsertNextCell(1, &first); }
  void AddLine(const Measurement& measurement, vtkIdType first)
  {
    const auto count = static_cast<vtkIdType>(measurement.Points.size());
    this->Lines->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Lines->InsertCellPoint(first + i);
    }
  }
  void AddTriangles(const Measurement& measurement, vtkIdType first)
  {
    for (const std::array<int, 3>& t : measurement.Triangles)
    {
      this->Polys->InsertNextCell({ first + t[0], first + t[1], first + t[2] });
    }
  }
  ///@}

  void CopyTo(vtkPolyData* shape, bool isFelt)
  {
    shape->Initialize();
    shape->SetPoints(this->Points);
    shape->SetVerts(this->Verts);
    shape->SetLines(this->Lines);
    shape->SetPolys(this->Polys);
    for (vtkDoubleArray* const array :
      { this->Times.Get(), this->Forces.Get(), this->Values.Get() })
    {
      if (isFelt && HasNumber(array))
      {
        shape->GetPointData()->AddArray(array);
      }
    }
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Verts;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Polys;
  vtkNew<vtkDoubleArray> Times;
  vtkNew<vtkDoubleArray> Forces;
  vtkNew<vtkDoubleArray> Values;
};

bool IsVertex(const Measurement& measurement)
{
  return measurement.Points.size() == 1 && measurement.Triangles.empty();
}

/** Returns a point array by its name; null unless it has one tuple per point. */
vtkDataArray* FindArray(vtkPolyData* shape, const char* name, int components)
{
  vtkDataArray* const array = shape->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() >= shape->GetNumberOfPoints()
    ? array
    : nullptr;
}

/** Reads time, force and surface value at the points of a shape from its arrays. */
class ShapeSamples
{
public:
  explicit ShapeSamples(vtkPolyData* shape)
    : Times(FindArray(shape, TimeArray, 1))
    , Forces(FindArray(shape, ForceArray, 3))
    , Values(FindArray(shape, ValueArray, 1))
  {
  }
  bool Any() const { return this->Times || this->Forces || this->Values; }
  MeasuredSample Get(vtkIdType point) const
  {
    MeasuredSample sample;
    sample.Time = this->Times ? this->Times->GetComponent(point, 0) : sample.Time;
    sample.Force = this->Forces ? ReadVector(this->Forces, point) : sample.Force;
    sample.SurfaceValue = this->Values ? this->Values->GetComponent(point, 0) : sample.SurfaceValue;
    return sample;
  }

private:
  vtkDataArray* Times;
  vtkDataArray* Forces;
  vtkDataArray* Values;
};

/** Removes the samples of a measurement if none has a finite number. */
void DropUnknown(Measurement& measurement)
{
  const auto isKnown = [](const MeasuredSample& s)
  { return std::isfinite(s.Time) || IsFinite(s.Force) || std::isfinite(s.SurfaceValue); };
  if (std::none_of(measurement.Samples.begin(), measurement.Samples.end(), isKnown))
  {
    measurement.Samples.clear();
  }
}

void ReadTriangles(vtkPolyData* shape, Measurement& area)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->SetInputData(shape);
  triangles->Update();
  vtkPolyData* const made = triangles->GetOutput();
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    area.Points.push_back(FromArray(made->GetPoint(i)));
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < made->GetNumberOfPolys(); ++i)
  {
    made->GetPolys()->GetCellAtId(i, corners);
    area.Triangles.push_back({ static_cast<int>(corners->GetId(0)),
      static_cast<int>(corners->GetId(1)), static_cast<int>(corners->GetId(2)) });
  }
}

/**
 * Collects the cells of each measurement from the array of measurement numbers. Returns false and
 * sets `error` if the array or a number is unusable.
 */
bool CollectCells(vtkPolyData* all, std::size_t count, std::vector<std::vector<vtkIdType>>& cells,
  std::string& error)
{
  vtkDataArray* const numbers = all->GetCellData()->GetArray(NumberArray);
  if (!numbers || numbers->GetNumberOfComponents() != 1 ||
    numbers->GetNumberOfTuples() < all->GetNumberOfCells())
  {
    error = std::string("it has no cell array \"") + NumberArray + "\" with a number for each cell";
    return false;
  }
  cells.resize(count);
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    const double number = numbers->GetComponent(cell, 0);
    if (!(number >= 0.0) || number >= static_cast<double>(count))
    {
      error =
        "a cell belongs to measurement " + std::to_string(number) + " of " + std::to_string(count);
      return false;
    }
    cells[static_cast<std::size_t>(number)].push_back(cell);
  }
  return true;
}

/** Reads the points of some cells, each shared point only once. */
Measurement ReadCells(vtkPolyData* all, MeasuredKind kind, const std::vector<vtkIdType>& cells)
{
  const ShapeSamples samples(all);
  Measurement read;
  read.Kind = kind;
  std::vector<int> numberOf; // index of each point in the area; -1 if it has none yet
  numberOf.resize(
    kind == MeasuredKind::Area ? static_cast<std::size_t>(all->GetNumberOfPoints()) : 0, -1);
  vtkNew<vtkIdList> points;
  for (const vtkIdType cell : cells)
  {
    all->GetCellPoints(cell, points);
    if (kind != MeasuredKind::Area)
    {
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        read.Points.push_back(FromArray(all->GetPoint(points->GetId(i))));
        read.Samples.push_back(samples.Get(points->GetId(i)));
      }
    }
    else if (points->GetNumberOfIds() == 3)
    {
      std::array<int, 3> triangle{};
      for (int i = 0; i < 3; ++i)
      {
        int& number = numberOf[static_cast<std::size_t>(points->GetId(i))];
        if (number < 0)
        {
          number = static_cast<int>(read.Points.size());
          read.Points.push_back(FromArray(all->GetPoint(points->GetId(i))));
        }
        triangle[static_cast<std::size_t>(i)] = number;
      }
      read.Triangles.push_back(triangle);
    }
  }
  DropUnknown(read);
  return read;
}

/** Returns whether all cells refer to existing points, which VTK's readers do not check. */
bool HasPointsOfCells(vtkPolyData* all)
{
  for (vtkCellArray* const cells :
    { all->GetVerts(), all->GetLines(), all->GetPolys(), all->GetStrips() })
  {
    if (cells->GetNumberOfConnectivityIds() == 0)
    {
      continue;
    }
    double range[2];
    cells->GetConnectivityArray()->GetRange(range);
    if (!cells->IsValid() || range[0] < 0.0 ||
      range[1] >= static_cast<double>(all->GetNumberOfPoints()))
    {
      return false;
    }
  }
  return true;
}

} // namespace

void CopyShape(const Measurement& measurement, vtkPolyData* shape)
{
  ShapeMaker maker;
  maker.Add(measurement);
  if (IsVertex(measurement))
  {
    maker.AddVertex(0);
  }
  else if (measurement.Triangles.empty() && !measurement.Points.empty())
  {
    maker.AddLine(measurement, 0);
  }
  maker.AddTriangles(measurement, 0);
  maker.CopyTo(shape, !measurement.Samples.empty());
}

Measurement ReadShape(MeasuredKind kind, vtkPolyData* shape)
{
  Measurement read;
  read.Kind = kind;
  if (kind == MeasuredKind::Area)
  {
    ReadTriangles(shape, read);
    return read;
  }
  const ShapeSamples samples(shape);
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    read.Points.push_back(FromArray(shape->GetPoint(i)));
    if (samples.Any())
    {
      read.Samples.push_back(samples.Get(i));
    }
  }
  DropUnknown(read);
  return read;
}

void CopyToPolyData(
  const std::vector<Measurement>& measurements, double metersPerWorldUnit, vtkPolyData* all)
{
  ShapeMaker maker;
  vtkNew<vtkStringArray> names;
  vtkNew<vtkStringArray> kinds;
  vtkNew<vtkStringArray> units;
  names->SetName(NameField);
  kinds->SetName(KindField);
  units->SetName("MeasurementUnit");
  vtkNew<vtkDoubleArray> values;
  values->SetName("MeasurementValue");
  std::vector<vtkIdType> firsts;
  for (const Measurement& measurement : measurements)
  {
    firsts.push_back(maker.Add(measurement));
    names->InsertNextValue(measurement.Name);
    kinds->InsertNextValue(GetKindName(measurement.Kind));
    units->InsertNextValue(GetUnit(measurement.Kind, metersPerWorldUnit));
    values->InsertNextValue(GetValue(measurement, metersPerWorldUnit));
  }
  // vtkPolyData numbers its cells by kind: vertices, then lines, then polygons.
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(NumberArray);
  const auto count = static_cast<int>(measurements.size());
  for (int i = 0; i < count; ++i)
  {
    if (IsVertex(measurements[static_cast<std::size_t>(i)]))
    {
      maker.AddVertex(firsts[static_cast<std::size_t>(i)]);
      numbers->InsertNextValue(i);
    }
  }
  for (int i = 0; i < count; ++i)
  {
    const Measurement& measurement = measurements[static_cast<std::size_t>(i)];
    if (!IsVertex(measurement) && measurement.Triangles.empty())
    {
      maker.AddLine(measurement, firsts[static_cast<std::size_t>(i)]);
      numbers->InsertNextValue(i);
    }
  }
  for (int i = 0; i < count; ++i)
  {
    const Measurement& measurement = measurements[static_cast<std::size_t>(i)];
    maker.AddTriangles(measurement, firsts[static_cast<std::size_t>(i)]);
    for (std::size_t t = 0; t < measurement.Triangles.size(); ++t)
    {
      numbers->InsertNextValue(i);
    }
  }
  maker.CopyTo(all, true);
  all->GetCellData()->SetScalars(numbers);
  for (vtkAbstractArray* field :
    std::initializer_list<vtkAbstractArray*>{ names, kinds, values, units })
  {
    all->GetFieldData()->AddArray(field);
  }
}

bool ReadPolyData(vtkPolyData* all, std::vector<Measurement>& measurements, std::string& error)
{
  auto* const names =
    vtkStringArray::SafeDownCast(all->GetFieldData()->GetAbstractArray(NameField));
  auto* const kinds =
    vtkStringArray::SafeDownCast(all->GetFieldData()->GetAbstractArray(KindField));
  const char* const cure = ". Give polydata of vtkHapticMeasurements::CopyToPolyData, as it is.";
  if (!names || !kinds || names->GetNumberOfValues() != kinds->GetNumberOfValues())
  {
    error = std::string("it has no field arrays \"") + NameField + "\" and \"" + KindField +
      "\" with a text for each measurement" + cure;
    return false;
  }
  if (!HasPointsOfCells(all))
  {
    error = std::string("it has cells whose points are not there") + cure;
    return false;
  }
  const auto count = static_cast<std::size_t>(names->GetNumberOfValues());
  std::vector<std::vector<vtkIdType>> cells;
  if (!CollectCells(all, count, cells, error))
  {
    error += cure;
    return false;
  }
  std::vector<Measurement> found;
  for (std::size_t i = 0; i < count; ++i)
  {
    MeasuredKind kind{};
    const std::string name = kinds->GetValue(static_cast<vtkIdType>(i));
    if (!FindKind(name, kind))
    {
      error = "measurement " + std::to_string(i) + " is of the kind \"" + name + "\"" + cure;
      return false;
    }
    found.push_back(ReadCells(all, kind, cells[i]));
    found.back().Name = names->GetValue(static_cast<vtkIdType>(i));
  }
  measurements = std::move(found);
  return true;
}

} // namespace VolumeHaptics
