// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticController.h"

#include "HapticPipeline.h"
#include "vtkHapticDevice.h"
#include "vtkHapticViewLink.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMHapticViewProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTrace.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVolumeHapticsFilter.h"

#include <QCoreApplication>

//------------------------------------------------------------------------------
HapticController::HapticController(QObject* parent)
  : Superclass(parent)
{
  pqServerManagerModel* const model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::preItemRemoved, this, &HapticController::onItemGoes);
  this->connect(
    model, &pqServerManagerModel::aboutToRemoveServer, this, &HapticController::release);
  this->connect(
    QCoreApplication::instance(), &QCoreApplication::aboutToQuit, this, &HapticController::release);
}

//------------------------------------------------------------------------------
HapticController::~HapticController()
{
  this->release();
}

//------------------------------------------------------------------------------
QList<HapticController::DeviceChoice> HapticController::listDevices()
{
  vtkNew<vtkTable> table;
  vtkHapticDevice::ListDevices(table);
  QList<DeviceChoice> choices;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto text = [&](const char* column)
    { return QString::fromStdString(table->GetValueByName(row, column).ToString()); };
    choices.append({ text("Id"), text("Name"), text("State") });
  }
  return choices;
}

//------------------------------------------------------------------------------
void HapticController::attach(const QString& deviceId)
{
  this->detach();
  pqActiveObjects& active = pqActiveObjects::instance();
  auto* const view = qobject_cast<pqRenderView*>(active.activeView());
  if (!view)
  {
    Q_EMIT this->told(tr("There is no render view to attach to. Click on one, or make one."));
    return;
  }
  pqPipelineSource* const source = active.activeSource();
  pqPipelineSource* const device = HapticPipeline::FindOrMakeDevice(source);
  if (!device)
  {
    Q_EMIT this->told(source
        ? tr("%1 is no image data, so it can't be felt. Select a volume in the pipeline browser "
             "(Apply it first); the filter \"Resample To Image\" makes one of other data.")
            .arg(source->getSMName())
        : tr("Nothing is selected. Open a volume, and select it in the pipeline browser."));
    return;
  }
  active.setActiveSource(source);
  this->Device = vtkSMHapticDeviceProxy::SafeDownCast(device->getProxy());
  const bool isOther =
    deviceId != QString(vtkSMPropertyHelper(this->Device, "Device").GetAsString());
  if (isOther)
  {
    this->change("Running", 0);
    this->set("Device", deviceId);
  }
  this->change("Running", 1);
  if (!this->Device->GetDevice()->IsRunning())
  {
    Q_EMIT this->told(vtkSMPropertyHelper(this->Device, "StatusText").GetAsString());
    this->change("Running", 0);
    return;
  }
  this->View.TakeReference(vtkSMHapticViewProxy::SafeDownCast(
    this->Device->GetSessionProxyManager()->NewProxy("misc", "HapticView")));
  vtkSMPropertyHelper(this->View, "View").Set(view->getProxy());
  vtkSMPropertyHelper(this->View, "Device").Set(this->Device);
  vtkSMPropertyHelper(this->View, "Attached").Set(1);
  this->View->UpdateVTKObjects();
  Q_EMIT this->told(this->View->GetLink()->IsAttached()
      ? QString()
      : tr("The device can't be attached to this view: see the output messages."));
}

//------------------------------------------------------------------------------
void HapticController::detach()
{
  if (this->View)
  {
    vtkSMPropertyHelper(this->View, "Attached").Set(0);
    this->View->UpdateVTKObjects();
    this->View = nullptr;
  }
}

//------------------------------------------------------------------------------
void HapticController::release()
{
  this->detach();
  if (this->Device && this->Device->GetSession())
  {
    this->change("Running", 0);
    this->Device->Shutdown();
  }
  this->Device = nullptr;
}

//------------------------------------------------------------------------------
void HapticController::onItemGoes(pqServerManagerModelItem* item)
{
  auto* const proxy = qobject_cast<pqProxy*>(item);
  vtkSMProxy* const gone = proxy ? proxy->getProxy() : nullptr;
  if (!gone || !this->Device)
  {
    return;
  }
  vtkSMProxy* const touch = vtkSMPropertyHelper(this->Device, "Touch").GetAsProxy();
  vtkSMProxy* const volume =
    touch ? vtkSMPropertyHelper(touch, "Input", true).GetAsProxy() : nullptr;
  if (gone == this->Device || gone == touch || gone == volume)
  {
    this->release();
  }
  else if (this->View && gone == this->View->GetLink()->GetView())
  {
    this->detach();
  }
}

//------------------------------------------------------------------------------
void HapticController::change(const char* property, int value)
{
  if (!this->Device)
  {
    return;
  }
  BEGIN_UNDO_EXCLUDE();
  {
    // Not traced: a user who replays a trace may not have a hand on a device. The changes that Poll
    // shows do not belong into a trace either.
    vtkSMPropertyHelper(this->Device, property).Set(value);
    this->Device->UpdateVTKObjects();
    this->Device->Poll();
  }
  END_UNDO_EXCLUDE();
}

//------------------------------------------------------------------------------
void HapticController::set(const char* property, const QString& value)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->Device.GetPointer());
  vtkSMPropertyHelper(this->Device, property).Set(value.toUtf8().data());
}

//------------------------------------------------------------------------------
void HapticController::setArmed(bool on)
{
  this->change("Armed", on ? 1 : 0);
}

//------------------------------------------------------------------------------
void HapticController::setTouchMode(bool on)
{
  if (this->View)
  {
    vtkSMPropertyHelper(this->View, "TouchMode").Set(on ? 1 : 0);
    this->View->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void HapticController::home()
{
  if (this->Device)
  {
    this->change("Armed", 0);
    this->Device->GetDevice()->Home();
  }
}

//------------------------------------------------------------------------------
void HapticController::record(const QString& file)
{
  if (!file.isEmpty() && this->Device)
  {
    this->set("RecordingFile", file);
  }
  this->change("Recording", file.isEmpty() ? 0 : 1);
}

//------------------------------------------------------------------------------
HapticController::Figures HapticController::look()
{
  Figures figures;
  if (this->View && !this->View->GetLink()->IsAttached())
  {
    Q_EMIT this->told(QString::fromStdString(this->View->GetLink()->GetReason()));
    this->View = nullptr;
  }
  if (!this->Device)
  {
    return figures;
  }
  this->Device->Poll();
  vtkHapticDevice* const device = this->Device->GetDevice();
  const int status = device->GetStatus();
  figures.Attached = this->View != nullptr;
  figures.Armed = status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
  figures.Touches = this->View && this->View->GetLink()->GetTouchMode();
  figures.Recording = vtkSMPropertyHelper(this->Device, "Recording").GetAsInt() != 0;
  figures.IsVirtual = device->GetDeviceId() == "virtual";
  figures.CanHome = device->IsRunning() && !figures.IsVirtual;
  figures.Status = vtkSMPropertyHelper(this->Device, "StatusText").GetAsString();
  figures.Force = vtkMath::Norm(device->GetForce());
  figures.MaximumForce = device->GetMaximumForce();
  figures.TickRate = device->IsRunning() ? device->GetTickRate() : 0.0;
  figures.MissedTicks = device->GetMissedTicks();

  pqServerManagerModel* const model = pqApplicationCore::instance()->getServerManagerModel();
  auto* const touch =
    HapticPipeline::GetTouch(model->findItem<pqPipelineSource*>(this->Device.GetPointer()));
  auto* const volume = HapticPipeline::GetVolume(touch);
  if (touch && volume)
  {
    figures.Felt = tr("%1, as %2 says").arg(volume->getSMName(), touch->getSMName());
  }
  return figures;
}
