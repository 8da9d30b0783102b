// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Setup/HapticSetupLabels.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHapticLabelTable.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace VolumeHaptics
{
namespace
{

struct LabelNumber
{
  const char* Name;
  void (vtkHapticLabelTable::*Set)(int, double);
  double (vtkHapticLabelTable::*Get)(int); ///< returns -1 if not set
};

const LabelNumber LabelNumbers[] = {
  { "Stiffness", &vtkHapticLabelTable::SetStiffness, &vtkHapticLabelTable::GetStiffness },
  { "Friction", &vtkHapticLabelTable::SetFriction, &vtkHapticLabelTable::GetFriction },
  { "Viscosity", &vtkHapticLabelTable::SetViscosity, &vtkHapticLabelTable::GetViscosity },
  { "SurfaceStrength", &vtkHapticLabelTable::SetSurfaceStrength,
    &vtkHapticLabelTable::GetSurfaceStrength },
  { "ShaftFriction", &vtkHapticLabelTable::SetShaftFriction,
    &vtkHapticLabelTable::GetShaftFriction },
  { "SpecificEnergy", &vtkHapticLabelTable::SetSpecificEnergy,
    &vtkHapticLabelTable::GetSpecificEnergy },
};

/** Whether a text is a label as std::to_string writes it. */
bool ReadLabel(const std::string& text, int& label)
{
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, label);
  return error == std::errc() && stop == end && std::to_string(label) == text;
}

/** Passes the settings of a label; writing leaves out those that are not set. */
void PassLabel(
  SetupNode row, int label, vtkHapticLabelTable* table, bool hasFelt, bool hasForbidden)
{
  row.Text(
    "Name", [=] { return table->GetLabelName(label); },
    [=](const std::string& name) { table->SetLabelName(label, name); });
  if (!row.IsWriting() || table->HasColor(label))
  {
    const NumberRow color = row.Row(
      "Color", 3,
      [=]
      {
        const double* const c = table->GetColor(label);
        return NumberRow(c, c + 3);
      },
      [=](const NumberRow& c) { table->SetColor(label, c.data()); });
    row.Require("Color",
      std::all_of(color.begin(), color.end(), [](double c) { return c >= 0.0 && c <= 1.0; }),
      "red, green and blue from 0 to 1");
  }
  for (const LabelNumber& number : LabelNumbers)
  {
    if (!row.IsWriting() || (table->*number.Get)(label) >= 0.0)
    {
      row.Number(
        number.Name, NotNegative(), [=, get = number.Get] { return (table->*get)(label); },
        [=, set = number.Set](double value) { (table->*set)(label, value); });
    }
  }
  if (!row.IsWriting() || hasFelt)
  {
    row.Flag(
      "Felt", [=] { return table->GetFelt(label); },
      [=](bool felt) { table->SetFelt(label, felt); });
  }
  if (!row.IsWriting() || hasForbidden)
  {
    row.Flag(
      "Forbidden", [=] { return table->GetForbidden(label); },
      [=](bool forbidden) { table->SetForbidden(label, forbidden); });
  }
}

void WriteTable(SetupNode node, vtkHapticLabelTable* table)
{
  // The field data show which flags are set: -1 stands for one that is not.
  vtkNew<vtkFieldData> data;
  table->WriteFieldData(data);
  vtkDataArray* const felt = data->GetArray("LabelFelt");
  vtkDataArray* const forbidden = data->GetArray("LabelForbidden");
  for (vtkIdType i = 0; i < table->GetNumberOfLabels(); ++i)
  {
    const int label = table->GetLabel(i);
    PassLabel(node.Child(std::to_string(label)), label, table, felt && felt->GetTuple1(i) >= 0.0,
      forbidden && forbidden->GetTuple1(i) >= 0.0);
  }
}

void ReadTable(SetupNode node, vtkHapticLabelTable* table)
{
  for (const std::string& key : node.GetKeys())
  {
    int label = 0;
    node.Require(key.c_str(), ReadLabel(key, label),
      "called by its label, a whole number from " +
        std::to_string(std::numeric_limits<int>::min()) + " to " +
        std::to_string(std::numeric_limits<int>::max()));
    node.Then([=] { table->SetLabelName(label, table->GetLabelName(label)); }); // creates the entry
    PassLabel(node.Child(key), label, table, false, false);
  }
}

} // namespace

//------------------------------------------------------------------------------
void PassLabels(SetupNode& haptics, vtkVolumeHapticsFilter* filter)
{
  if (haptics.IsWriting() ? !filter->GetLabelTable() : !haptics.Has("Labels"))
  {
    return;
  }
  SetupNode node = haptics.Child("Labels");
  const vtkSmartPointer<vtkHapticLabelTable> table = haptics.IsWriting()
    ? vtkSmartPointer<vtkHapticLabelTable>(filter->GetLabelTable())
    : vtkSmartPointer<vtkHapticLabelTable>::New();
  node.Then([=] { table->DeepCopy(filter->GetLabelTable()); });
  node.Number(
    "StandOff", NotNegative(), [=] { return table->GetStandOff(); },
    [=](double distance) { table->SetStandOff(distance); });
  if (haptics.IsWriting())
  {
    WriteTable(node.Child("Table"), table);
  }
  else if (node.Has("Table"))
  {
    node.Then([=] { table->RemoveAllLabels(); });
    ReadTable(node.Child("Table"), table);
  }
  // Compares at once, so that a table that is already equal is not modified.
  node.Then(
    [=]
    {
      if (!filter->GetLabelTable())
      {
        filter->SetLabelTable(vtkNew<vtkHapticLabelTable>());
      }
      filter->GetLabelTable()->DeepCopy(table);
    });
}

} // namespace VolumeHaptics
