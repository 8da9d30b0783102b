// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticOpacityLink.h"

#include "vtkCollection.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
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
  const char* const touched = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  return shown && *shown && (!touched || !*touched || std::string(shown) == touched);
}

vtkPiecewiseFunction* OpacityIn(
  vtkSMProxy* view, vtkSMProxy* volume, vtkVolumeHapticsFilter* filter)
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
      vtkSMProxy* const function =
        vtkSMPropertyHelper(representation, "ScalarOpacityFunction", true).GetAsProxy();
      return function ? vtkPiecewiseFunction::SafeDownCast(function->GetClientSideObject())
                      : nullptr;
    }
  }
  return nullptr;
}

} // namespace

vtkVolumeProperty* HapticOpacityLink::Find(vtkSMProxy* volume, vtkVolumeHapticsFilter* filter)
{
  this->View = nullptr;
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
    vtkPiecewiseFunction* const opacity =
      view && view->GetProperty("Representations") ? OpacityIn(view, volume, filter) : nullptr;
    if (opacity)
    {
      this->View = view;
      this->Property->SetScalarOpacity(opacity);
      return this->Property;
    }
  }
  return nullptr;
}

} // namespace VolumeHapticsLive
