// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticLabelTable.h"

#include "Core/Platform/FileReplacement.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/XmlFiles.h"
#include "VTK/Material/Labels/CsvLabels.h"
#include "VTK/Material/Labels/LabelEntry.h"
#include "VTK/Material/Labels/LabelFieldData.h"
#include "VTK/Material/Labels/LabelFiles.h"
#include "VTK/Material/Labels/LabelText.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHapticLabelTable);

using VolumeHaptics::LabelEntries;
using VolumeHaptics::LabelEntry;

//------------------------------------------------------------------------------
class vtkHapticLabelTable::vtkInternals
{
public:
  LabelEntries Entries;
  /** Labels in ascending order; valid while IsListed. */
  std::vector<int> Labels;
  bool IsListed = false;

  /**
   * Finds the entry of a label. Tries the last found entry and the next one first, because callers
   * mostly read one label after another.
   */
  const LabelEntry* Find(int label) const
  {
    const auto end = this->Entries.end();
    if (this->Found != end && this->Found->first < label)
    {
      ++this->Found;
    }
    if (this->Found == end || this->Found->first != label)
    {
      this->Found = this->Entries.find(label);
    }
    return this->Found == end ? nullptr : &this->Found->second;
  }

  /** Invalidates the list and the last found entry. Call this when entries are removed. */
  void Forget()
  {
    this->Found = this->Entries.end();
    this->IsListed = false;
  }

  /** Sets a member of an entry, which is created if necessary. Returns whether it changed. */
  template <typename Value>
  bool Change(int label, std::optional<Value> LabelEntry::*member, const Value& value)
  {
    const auto [entry, isNew] = this->Entries.try_emplace(label);
    this->IsListed = this->IsListed && !isNew;
    if (entry->second.*member == value)
    {
      return false;
    }
    entry->second.*member = value;
    return true;
  }

  /** Copies all members that are set in the given entries. Returns whether anything changed. */
  bool Merge(LabelEntries&& entries)
  {
    bool isChange = false;
    for (auto& [label, from] : entries)
    {
      const auto [entry, isNew] = this->Entries.try_emplace(label);
      LabelEntry merged = entry->second;
      const auto take = [&merged, &source = from](auto member)
      {
        if (source.*member)
        {
          merged.*member = std::move(source.*member);
        }
      };
      take(&LabelEntry::Name);
      take(&LabelEntry::Color);
      take(&LabelEntry::Stiffness);
      take(&LabelEntry::Friction);
      take(&LabelEntry::Viscosity);
      take(&LabelEntry::SurfaceStrength);
      take(&LabelEntry::ShaftFriction);
      take(&LabelEntry::SpecificEnergy);
      take(&LabelEntry::Felt);
      take(&LabelEntry::Forbidden);
      isChange = isChange || isNew || !(merged == entry->second);
      this->IsListed = this->IsListed && !isNew;
      entry->second = std::move(merged);
    }
    return isChange;
  }

  template <typename Value>
  Value Get(int label, std::optional<Value> LabelEntry::*member, const Value& otherwise) const
  {
    const LabelEntry* const entry = this->Find(label);
    return entry ? (entry->*member).value_or(otherwise) : otherwise;
  }

private:
  /** Last found entry. */
  mutable LabelEntries::const_iterator Found = this->Entries.end();
};

namespace
{

constexpr std::array<double, 3> MiddleGrey = { 0.5, 0.5, 0.5 };
constexpr double NotSet = -1.0;

/** Reads the field data of a .vti file. */
bool ReadFieldDataOf(const std::string& file, vtkFieldData* data, std::string& error)
{
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    error = "it is no VTK image (.vti), or not all of one. Save an image with the table.";
    return false;
  }
  if (!VolumeHaptics::ReadXmlFile(reader, file) || reader->GetErrorCode() != 0)
  {
    error = "it is damaged. Check that the file is complete.";
    return false;
  }
  data->ShallowCopy(reader->GetOutput()->GetFieldData());
  return true;
}

void PrintEntry(ostream& os, const LabelEntry& entry)
{
  os << (entry.Name ? entry.Name->c_str() : "(no name)");
  if (entry.Color)
  {
    const std::array<double, 3>& color = *entry.Color;
    os << ", colour " << color[0] << " " << color[1] << " " << color[2];
  }
  const auto print = [&os](const char* name, const std::optional<double>& value, const char* unit)
  {
    if (value)
    {
      os << ", " << name << " " << *value << unit;
    }
  };
  print("stiffness", entry.Stiffness, " N/m");
  print("friction", entry.Friction, "");
  print("viscosity", entry.Viscosity, " N");
  print("surface strength", entry.SurfaceStrength, " N");
  print("shaft friction", entry.ShaftFriction, " N/m");
  print("specific energy", entry.SpecificEnergy, " J/mm^3");
  os << (entry.Felt.value_or(true) ? "" : ", not felt")
     << (entry.Forbidden.value_or(false) ? ", forbidden" : "") << "\n";
}

} // namespace

//------------------------------------------------------------------------------
vtkHapticLabelTable::vtkHapticLabelTable()
  : Internals(std::make_unique<vtkInternals>())
{
}

//------------------------------------------------------------------------------
vtkHapticLabelTable::~vtkHapticLabelTable() = default;

//------------------------------------------------------------------------------
#define vtkHapticLabelTableMaterialMacro(name, member, text, unit)                    \
  void vtkHapticLabelTable::Set##name(int label, double member)                       \
  {                                                                                   \
    if (!std::isfinite(member) || member < 0.0)                                       \
    {                                                                                 \
      vtkErrorMacro(<< "The " text " of label " << label << " can't be " << member    \
                    << ". Give 0 or more" unit                                        \
                       "; RemoveMaterial() lets the transfer functions hold again."); \
      return;                                                                         \
    }                                                                                 \
    if (this->Internals->Change(label, &LabelEntry::name, member))                    \
    {                                                                                 \
      this->Modified();                                                               \
    }                                                                                 \
  }                                                                                   \
  double vtkHapticLabelTable::Get##name(int label)                                    \
  {                                                                                   \
    return this->Internals->Get(label, &LabelEntry::name, NotSet);                    \
  }

vtkHapticLabelTableMaterialMacro(Stiffness, stiffness, "stiffness", " (N/m)");
vtkHapticLabelTableMaterialMacro(Friction, friction, "friction", "");
vtkHapticLabelTableMaterialMacro(Viscosity, viscosity, "viscosity", " (N)");
vtkHapticLabelTableMaterialMacro(SurfaceStrength, strength, "surface strength", " (N)");
vtkHapticLabelTableMaterialMacro(ShaftFriction, friction, "shaft friction", " (N/m)");
vtkHapticLabelTableMaterialMacro(SpecificEnergy, energy, "specific energy", " (J/mm^3)");

//------------------------------------------------------------------------------
void vtkHapticLabelTable::RemoveMaterial(int label)
{
  if (this->HasMaterial(label))
  {
    LabelEntry& entry = this->Internals->Entries[label];
    entry.Stiffness.reset();
    entry.Friction.reset();
    entry.Viscosity.reset();
    entry.SurfaceStrength.reset();
    entry.ShaftFriction.reset();
    entry.SpecificEnergy.reset();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::HasMaterial(int label)
{
  const LabelEntry* const entry = this->Internals->Find(label);
  return entry &&
    (entry->Stiffness || entry->Friction || entry->Viscosity || entry->SurfaceStrength ||
      entry->ShaftFriction || entry->SpecificEnergy);
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::SetLabelName(int label, const std::string& name)
{
  if (this->Internals->Change(label, &LabelEntry::Name, VolumeHaptics::MakeLabelName(name)))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkHapticLabelTable::GetLabelName(int label)
{
  return this->Internals->Get(label, &LabelEntry::Name, std::string());
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::SetColor(int label, double red, double green, double blue)
{
  const std::array<double, 3> color = { red, green, blue };
  // The comparison also refuses NaN.
  if (!std::all_of(color.begin(), color.end(), [](double c) { return c >= 0.0 && c <= 1.0; }))
  {
    vtkErrorMacro(<< "The colour of label " << label << " can't be " << red << ", " << green << ", "
                  << blue << ". Give red, green and blue from 0 to 1.");
    return;
  }
  if (this->Internals->Change(label, &LabelEntry::Color, color))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::SetColor(int label, const double color[3])
{
  this->SetColor(label, color[0], color[1], color[2]);
}

//------------------------------------------------------------------------------
const double* vtkHapticLabelTable::GetColor(int label)
{
  const LabelEntry* const entry = this->Internals->Find(label);
  return entry && entry->Color ? entry->Color->data() : MiddleGrey.data();
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::GetColor(int label, double color[3])
{
  std::copy_n(this->GetColor(label), 3, color);
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::HasColor(int label)
{
  const LabelEntry* const entry = this->Internals->Find(label);
  return entry && entry->Color;
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::SetFelt(int label, bool felt)
{
  if (this->Internals->Change(label, &LabelEntry::Felt, felt))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::GetFelt(int label)
{
  return this->Internals->Get(label, &LabelEntry::Felt, true);
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::SetForbidden(int label, bool forbidden)
{
  if (this->Internals->Change(label, &LabelEntry::Forbidden, forbidden))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::GetForbidden(int label)
{
  return this->Internals->Get(label, &LabelEntry::Forbidden, false);
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::SetStandOff(double distance)
{
  if (!std::isfinite(distance) || distance < 0.0)
  {
    vtkErrorMacro(<< "The stand-off from forbidden labels can't be " << distance
                  << ". Give 0 or more (world units).");
  }
  else if (this->StandOff != distance)
  {
    this->StandOff = distance;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticLabelTable::GetNumberOfLabels()
{
  return static_cast<vtkIdType>(this->Internals->Entries.size());
}

//------------------------------------------------------------------------------
int vtkHapticLabelTable::GetLabel(vtkIdType index)
{
  if (index < 0 || index >= this->GetNumberOfLabels())
  {
    vtkErrorMacro(<< "There is no label with the index " << index << " in a table of "
                  << this->GetNumberOfLabels() << " labels.");
    return 0;
  }
  if (!this->Internals->IsListed)
  {
    this->Internals->Labels.clear();
    this->Internals->Labels.reserve(this->Internals->Entries.size());
    for (const auto& [label, entry] : this->Internals->Entries)
    {
      this->Internals->Labels.push_back(label);
    }
    this->Internals->IsListed = true;
  }
  return this->Internals->Labels[static_cast<std::size_t>(index)];
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::HasLabel(int label)
{
  return this->Internals->Find(label) != nullptr;
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::RemoveLabel(int label)
{
  if (this->Internals->Entries.erase(label) > 0)
  {
    this->Internals->Forget();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::RemoveAllLabels()
{
  if (!this->Internals->Entries.empty())
  {
    this->Internals->Entries.clear();
    this->Internals->Forget();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::ReadFile(const char* path)
{
  const std::string file = path ? path : "";
  if (file.empty())
  {
    vtkErrorMacro("There is no file to read labels from: its name is empty.");
    return false;
  }
  LabelEntries entries;
  std::optional<double> standOff;
  std::string bytes;
  std::string error;
  bool isGood = VolumeHaptics::ReadLabelBytes(file, bytes, error);
  if (isGood && VolumeHaptics::IsVtkFile(bytes))
  {
    vtkNew<vtkFieldData> data;
    isGood = ReadFieldDataOf(file, data, error) &&
      VolumeHaptics::ReadLabelFieldData(data, entries, standOff, error);
  }
  else
  {
    isGood = isGood && VolumeHaptics::ReadLabels(bytes, entries, error);
  }
  if (!isGood)
  {
    vtkErrorMacro(<< "No labels can be read from " << VolumeHaptics::Printable(file) << ": "
                  << error);
    return false;
  }
  this->SetStandOff(standOff.value_or(this->StandOff));
  if (this->Internals->Merge(std::move(entries)))
  {
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::WriteFile(const char* path)
{
  VolumeHaptics::FileReplacement file;
  std::string error = "its name is empty.";
  const std::string name = path ? path : "";
  bool isGood =
    !name.empty() && VolumeHaptics::CheckWritable(name, error) && file.Open(name, error);
  if (isGood)
  {
    file.Write(VolumeHaptics::WriteCsv(this->Internals->Entries));
    isGood = file.Commit(error);
  }
  if (!isGood)
  {
    vtkErrorMacro(<< "No labels can be written to \"" << VolumeHaptics::Printable(name)
                  << "\": " << error);
  }
  return isGood;
}

//------------------------------------------------------------------------------
bool vtkHapticLabelTable::ReadFieldData(vtkFieldData* data)
{
  LabelEntries entries;
  std::optional<double> standOff;
  std::string error;
  if (!VolumeHaptics::ReadLabelFieldData(data, entries, standOff, error))
  {
    vtkErrorMacro(<< "No labels can be read from field data: " << error);
    return false;
  }
  this->SetStandOff(standOff.value_or(this->StandOff));
  if (this->Internals->Merge(std::move(entries)))
  {
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::WriteFieldData(vtkFieldData* data)
{
  if (!data)
  {
    vtkErrorMacro("There is no field data to write labels to.");
    return;
  }
  VolumeHaptics::WriteLabelFieldData(this->Internals->Entries, this->StandOff, data);
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::DeepCopy(vtkHapticLabelTable* source)
{
  if (!source || source == this)
  {
    return;
  }
  this->SetStandOff(source->StandOff);
  if (!(this->Internals->Entries == source->Internals->Entries))
  {
    this->Internals->Entries = source->Internals->Entries;
    this->Internals->Forget();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticLabelTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StandOff: " << this->StandOff << "\n";
  os << indent << "NumberOfLabels: " << this->GetNumberOfLabels() << "\n";
  for (const auto& [label, entry] : this->Internals->Entries)
  {
    os << indent.GetNextIndent() << label << ": ";
    PrintEntry(os, entry);
  }
}
