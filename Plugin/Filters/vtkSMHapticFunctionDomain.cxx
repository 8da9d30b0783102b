// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMHapticFunctionDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

vtkStandardNewMacro(vtkSMHapticFunctionDomain);

//------------------------------------------------------------------------------
vtkSMHapticFunctionDomain::vtkSMHapticFunctionDomain() = default;

//------------------------------------------------------------------------------
vtkSMHapticFunctionDomain::~vtkSMHapticFunctionDomain() = default;

//------------------------------------------------------------------------------
int vtkSMHapticFunctionDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  element->GetScalarAttribute("initial", &this->Initial);
  return this->Superclass::ReadXMLAttributes(property, element);
}

//------------------------------------------------------------------------------
int vtkSMHapticFunctionDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  vtkSMProxy* const function = this->GetNumberOfProxies() > 0 ? this->GetProxy(0) : nullptr;
  if (function && !vtkSMPropertyHelper(function, "ScalarRangeInitialized").GetAsInt())
  {
    // Points of ParaView's functions have x, y, midpoint and sharpness.
    const double flat[] = { 0.0, this->Initial, 0.5, 0.0, 1.0, this->Initial, 0.5, 0.0 };
    vtkSMPropertyHelper(function, "Points").Set(flat, 8);
    vtkSMPropertyHelper(function, "ScalarRangeInitialized").Set(1);
    function->UpdateVTKObjects();
  }
  return this->Superclass::SetDefaultValues(property, useUncheckedValues);
}

//------------------------------------------------------------------------------
void vtkSMHapticFunctionDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Initial: " << this->Initial << "\n";
}
