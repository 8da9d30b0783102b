// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticPipeline.h"

#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkPVDataInformation.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMTrace.h"
#include "vtkType.h"

#include <QList>

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

pqPipelineSource* FindDevice(pqPipelineSource* touch)
{
  pqPipelineSource* any = nullptr;
  for (pqPipelineSource* source : Model()->findItems<pqPipelineSource*>(touch->getServer()))
  {
    if (HapticPipeline::IsDevice(source))
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
 * Disarms the device: a hand must not suddenly feel something that it was not led to. Can't be
 * undone, and is not traced.
 */
void Disarm(vtkSMProxy* device)
{
  BEGIN_UNDO_EXCLUDE();
  vtkSMPropertyHelper(device, "Armed").Set(0);
  device->UpdateVTKObjects();
  END_UNDO_EXCLUDE();
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
  return info && info->GetDataSetType() == VTK_IMAGE_DATA;
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
  pqPipelineSource* device = FindDevice(touch);
  if (device && GetTouch(device) != touch)
  {
    Disarm(device->getProxy());
  }
  if (!device)
  {
    device = pqApplicationCore::instance()->getObjectBuilder()->createSource(
      "sources", "HapticDevice", touch->getServer());
    device->setModifiedState(pqProxy::UNMODIFIED);
  }
  if (GetTouch(device) != touch)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", device->getProxy());
    vtkSMPropertyHelper(device->getProxy(), "Touch").Set(touch->getProxy());
    device->getProxy()->UpdateVTKObjects();
  }
  END_UNDO_SET();
  return device;
}

} // namespace HapticPipeline
