// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticSetupMaterials.h"

#include "VTK/Base/PassSettings.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Material/HapticSetupFunctions.h"
#include "VTK/Material/HapticTissues.h"

#include "vtkHapticProperty.h"

namespace VolumeHaptics
{
namespace
{

/** Passes an object with a range for each tissue's name. */
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
      return; // the error is reported
    }
    std::string error;
    node.Require(name.c_str(), tissues.Add({ name, range[0], range[1] }, error) >= 0,
      "a range of values, the lower one first, that no other tissue has values of");
  }
  node.Then([get, tissues] { SetTissues(get(), tissues); });
}

} // namespace

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
