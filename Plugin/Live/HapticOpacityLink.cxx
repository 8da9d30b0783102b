// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticOpacityLink.h"

#include "vtkCollection.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeHapticsFilter.h"

#include <string>
#include <vector>

namespace VolumeHapticsLive
{
namespace
{

bool IsOn(vtkSMProxy* proxy, const char* name)
{
  return proxy->GetProperty(name) && vtkSMPropertyHelper(proxy, name, true).GetAsInt() != 0;
}

std::string TextOf(vtkSMProxy* proxy, const char* name)
{
  const char* const text =
    proxy->GetProperty(name) ? vtkSMPropertyHelper(proxy, name, true).GetAsString() : nullptr;
  return text ? text : "";
}

/** Whether the opacity of an array of several components depends on one of them. */
bool ShowsComponent(vtkSMProxy* representation, int component)
{
  vtkSMProxy* const colors = representation->GetProperty("LookupTable")
    ? vtkSMPropertyHelper(representation, "LookupTable", true).GetAsProxy()
    : nullptr;
  return colors && colors->GetProperty("VectorMode") && colors->GetProperty("VectorComponent") &&
    IsOn(representation, "MapScalars") && !IsOn(representation, "MultiComponentsMapping") &&
    vtkSMPropertyHelper(colors, "VectorMode", true).GetAsInt() == vtkScalarsToColors::COMPONENT &&
    vtkSMPropertyHelper(colors, "VectorComponent", true).GetAsInt() == component;
}

bool Shows(vtkSMProxy* representation, vtkVolumeHapticsFilter* filter)
{
  if (!IsOn(representation, "Visibility") || TextOf(representation, "Representation") != "Volume" ||
    IsOn(representation, "UseSeparateOpacityArray") || IsOn(representation, "UseTransfer2D") ||
    !representation->GetProperty("ColorArrayName"))
  {
    return false;
  }
  const vtkSMPropertyHelper color(representation, "ColorArrayName", true);
  const char* const shown = color.GetInputArrayNameToProcess();
  auto* const image = vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0));
  if (!shown || !*shown || !image ||
    color.GetInputArrayAssociation() != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return false;
  }
  const char* const name = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  vtkPointData* const points = image->GetPointData();
  vtkDataArray* const touched = name && *name ? points->GetArray(name) : points->GetScalars();
  return touched && touched->GetName() && std::string(shown) == touched->GetName() &&
    (touched->GetNumberOfComponents() == 1 ||
      ShowsComponent(representation, filter->GetProperty()->GetComponent()));
}

vtkSMProxy* FindRepresentation(vtkSMProxy* view, vtkSMProxy* volume, vtkVolumeHapticsFilter* filter)
{
  const vtkSMPropertyHelper shown(view, "Representations", true);
  for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* const representation = shown.GetAsProxy(i);
    if (representation && representation->GetProperty("Input") &&
      representation->GetProperty("ScalarOpacityFunction") &&
      vtkSMPropertyHelper(representation, "Input", true).GetAsProxy() == volume &&
      Shows(representation, filter))
    {
      return representation;
    }
  }
  return nullptr;
}

vtkPiecewiseFunction* GetOpacity(vtkSMProxy* representation)
{
  vtkSMProxy* const function =
    vtkSMPropertyHelper(representation, "ScalarOpacityFunction", true).GetAsProxy();
  return function ? vtkPiecewiseFunction::SafeDownCast(function->GetClientSideObject()) : nullptr;
}

} // namespace

vtkVolumeProperty* HapticOpacityLink::Find(vtkSMProxy* volume, vtkVolumeHapticsFilter* filter)
{
  this->View = nullptr;
  this->Representation = nullptr;
  vtkSMSessionProxyManager* const manager = volume ? volume->GetSessionProxyManager() : nullptr;
  if (!manager || !filter)
  {
    return nullptr;
  }
  std::vector<vtkSMProxy*> views;
  vtkSMProxySelectionModel* const active = manager->GetSelectionModel("ActiveView");
  if (vtkSMProxy* const view = active ? active->GetCurrentProxy() : nullptr)
  {
    views.push_back(view);
  }
  vtkNew<vtkCollection> others;
  manager->GetProxies("views", others);
  for (int i = 0; i < others->GetNumberOfItems(); ++i)
  {
    views.push_back(vtkSMProxy::SafeDownCast(others->GetItemAsObject(i)));
  }
  for (vtkSMProxy* const view : views)
  {
    vtkSMProxy* const representation = view && view->GetProperty("Representations")
      ? FindRepresentation(view, volume, filter)
      : nullptr;
    if (vtkPiecewiseFunction* const opacity = representation ? GetOpacity(representation) : nullptr)
    {
      this->View = view;
      this->Representation = representation;
      // Use one function for any touched component.
      this->Property->IndependentComponentsOff();
      this->Property->SetScalarOpacity(opacity);
      return this->Property;
    }
  }
  return nullptr;
}

} // namespace VolumeHapticsLive
