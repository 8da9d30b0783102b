// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/ScalarLabels.h"

#include "VTK/Material/HapticPropertySettings.h"

#include "vtkDataArray.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"

#include <cmath>
#include <string>

namespace VolumeHaptics
{
namespace
{

/** Returns the value of a function at a scalar, or the constant if the function has no points. */
double FindScalarMaterial(vtkHapticProperty* property, const char* name, double label)
{
  for (const PropertyFunction& rule : PropertyFunctions)
  {
    if (std::string(rule.Name) == name)
    {
      vtkPiecewiseFunction* const function = (property->*rule.Get)();
      return function->GetSize() > 0 ? function->GetValue(property->ScalarToValue(label))
                                     : rule.Default;
    }
  }
  return 0.0;
}

} // namespace

bool FillScalarLabels(
  vtkDataArray* scalars, vtkHapticProperty* property, vtkHapticLabelTable* table)
{
  table->RemoveAllLabels();
  double range[2];
  scalars->GetRange(range, 0);
  constexpr double most = VTK_INT_MAX;
  // The condition is also false for NaN.
  const bool isSpanned = range[0] >= -most && range[1] <= most && range[0] <= range[1] &&
    range[1] - range[0] < MostScalarLabels;
  if (scalars->GetNumberOfComponents() != 1 || !isSpanned)
  {
    return false;
  }
  for (int label = static_cast<int>(std::ceil(range[0])); label <= range[1]; ++label)
  {
    table->SetStiffness(label, FindScalarMaterial(property, "Stiffness", label));
    table->SetFriction(label, FindScalarMaterial(property, "Friction", label));
    table->SetViscosity(label, FindScalarMaterial(property, "Viscosity", label));
    table->SetSurfaceStrength(label, FindScalarMaterial(property, "SurfaceStrength", label));
  }
  return true;
}

} // namespace VolumeHaptics
