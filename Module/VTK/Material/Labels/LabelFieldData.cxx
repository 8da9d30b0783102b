// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/LabelFieldData.h"

#include "VTK/Material/Labels/LabelText.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

constexpr const char* LabelArray = "Label";
constexpr const char* NameArray = "LabelName";
constexpr const char* ColorArray = "LabelColor";
constexpr const char* StandOffArray = "LabelStandOff";
constexpr double Nothing = -1.0;

/** Name of a numeric array, and the member of LabelEntry that it stores. */
struct NumberArray
{
  const char* Name;
  std::optional<double> LabelEntry::*Member;
};
constexpr NumberArray NumberArrays[] = { { "LabelStiffness", &LabelEntry::Stiffness },
  { "LabelFriction", &LabelEntry::Friction }, { "LabelViscosity", &LabelEntry::Viscosity },
  { "LabelSurfaceStrength", &LabelEntry::SurfaceStrength },
  { "LabelShaftFriction", &LabelEntry::ShaftFriction },
  { "LabelSpecificEnergy", &LabelEntry::SpecificEnergy } };
struct FlagArray
{
  const char* Name;
  std::optional<bool> LabelEntry::*Member;
};
constexpr FlagArray FlagArrays[] = { { "LabelFelt", &LabelEntry::Felt },
  { "LabelForbidden", &LabelEntry::Forbidden } };

bool IsNothing(double value)
{
  return value == Nothing || std::isnan(value);
}

std::string In(const char* array, vtkIdType tuple)
{
  return std::string("field data array \"") + array + "\", tuple " + std::to_string(tuple) + ": ";
}

/** Reads the arrays of a field data object and checks their sizes. */
class FieldDataReader
{
public:
  FieldDataReader(vtkFieldData* data, std::string& error)
    : Data(data)
    , Error(error)
  {
  }

  bool Read(LabelEntries& entries, std::optional<double>& standOff)
  {
    vtkDataArray* const labels = this->Data ? this->Data->GetArray(LabelArray) : nullptr;
    if (!labels || labels->GetNumberOfComponents() != 1)
    {
      this->Error = std::string("its field data has no array \"") + LabelArray +
        "\" of one component. Write the table with WriteFieldData().";
      return false;
    }
    this->Count = labels->GetNumberOfTuples();
    std::vector<std::pair<int, LabelEntry>> rows(static_cast<std::size_t>(this->Count));
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      std::string why;
      const std::optional<int> label = ReadLabel(labels->GetVariantValue(i).ToString(), why);
      if (!label)
      {
        this->Error = In(LabelArray, i) + why + ".";
        return false;
      }
      rows[static_cast<std::size_t>(i)].first = *label;
    }
    if (!this->ReadNames(rows) || !this->ReadColors(rows) || !this->ReadNumbers(rows) ||
      !this->ReadStandOff(standOff))
    {
      return false;
    }
    entries.clear();
    for (auto& [label, entry] : rows)
    {
      entries[label] = std::move(entry);
    }
    return true;
  }

private:
  using Rows = std::vector<std::pair<int, LabelEntry>>;

  bool HasSize(vtkAbstractArray* array, int components)
  {
    if (array->GetNumberOfTuples() != this->Count || array->GetNumberOfComponents() != components)
    {
      this->Error = std::string("field data array \"") + array->GetName() + "\" has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples of " +
        std::to_string(array->GetNumberOfComponents()) + ". Give one of " +
        std::to_string(components) + " for each of the " + std::to_string(this->Count) + " labels.";
      return false;
    }
    return true;
  }

  bool ReadNames(Rows& rows)
  {
    auto* const names = vtkStringArray::SafeDownCast(this->Data->GetAbstractArray(NameArray));
    if (!names)
    {
      return true;
    }
    if (!this->HasSize(names, 1))
    {
      return false;
    }
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      const std::string name = names->GetValue(i);
      if (!name.empty())
      {
        rows[static_cast<std::size_t>(i)].second.Name = MakeLabelName(name);
      }
    }
    return true;
  }

  bool ReadColors(Rows& rows)
  {
    vtkDataArray* const colors = this->Data->GetArray(ColorArray);
    if (!colors)
    {
      return true;
    }
    if (!this->HasSize(colors, 3))
    {
      return false;
    }
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      double color[3];
      colors->GetTuple(i, color);
      if (IsNothing(color[0]) && IsNothing(color[1]) && IsNothing(color[2]))
      {
        continue;
      }
      LabelEntry& entry = rows[static_cast<std::size_t>(i)].second;
      entry.Color = MakeColor(color[0], color[1], color[2]);
      if (!entry.Color)
      {
        this->Error =
          In(ColorArray, i) + "a colour is three numbers from 0 to 1, or -1 where there is none.";
        return false;
      }
    }
    return true;
  }

  bool ReadNumbers(Rows& rows)
  {
    for (const NumberArray& array : NumberArrays)
    {
      if (!this->ForEachValue(array.Name, rows,
            [&array](LabelEntry& entry, double value) { entry.*array.Member = value; }))
      {
        return false;
      }
    }
    for (const FlagArray& array : FlagArrays)
    {
      if (!this->ForEachValue(array.Name, rows,
            [&array](LabelEntry& entry, double value) { entry.*array.Member = value != 0.0; }))
      {
        return false;
      }
    }
    return true;
  }

  template <typename Set>
  bool ForEachValue(const char* name, Rows& rows, const Set& set)
  {
    vtkDataArray* const values = this->Data->GetArray(name);
    if (values && !this->HasSize(values, 1))
    {
      return false;
    }
    for (vtkIdType i = 0; values && i < this->Count; ++i)
    {
      const double value = values->GetTuple1(i);
      if (IsNothing(value))
      {
        continue;
      }
      if (!std::isfinite(value) || value < 0.0)
      {
        this->Error = In(name, i) + "the value is " + std::to_string(value) +
          ". Give 0 or more, or -1 to leave it unset.";
        return false;
      }
      set(rows[static_cast<std::size_t>(i)].second, value);
    }
    return true;
  }

  bool ReadStandOff(std::optional<double>& standOff)
  {
    standOff.reset();
    vtkDataArray* const array = this->Data->GetArray(StandOffArray);
    if (!array)
    {
      return true;
    }
    if (array->GetNumberOfValues() == 1)
    {
      standOff = array->GetComponent(0, 0);
    }
    if (!standOff || !std::isfinite(*standOff) || *standOff < 0.0)
    {
      this->Error = std::string("field data array \"") + StandOffArray +
        "\" is not one number, 0 or more (world units).";
      return false;
    }
    return true;
  }

  vtkFieldData* Data;
  std::string& Error;
  vtkIdType Count = 0;
};

} // namespace

bool ReadLabelFieldData(
  vtkFieldData* data, LabelEntries& entries, std::optional<double>& standOff, std::string& error)
{
  return FieldDataReader(data, error).Read(entries, standOff);
}

void WriteLabelFieldData(const LabelEntries& entries, double standOff, vtkFieldData* data)
{
  vtkNew<vtkIntArray> labels;
  labels->SetName(LabelArray);
  vtkNew<vtkStringArray> names;
  names->SetName(NameArray);
  vtkNew<vtkDoubleArray> colors;
  colors->SetName(ColorArray);
  colors->SetNumberOfComponents(3);
  for (const auto& [label, entry] : entries)
  {
    labels->InsertNextValue(label);
    names->InsertNextValue(entry.Name.value_or(""));
    const std::array<double, 3> color =
      entry.Color.value_or(std::array<double, 3>{ Nothing, Nothing, Nothing });
    colors->InsertNextTuple(color.data());
  }
  data->AddArray(labels);
  data->AddArray(names);
  data->AddArray(colors);
  const auto add = [&](const char* name, const auto& member)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(name);
    for (const auto& [label, entry] : entries)
    {
      values->InsertNextValue(entry.*member ? static_cast<double>(*(entry.*member)) : Nothing);
    }
    data->AddArray(values);
  };
  for (const NumberArray& array : NumberArrays)
  {
    add(array.Name, array.Member);
  }
  for (const FlagArray& array : FlagArrays)
  {
    add(array.Name, array.Member);
  }
  vtkNew<vtkDoubleArray> distance;
  distance->SetName(StandOffArray);
  distance->InsertNextValue(standOff);
  data->AddArray(distance);
}

} // namespace VolumeHaptics
