// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticMeasurements.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Material/Labels/LabelText.h"
#include "VTK/Measure/HapticMeasurementSettings.h"
#include "VTK/Measure/MarkupsJson.h"
#include "VTK/Measure/Measurement.h"
#include "VTK/Measure/MeasurementFiles.h"
#include "VTK/Measure/MeasurementPolyData.h"
#include "VTK/Measure/MeasurementUnits.h"
#include "VTK/Measure/PaintedPatch.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHapticMeasurements);

using namespace VolumeHaptics;

namespace
{

constexpr std::size_t MostUndone = 100;

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticMeasurements::vtkInternals
{
  /**
   * A list of immutable measurements. Successive lists share the items that they have in common.
   */
  using Item = std::shared_ptr<const Measurement>;
  using List = std::vector<Item>;

  List Items;
  std::vector<List> Before; ///< earlier lists for Undo, latest last
  std::vector<List> After;  ///< later lists for Redo
  Measurement Unfinished;   ///< measurement in progress; without points if there is none

  void Change(List items)
  {
    this->Before.push_back(std::exchange(this->Items, std::move(items)));
    if (this->Before.size() > MostUndone)
    {
      this->Before.erase(this->Before.begin());
    }
    this->After.clear();
  }

  bool Has(vtkIdType index) const
  {
    return index >= 0 && index < static_cast<vtkIdType>(this->Items.size());
  }
  const Measurement& Get(vtkIdType index) const
  {
    return *this->Items[static_cast<std::size_t>(index)];
  }
  std::vector<Measurement> Copy() const
  {
    std::vector<Measurement> all;
    std::transform(this->Items.begin(), this->Items.end(), std::back_inserter(all),
      [](const Item& item) { return *item; });
    return all;
  }
  /** Appends a measurement. Returns its index, or -1 after an error. */
  vtkIdType Append(vtkHapticMeasurements* self, Measurement added, const char* name)
  {
    const std::string fault = DetectFault(added);
    if (!fault.empty())
    {
      vtkErrorWithObjectMacro(self, << "The measurement can't be added: " << fault << ".");
      return -1;
    }
    added.Name = name && *name ? MakeLabelName(name) : this->FindName(added.Kind);
    List items = this->Items;
    items.push_back(std::make_shared<const Measurement>(std::move(added)));
    this->Change(std::move(items));
    self->Modified();
    return static_cast<vtkIdType>(this->Items.size()) - 1;
  }
  /**
   * Replaces the list with the measurements of a file or polydata. Returns false after an error.
   */
  bool Replace(vtkHapticMeasurements* self, std::vector<Measurement> all, const std::string& what)
  {
    List items;
    for (Measurement& measurement : all)
    {
      const std::string fault = DetectFault(measurement);
      if (!fault.empty())
      {
        vtkErrorWithObjectMacro(self, << what << " can't be read: measurement " << items.size() + 1
                                      << ", " << Quote(measurement.Name) << ": " << fault << ".");
        return false;
      }
      if (measurement.Name.empty())
      {
        this->Items.swap(items);
        measurement.Name = this->FindName(measurement.Kind);
        this->Items.swap(items);
      }
      items.push_back(std::make_shared<const Measurement>(std::move(measurement)));
    }
    this->Change(std::move(items));
    self->Modified();
    return true;
  }
  std::string FindName(MeasuredKind kind) const
  {
    for (int number = 1;; ++number)
    {
      const std::string name =
        std::string(VolumeHaptics::GetKindName(kind)) + " " + std::to_string(number);
      if (std::none_of(this->Items.begin(), this->Items.end(),
            [&name](const Item& item) { return item->Name == name; }))
      {
        return name;
      }
    }
  }
};

// Returns `result` from the function, after reporting an error, if no measurement has this index.
#define vtkHapticMeasurementMacro(index, result)                                   \
  if (!this->Internals->Has(index))                                                \
  {                                                                                \
    vtkErrorMacro("There is no measurement " << (index) << ": there are "          \
                                             << this->Internals->Items.size()      \
                                             << ". Count from 0, up to "           \
                                                "GetNumberOfMeasurements() - 1."); \
    return result;                                                                 \
  }

//------------------------------------------------------------------------------
vtkHapticMeasurements::vtkHapticMeasurements()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkHapticMeasurements::~vtkHapticMeasurements() = default;

//------------------------------------------------------------------------------
vtkIdType vtkHapticMeasurements::AddPoint(const double x[3], const char* name)
{
  Measurement added;
  added.Points = { FromArray(x) };
  return this->Internals->Append(this, std::move(added), name);
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticMeasurements::AddDistance(const double a[3], const double b[3], const char* name)
{
  Measurement added;
  added.Kind = MeasuredKind::Distance;
  added.Points = { FromArray(a), FromArray(b) };
  return this->Internals->Append(this, std::move(added), name);
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticMeasurements::AddAngle(
  const double a[3], const double corner[3], const double b[3], const char* name)
{
  Measurement added;
  added.Kind = MeasuredKind::Angle;
  added.Points = { FromArray(a), FromArray(corner), FromArray(b) };
  return this->Internals->Append(this, std::move(added), name);
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticMeasurements::AddMeasurement(int kind, vtkPolyData* shape, const char* name)
{
  if (kind < POINT || kind > AREA)
  {
    vtkErrorMacro("There is no kind of measurement " << kind << ": use POINT (0) to AREA (4).");
    return -1;
  }
  if (!shape)
  {
    vtkErrorMacro("There is no shape to measure: give a vtkPolyData.");
    return -1;
  }
  return this->Internals->Append(this, ReadShape(static_cast<MeasuredKind>(kind), shape), name);
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticMeasurements::AddPaintedArea(
  vtkImageData* image, double isoValue, vtkPolyData* path, double radius, const char* name)
{
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || image->GetDataDimension() != 3)
  {
    vtkErrorMacro("There is no surface to paint: give a 3D image with point scalars.");
    return -1;
  }
  if (!path || !(radius > 0.0) || !std::isfinite(radius))
  {
    vtkErrorMacro("There is no path, or the radius " << radius << " is not above 0. Give both.");
    return -1;
  }
  PaintedPatch patch(image, scalars, 0, isoValue, radius);
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    patch.LeadTo(FromArray(path->GetPoint(i)));
  }
  const vtkSmartPointer<vtkPolyData> painted = patch.Cut();
  if (painted->GetNumberOfPolys() == 0)
  {
    vtkErrorMacro("The path is nowhere within the radius ("
      << radius << ") plus three voxels of the isosurface at " << isoValue
      << ". Give a path along it, another value, or a larger radius.");
    return -1;
  }
  return this->AddMeasurement(AREA, painted, name);
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticMeasurements::GetNumberOfMeasurements()
{
  return static_cast<vtkIdType>(this->Internals->Items.size());
}

//------------------------------------------------------------------------------
int vtkHapticMeasurements::GetKind(vtkIdType index)
{
  vtkHapticMeasurementMacro(index, POINT);
  return static_cast<int>(this->Internals->Get(index).Kind);
}

//------------------------------------------------------------------------------
const char* vtkHapticMeasurements::GetKindName(int kind)
{
  return kind >= POINT && kind <= AREA ? VolumeHaptics::GetKindName(static_cast<MeasuredKind>(kind))
                                       : "";
}

//------------------------------------------------------------------------------
std::string vtkHapticMeasurements::GetName(vtkIdType index)
{
  vtkHapticMeasurementMacro(index, std::string());
  return this->Internals->Get(index).Name;
}

//------------------------------------------------------------------------------
bool vtkHapticMeasurements::SetName(vtkIdType index, const char* name)
{
  auto& d = *this->Internals;
  vtkHapticMeasurementMacro(index, false);
  const std::string text = name ? MakeLabelName(name) : std::string();
  if (text != d.Get(index).Name)
  {
    auto renamed = std::make_shared<Measurement>(d.Get(index));
    renamed->Name = text;
    vtkInternals::List items = d.Items;
    items[static_cast<std::size_t>(index)] = std::move(renamed);
    d.Change(std::move(items));
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticMeasurements::Remove(vtkIdType index)
{
  auto& d = *this->Internals;
  vtkHapticMeasurementMacro(index, false);
  vtkInternals::List items = d.Items;
  items.erase(items.begin() + index);
  d.Change(std::move(items));
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurements::RemoveAll()
{
  if (!this->Internals->Items.empty())
  {
    this->Internals->Change({});
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkHapticMeasurements::GetValue(vtkIdType index)
{
  vtkHapticMeasurementMacro(index, 0.0);
  return VolumeHaptics::GetValue(this->Internals->Get(index), this->MetersPerWorldUnit);
}

//------------------------------------------------------------------------------
std::string vtkHapticMeasurements::GetUnit(vtkIdType index)
{
  vtkHapticMeasurementMacro(index, std::string());
  return VolumeHaptics::GetUnit(this->Internals->Get(index).Kind, this->MetersPerWorldUnit);
}

//------------------------------------------------------------------------------
std::string vtkHapticMeasurements::GetText(vtkIdType index)
{
  vtkHapticMeasurementMacro(index, std::string());
  const Measurement& measurement = this->Internals->Get(index);
  const std::string value = DescribeValue(measurement, this->MetersPerWorldUnit);
  return measurement.Name + (value.empty() ? "" : ": " + value);
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticMeasurements::GetNumberOfPoints(vtkIdType index)
{
  vtkHapticMeasurementMacro(index, 0);
  return static_cast<vtkIdType>(this->Internals->Get(index).Points.size());
}

//------------------------------------------------------------------------------
void vtkHapticMeasurements::GetPoint(vtkIdType index, vtkIdType point, double x[3])
{
  std::fill_n(x, 3, 0.0);
  vtkHapticMeasurementMacro(index, );
  const std::vector<Vector3>& points = this->Internals->Get(index).Points;
  if (point < 0 || point >= static_cast<vtkIdType>(points.size()))
  {
    vtkErrorMacro("There is no point " << point << " in measurement " << index << ": there are "
                                       << points.size() << ". Count from 0.");
    return;
  }
  const Vector3& p = points[static_cast<std::size_t>(point)];
  x[0] = p.X;
  x[1] = p.Y;
  x[2] = p.Z;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurements::GetShape(vtkIdType index, vtkPolyData* shape)
{
  vtkHapticMeasurementMacro(index, );
  if (shape)
  {
    CopyShape(this->Internals->Get(index), shape);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticMeasurements::Undo()
{
  auto& d = *this->Internals;
  if (d.Before.empty())
  {
    return false;
  }
  d.After.push_back(std::exchange(d.Items, std::move(d.Before.back())));
  d.Before.pop_back();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticMeasurements::Redo()
{
  auto& d = *this->Internals;
  if (d.After.empty())
  {
    return false;
  }
  d.Before.push_back(std::exchange(d.Items, std::move(d.After.back())));
  d.After.pop_back();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurements::SetUnfinished(int kind, vtkPolyData* shape)
{
  auto& d = *this->Internals;
  const bool isThere = shape && kind >= POINT && kind <= AREA;
  if (isThere || !d.Unfinished.Points.empty())
  {
    d.Unfinished = isThere ? ReadShape(static_cast<MeasuredKind>(kind), shape) : Measurement();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticMeasurements::GetUnfinished(vtkPolyData* shape)
{
  if (shape)
  {
    CopyShape(this->Internals->Unfinished, shape);
  }
}

//------------------------------------------------------------------------------
int vtkHapticMeasurements::GetUnfinishedKind()
{
  return static_cast<int>(this->Internals->Unfinished.Kind);
}

//------------------------------------------------------------------------------
std::string vtkHapticMeasurements::GetUnfinishedText()
{
  const Measurement& begun = this->Internals->Unfinished;
  if (begun.Points.empty())
  {
    return {};
  }
  const std::string name = VolumeHaptics::GetKindName(begun.Kind);
  const int wanted = CountPoints(begun.Kind);
  return name + ": " +
    (wanted > 0 ? std::to_string(begun.Points.size()) + " of " + std::to_string(wanted) + " points"
                : DescribeValue(begun, this->MetersPerWorldUnit) + " so far");
}

//------------------------------------------------------------------------------
void vtkHapticMeasurements::CopyToPolyData(vtkPolyData* data)
{
  if (data)
  {
    VolumeHaptics::CopyToPolyData(this->Internals->Copy(), this->MetersPerWorldUnit, data);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticMeasurements::ReadPolyData(vtkPolyData* data)
{
  std::vector<Measurement> all;
  std::string error = "there is none. Give a vtkPolyData.";
  if (!data || !VolumeHaptics::ReadPolyData(data, all, error))
  {
    vtkErrorMacro("The polydata has no measurements: " << error);
    return false;
  }
  return this->Internals->Replace(this, std::move(all), "The polydata");
}

//------------------------------------------------------------------------------
bool vtkHapticMeasurements::WriteFile(const char* path)
{
  const MarkupsFrame frame{ this->MetersPerWorldUnit, this->CoordinateSystem == RAS };
  const std::string file = path ? path : "";
  std::string error;
  if (!WriteMeasurements(file, this->Internals->Copy(), frame, error))
  {
    vtkErrorMacro("The measurements can't be written to \"" << Printable(file) << "\": " << error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticMeasurements::ReadFile(const char* path)
{
  const MarkupsFrame frame{ this->MetersPerWorldUnit, this->CoordinateSystem == RAS };
  const std::string file = path ? path : "";
  const std::string name = "\"" + Printable(file) + "\"";
  std::vector<Measurement> all;
  std::string notes;
  std::string error;
  if (!ReadMeasurements(file, frame, all, notes, error))
  {
    vtkErrorMacro("No measurements can be read from " << name << ": " << Printable(error));
    return false;
  }
  if (!notes.empty())
  {
    vtkWarningMacro("Not all of " << name << " are measurements. " << Printable(notes));
  }
  return this->Internals->Replace(this, std::move(all), "The file " + name);
}

//------------------------------------------------------------------------------
void vtkHapticMeasurements::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  PrintSettings(os, indent, this, MeasurementSettings);
  os << indent << "Measurements: " << this->GetNumberOfMeasurements() << "\n";
  for (vtkIdType i = 0; i < this->GetNumberOfMeasurements(); ++i)
  {
    os << indent.GetNextIndent() << this->GetText(i) << "\n";
  }
}
