// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticPipeline.h"

#include "VTK/Scene/Volumes/CTLook.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"
#include "vtkType.h"

#include <QList>
#include <QString>
#include <algorithm>
#include <iterator>
#include <vector>

namespace
{

bool IsNamed(pqPipelineSource* source, const char* name)
{
  return source && source->getProxy() && QString(source->getProxy()->GetXMLName()) == name;
}

pqServerManagerModel* Model()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}

pqPipelineSource* FindUpstream(pqPipelineSource* source, const char* property)
{
  vtkSMProxy* const proxy =
    source ? vtkSMPropertyHelper(source->getProxy(), property, true).GetAsProxy() : nullptr;
  return proxy ? Model()->findItem<pqPipelineSource*>(proxy) : nullptr;
}

pqPipelineSource* FindConsumer(pqPipelineSource* volume)
{
  for (pqPipelineSource* consumer : volume->getAllConsumers())
  {
    if (HapticPipeline::IsTouch(consumer))
    {
      return consumer;
    }
  }
  return nullptr;
}

pqPipelineSource* FindOrMakeTouch(pqPipelineSource* volume)
{
  if (pqPipelineSource* const found = FindConsumer(volume))
  {
    return found;
  }
  pqPipelineSource* const made = pqApplicationCore::instance()->getObjectBuilder()->createFilter(
    "filters", "VolumeHaptics", volume);
  made->getProxy()->UpdateVTKObjects();
  made->setModifiedState(pqProxy::UNMODIFIED);
  return made;
}

/** Returns the device of a filter or, if it has none, another device, but never `except`. */
pqPipelineSource* FindDevice(pqPipelineSource* touch, pqPipelineSource* except = nullptr)
{
  pqPipelineSource* any = nullptr;
  for (pqPipelineSource* source : Model()->findItems<pqPipelineSource*>(touch->getServer()))
  {
    if (HapticPipeline::IsDevice(source) && source != except)
    {
      any = source;
      if (HapticPipeline::GetTouch(source) == touch)
      {
        return source;
      }
    }
  }
  return any;
}

/**
 * Disarms the device, so that the hand does not suddenly feel an object that it has not approached.
 * This can't be undone, and is not traced.
 */
void Disarm(vtkSMProxy* device)
{
  BEGIN_UNDO_EXCLUDE();
  vtkSMPropertyHelper(device, "Armed").Set(0);
  device->UpdateVTKObjects();
  END_UNDO_EXCLUDE();
}

/** Makes a device if there is none, and makes it feel the data of a filter. */
pqPipelineSource* LeadTo(pqPipelineSource* device, pqPipelineSource* touch)
{
  if (device && HapticPipeline::GetTouch(device) != touch)
  {
    Disarm(device->getProxy());
  }
  if (!device)
  {
    device = pqApplicationCore::instance()->getObjectBuilder()->createSource(
      "sources", "HapticDevice", touch->getServer());
    device->setModifiedState(pqProxy::UNMODIFIED);
  }
  if (HapticPipeline::GetTouch(device) != touch)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", device->getProxy());
    vtkSMPropertyHelper(device->getProxy(), "Touch").Set(touch->getProxy());
    device->getProxy()->UpdateVTKObjects();
  }
  return device;
}

} // namespace

namespace HapticPipeline
{

bool IsDevice(pqPipelineSource* source)
{
  return source && vtkSMHapticDeviceProxy::SafeDownCast(source->getProxy());
}

bool IsTouch(pqPipelineSource* source)
{
  return IsNamed(source, "VolumeHaptics");
}

bool IsVolume(pqPipelineSource* source)
{
  pqOutputPort* const port =
    source && source->getNumberOfOutputPorts() > 0 ? source->getOutputPort(0) : nullptr;
  vtkPVDataInformation* const info = port ? port->getDataInformation() : nullptr;
  constexpr int types[] = { VTK_IMAGE_DATA, VTK_UNIFORM_GRID, VTK_RECTILINEAR_GRID,
    VTK_STRUCTURED_GRID, VTK_UNSTRUCTURED_GRID };
  return info &&
    std::any_of(
      std::begin(types), std::end(types), [info](int type) { return info->HasDataSetType(type); });
}

QString ProposePreset(pqPipelineSource* volume)
{
  constexpr double air = -500.0; // HU; a CT of a body has air around it
  constexpr double bone = 300.0; // HU
  vtkPVDataSetAttributesInformation* const points =
    volume->getOutputPort(0)->getDataInformation()->GetPointDataInformation();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* const array = points->GetArrayInformation(i);
    const double* const range = array->GetComponentRange(0);
    if (array->GetNumberOfComponents() == 1)
    {
      return range[0] >= -32768.0 && range[0] <= air && range[1] >= bone ? "CT contrast" : "Custom";
    }
  }
  return "Custom";
}

pqPipelineSource* GetTouch(pqPipelineSource* device)
{
  return FindUpstream(device, "Touch");
}

pqPipelineSource* GetVolume(pqPipelineSource* touch)
{
  return FindUpstream(touch, "Input");
}

pqPipelineSource* FindTouch(pqPipelineSource* source)
{
  return IsTouch(source) ? source
    : IsDevice(source)   ? GetTouch(source)
    : source             ? FindConsumer(source)
                         : nullptr;
}

pqPipelineSource* FindOrMakeDevice(pqPipelineSource* source)
{
  if (IsDevice(source) && GetTouch(source))
  {
    return source;
  }
  if (!IsTouch(source) && !IsVolume(source))
  {
    return nullptr;
  }
  BEGIN_UNDO_SET("Touch");
  pqPipelineSource* const touch = IsTouch(source) ? source : FindOrMakeTouch(source);
  pqPipelineSource* const device = LeadTo(FindDevice(touch), touch);
  END_UNDO_SET();
  return device;
}

pqPipelineSource* FindOrMakeSecondDevice(pqPipelineSource* first)
{
  pqPipelineSource* const touch = GetTouch(first);
  BEGIN_UNDO_SET("Second hand");
  pqPipelineSource* const device = LeadTo(FindDevice(touch, first), touch);
  END_UNDO_SET();
  return device;
}

} // namespace HapticPipeline

namespace
{

pqDataRepresentation* FindShown(pqPipelineSource* volume, pqView* view)
{
  pqOutputPort* const port = volume && view ? volume->getOutputPort(0) : nullptr;
  return port ? port->getRepresentation(view) : nullptr;
}

/**
 * Returns the requested name if the source has such a point array, otherwise the name of the first
 * array; empty if there is none.
 */
std::string FindArray(pqPipelineSource* volume, const QString& wanted)
{
  vtkPVDataInformation* const data = volume->getOutputPort(0)->getDataInformation();
  vtkPVDataSetAttributesInformation* const points =
    data ? data->GetPointDataInformation() : nullptr;
  if (!points || points->GetNumberOfArrays() == 0)
  {
    return {};
  }
  const std::string name = wanted.toStdString();
  return points->GetArrayInformation(name.c_str()) ? name
                                                   : points->GetArrayInformation(0)->GetName();
}

/**
 * Returns the shortest edge of an image's voxel. For other data, returns a fraction of the longest
 * edge of the data's bounds.
 */
double ComputeVoxel(pqPipelineSource* volume)
{
  constexpr double parts = 128.0;
  vtkPVDataInformation* const data = volume->getOutputPort(0)->getDataInformation();
  double bounds[6];
  int extent[6];
  data->GetBounds(bounds);
  data->GetExtent(extent);
  double voxel = 0.0;
  double longest = 0.0;
  for (int a = 0; a < 6; a += 2)
  {
    const double length = bounds[a + 1] - bounds[a];
    const int steps = extent[a + 1] - extent[a];
    const double edge = steps > 0 ? length / steps : 0.0;
    longest = std::max(longest, length);
    voxel = edge > 0.0 && (voxel == 0.0 || edge < voxel) ? edge : voxel;
  }
  return voxel > 0.0 ? voxel : longest > 0.0 ? longest / parts : 1.0;
}

template <typename ElementType>
void SetTraced(vtkSMProxy* proxy, const char* property, const ElementType& elements)
{
  if (proxy && proxy->GetProperty(property))
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    vtkSMPropertyHelper(proxy, property)
      .Set(elements.data(), static_cast<unsigned int>(elements.size()));
    proxy->UpdateVTKObjects();
  }
}

} // namespace

namespace HapticVolumeLook
{

//------------------------------------------------------------------------------
bool IsShown(pqPipelineSource* volume, pqView* view)
{
  pqDataRepresentation* const shown = FindShown(volume, view);
  return shown && shown->isVisible() && shown->getProxy()->GetProperty("Representation") &&
    QString(vtkSMPropertyHelper(shown->getProxy(), "Representation", true).GetAsString()) ==
    "Volume";
}

//------------------------------------------------------------------------------
bool ShowAsCT(pqPipelineSource* volume, pqView* view, const QString& array)
{
  const std::string name = FindArray(volume, array);
  if (name.empty())
  {
    return false;
  }
  BEGIN_UNDO_SET("Show as CT volume");
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  auto* const shown = vtkSMPVRepresentationProxy::SafeDownCast(
    controller->Show(vtkSMSourceProxy::SafeDownCast(volume->getProxy()), 0,
      vtkSMViewProxy::SafeDownCast(view->getProxy())));
  const bool isVolume = shown &&
    shown->SetScalarColoring(name.c_str(), vtkDataObject::FIELD_ASSOCIATION_POINTS) &&
    vtkSMRepresentationProxy::SetRepresentationType(shown, "Volume");
  if (isVolume)
  {
    std::vector<double> colors;
    std::vector<double> opacities;
    for (const VolumeHaptics::LookStop& stop : VolumeHaptics::CTLook)
    {
      colors.insert(colors.end(), { stop.Value, stop.Color[0], stop.Color[1], stop.Color[2] });
      opacities.insert(opacities.end(), { stop.Value, stop.Opacity, 0.5, 0.0 });
    }
    vtkSMProxy* const table = vtkSMPropertyHelper(shown, "LookupTable").GetAsProxy();
    constexpr int never = -1; // ParaView's constant for never rescaling to the range of the data
    SetTraced(table, "AutomaticRescaleRangeMode", std::vector<int>{ never });
    SetTraced(table, "RGBPoints", colors);
    SetTraced(
      vtkSMPropertyHelper(shown, "ScalarOpacityFunction").GetAsProxy(), "Points", opacities);
    SetTraced(shown, "ScalarOpacityUnitDistance",
      std::vector<double>{ VolumeHaptics::LookLayer * ComputeVoxel(volume) });
    SetTraced(shown, "Shade", std::vector<int>{ 1 });
  }
  END_UNDO_SET();
  view->render();
  return isVolume;
}

} // namespace HapticVolumeLook
