// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticSetupMaterials.h"

#include "VTK/Base/HapticSetupNode.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Material/HapticTissues.h"

#include "vtkColorTransferFunction.h"
#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"

namespace VolumeHaptics
{
namespace
{

template <typename F>
std::vector<NumberRow> GetNodes(F* function, int size, std::size_t columns)
{
  std::vector<NumberRow> rows(size, NumberRow(columns));
  for (int i = 0; i < size; ++i)
  {
    function->GetNodeValue(i, rows[i].data());
  }
  return rows;
}

/** Replaces all nodes of a function in place, even if two of them have the same position. */
template <typename F, typename A>
void SetNodes(F* function, const std::vector<NumberRow>& rows, A&& add)
{
  const vtkTypeBool allow = function->GetAllowDuplicateScalars();
  function->SetAllowDuplicateScalars(1);
  function->RemoveAllPoints();
  for (const NumberRow& row : rows)
  {
    add(row);
  }
  function->SetAllowDuplicateScalars(allow);
}

template <typename G>
void PassDuplicates(SetupNode& node, const G& get)
{
  node.Flag(
    "AllowDuplicateScalars", [get] { return get()->GetAllowDuplicateScalars() != 0; },
    [get](bool on) { get()->SetAllowDuplicateScalars(on); });
  node.Flag(
    "Clamping", [get] { return get()->GetClamping() != 0; },
    [get](bool on) { get()->SetClamping(on); });
}

constexpr NumberRange Fraction{ 0.0, 1.0 };

/** Reads or writes an object that has a range of values under the name of each tissue. */
void PassTissues(SetupNode& materials, const std::function<vtkHapticProperty*()>& get)
{
  if (!materials.IsWriting() && !materials.Has("Tissues"))
  {
    return;
  }
  SetupNode node = materials.Child("Tissues");
  if (materials.IsWriting())
  {
    vtkHapticProperty* const property = get();
    for (int i = 0; i < property->GetNumberOfTissues(); ++i)
    {
      node.Row(
        property->GetTissueName(i), 2,
        [=]
        {
          NumberRow range(2);
          property->GetTissueRange(i, range.data());
          return range;
        },
        [](const NumberRow&) {});
    }
    return;
  }
  HapticTissues tissues;
  for (const std::string& name : node.GetKeys())
  {
    const NumberRow range = node.Row(
      name.c_str(), 2, [] { return NumberRow(2); }, [](const NumberRow&) {});
    if (range.empty())
    {
      return; // the pass has recorded the error
    }
    std::string error;
    node.Require(name.c_str(), tissues.Add({ name, range[0], range[1] }, error) >= 0,
      "a range of values, the lower one first, that no other tissue has values of");
  }
  node.Then([get, tissues] { SetTissues(get(), tissues); });
}

} // namespace

//------------------------------------------------------------------------------
void PassFunction(
  SetupNode node, const NumberRange& values, const std::function<vtkPiecewiseFunction*()>& get)
{
  PassDuplicates(node, get);
  node.Flag(
    "UseLogScale", [get] { return get()->GetUseLogScale(); },
    [get](bool on) { get()->SetUseLogScale(on); });
  node.Table(
    "Nodes", { AnyNumber(), values, Fraction, Fraction },
    [get] { return GetNodes(get(), get()->GetSize(), 4); },
    [get](const std::vector<NumberRow>& rows)
    {
      vtkPiecewiseFunction* const function = get();
      SetNodes(function, rows,
        [function](const NumberRow& r) { function->AddPoint(r[0], r[1], r[2], r[3]); });
    });
}

//------------------------------------------------------------------------------
void PassColors(SetupNode node, const std::function<vtkColorTransferFunction*()>& get)
{
  PassDuplicates(node, get);
  node.Choice(
    "ColorSpace", { "RGB", "HSV", "Lab", "Diverging", "LabCIEDE2000", "Step" },
    [get] { return get()->GetColorSpace(); }, [get](int space) { get()->SetColorSpace(space); });
  node.Flag(
    "HSVWrap", [get] { return get()->GetHSVWrap() != 0; },
    [get](bool on) { get()->SetHSVWrap(on); });
  node.Choice(
    "Scale", { "Linear", "Log10" }, [get] { return get()->GetScale(); },
    [get](int scale) { get()->SetScale(scale); });
  node.Table(
    "Nodes", { AnyNumber(), Fraction, Fraction, Fraction, Fraction, Fraction },
    [get] { return GetNodes(get(), get()->GetSize(), 6); },
    [get](const std::vector<NumberRow>& rows)
    {
      vtkColorTransferFunction* const function = get();
      SetNodes(function, rows,
        [function](const NumberRow& r)
        { function->AddRGBPoint(r[0], r[1], r[2], r[3], r[4], r[5]); });
    });
}

//------------------------------------------------------------------------------
void PassMaterials(SetupNode node, const std::function<vtkHapticProperty*()>& get)
{
  for (const PropertyFunction& f : PropertyFunctions)
  {
    PassFunction(node.Child(f.Name), { 0.0, f.Maximum },
      [get, getFunction = f.Get] { return (get()->*getFunction)(); });
  }
  PassSettings(node, get(), PropertySettings);
  PassTissues(node, get);
}

} // namespace VolumeHaptics
