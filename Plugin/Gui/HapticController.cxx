// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticController.h"

#include "HapticErrorCatcher.h"
#include "HapticPipeline.h"
#include "vtkHapticDevice.h"
#include "vtkHapticProperty.h"
#include "vtkHapticViewLink.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSMDocumentation.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMHapticViewProxy.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVolumeHapticsFilter.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QStringList>
#include <QWidget>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace
{

/**
 * Sets a property of a filter as the filter's panel would: undoable, and recorded in the Python
 * trace.
 */
template <typename ValueType>
void SetOfFilter(pqPipelineSource* filter, const char* property, const ValueType& value)
{
  vtkSMProxy* const proxy = filter->getProxy();
  BEGIN_UNDO_SET(QString("Haptic %1").arg(property));
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    vtkSMPropertyHelper(proxy, property).Set(value);
    proxy->UpdateVTKObjects();
  }
  END_UNDO_SET();
}

} // namespace

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
  QCoreApplication::instance()->installEventFilter(this);
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
void HapticController::attach(const QString& deviceId, const QString& preset, int method)
{
  this->detach();
  pqActiveObjects& active = pqActiveObjects::instance();
  auto* const view = qobject_cast<pqRenderView*>(active.activeView());
  if (!view)
  {
    Q_EMIT this->told(tr("There is no render view to attach to. Click on one, or create one."));
    return;
  }
  pqPipelineSource* const source = active.activeSource();
  const bool hadTouch = this->findTouch() != nullptr;
  pqPipelineSource* const device = HapticPipeline::FindOrMakeDevice(source);
  if (!device)
  {
    Q_EMIT this->told(source
        ? tr("%1 is neither an image nor another grid, so it can't be felt. Select a volume in the "
             "pipeline browser (Apply it first).")
            .arg(source->getSMName())
        : tr("Nothing is selected. Open a volume, and select it in the pipeline browser."));
    return;
  }
  active.setActiveSource(source);
  if (pqPipelineSource* const touch = hadTouch ? nullptr : HapticPipeline::GetTouch(device))
  {
    const QString chosen =
      preset.isEmpty() ? HapticPipeline::ProposePreset(HapticPipeline::GetVolume(touch)) : preset;
    SetOfFilter(touch, "Preset", chosen.toUtf8().data());
    SetOfFilter(touch, "Method", method);
  }
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
  for (auto* const device : { this->Second.GetPointer(), this->Device.GetPointer() })
  {
    if (device && device->GetSession())
    {
      order(device, "Running", 0);
      device->Shutdown();
    }
  }
  this->Device = nullptr;
  this->Second = nullptr;
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
void HapticController::order(vtkSMHapticDeviceProxy* device, const char* property, int value)
{
  BEGIN_UNDO_EXCLUDE();
  {
    // This change and the changes by Poll() are not traced, because a user who replays a trace may
    // not have a hand on the device.
    vtkSMPropertyHelper(device, property).Set(value);
    device->UpdateVTKObjects();
    device->Poll();
  }
  END_UNDO_EXCLUDE();
}

void HapticController::change(const char* property, int value)
{
  if (this->Device)
  {
    order(this->Device, property, value);
  }
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
  if (this->Second && (!on || this->Second->GetDevice()->IsRunning()))
  {
    order(this->Second, "Armed", on ? 1 : 0);
  }
  this->change("Armed", on ? 1 : 0);
}

//------------------------------------------------------------------------------
void HapticController::setSecondDevice(const QString& deviceId)
{
  const QString before =
    this->Second ? QString(vtkSMPropertyHelper(this->Second, "Device").GetAsString()) : QString();
  if (deviceId == before)
  {
    this->showSecond(); // the view may have been attached again
    return;
  }
  if (this->Second)
  {
    order(this->Second, "Running", 0);
    this->Second->Shutdown();
    this->Second = nullptr;
    this->showSecond();
  }
  if (deviceId.isEmpty() || !this->Device || !this->View)
  {
    return;
  }
  pqServerManagerModel* const model = pqApplicationCore::instance()->getServerManagerModel();
  auto* const first = model->findItem<pqPipelineSource*>(this->Device.GetPointer());
  pqPipelineSource* const active = pqActiveObjects::instance().activeSource();
  pqPipelineSource* const source = HapticPipeline::FindOrMakeSecondDevice(first);
  pqActiveObjects::instance().setActiveSource(active);
  auto* const second = vtkSMHapticDeviceProxy::SafeDownCast(source->getProxy());
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", static_cast<vtkSMProxy*>(second));
    vtkSMPropertyHelper(second, "Device").Set(deviceId.toUtf8().data());
    vtkSMPropertyHelper(second, "UseTool").Set(0); // only the first hand uses the tool
  }
  order(second, "Running", 1);
  if (!second->GetDevice()->IsRunning())
  {
    Q_EMIT this->told(vtkSMPropertyHelper(second, "StatusText").GetAsString());
    order(second, "Running", 0);
    return;
  }
  this->Second = second;
  this->showSecond();
  Q_EMIT this->told(QString());
}

//------------------------------------------------------------------------------
void HapticController::showSecond()
{
  if (this->View)
  {
    vtkSMPropertyHelper(this->View, "SecondDevice").Set(this->Second.GetPointer());
    this->View->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void HapticController::setTouchMode(bool on)
{
  if (this->View)
  {
    vtkSMPropertyHelper(this->View, "TouchMode").Set(on ? 1 : 0);
    this->View->UpdateVTKObjects();
  }
  pqView* const view = on && this->View ? this->findView() : nullptr;
  if (QWidget* const widget = view ? view->widget() : nullptr)
  {
    // Move the keyboard focus from the button to the view, because the next keys are meant for the
    // touch mode. The focus goes to the view's widget or to a part of it that accepts keys.
    const QList<QWidget*> parts = widget->findChildren<QWidget*>();
    const auto takesKeys = [](QWidget* part) { return part->focusPolicy() != Qt::NoFocus; };
    const auto part = std::find_if(parts.begin(), parts.end(), takesKeys);
    (takesKeys(widget) || part == parts.end() ? widget : *part)->setFocus(Qt::OtherFocusReason);
  }
}

//------------------------------------------------------------------------------
bool HapticController::eventFilter(QObject* watched, QEvent* event)
{
  // Qt first sends ShortcutOverride to widgets that override shortcuts; in a menu, it sends
  // KeyPress at once.
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  const auto isArmed = [](vtkSMHapticDeviceProxy* device)
  { return device && device->GetDevice()->IsArmOrdered(); };
  if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
    (isArmed(this->Device) || isArmed(this->Second)))
  {
    this->setTouchMode(false);
    this->setArmed(false);
  }
  return this->Superclass::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void HapticController::home()
{
  for (auto* const device : { this->Device.GetPointer(), this->Second.GetPointer() })
  {
    if (device)
    {
      order(device, "Armed", 0);
      device->GetDevice()->Home();
    }
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
pqPipelineSource* HapticController::findTouch() const
{
  pqServerManagerModel* const model = pqApplicationCore::instance()->getServerManagerModel();
  if (this->Device && this->View)
  {
    return HapticPipeline::GetTouch(model->findItem<pqPipelineSource*>(this->Device.GetPointer()));
  }
  return HapticPipeline::FindTouch(pqActiveObjects::instance().activeSource());
}

pqPipelineSource* HapticController::findVolume(pqPipelineSource* touch) const
{
  pqPipelineSource* const active = pqActiveObjects::instance().activeSource();
  return touch                         ? HapticPipeline::GetVolume(touch)
    : HapticPipeline::IsVolume(active) ? active
                                       : nullptr;
}

pqView* HapticController::findView() const
{
  pqServerManagerModel* const model = pqApplicationCore::instance()->getServerManagerModel();
  return this->View && this->View->GetLink()->IsAttached()
    ? model->findItem<pqView*>(this->View->GetLink()->GetView())
    : qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
}

//------------------------------------------------------------------------------
void HapticController::setPreset(const QString& name)
{
  if (pqPipelineSource* const touch = this->findTouch())
  {
    SetOfFilter(touch, "Preset", name.toUtf8().data());
  }
}

void HapticController::setMethod(int method)
{
  if (pqPipelineSource* const touch = this->findTouch())
  {
    SetOfFilter(touch, "Method", method);
  }
}

//------------------------------------------------------------------------------
void HapticController::loadPreset(const QString& file)
{
  pqPipelineSource* const touch = this->findTouch();
  if (!touch)
  {
    Q_EMIT this->told(tr("Nothing can be felt yet: attach a device first."));
    return;
  }
  // The client reads the file and sets the filter's functions, because properties also reach remote
  // servers and state files.
  vtkNew<vtkHapticProperty> read;
  VolumeHapticsLive::HapticErrorCatcher errors;
  errors.Catch(read);
  if (!read->ReadPreset(file.toLocal8Bit().data()))
  {
    Q_EMIT this->told(QString::fromStdString(errors.Drain()));
    return;
  }
  SetOfFilter(touch, "Preset", file.toLocal8Bit().data());
  BEGIN_UNDO_SET("Haptic preset file");
  touch->getProxy()->InvokeCommand("CopyPreset");
  END_UNDO_SET();
  Q_EMIT this->told(QString());
}

//------------------------------------------------------------------------------
void HapticController::savePreset(const QString& file)
{
  vtkVolumeHapticsFilter* const felt =
    this->Device ? this->Device->GetDevice()->GetVolumeHaptics() : nullptr;
  if (!felt)
  {
    Q_EMIT this->told(tr("There is nothing to save yet: attach a device first."));
    return;
  }
  VolumeHapticsLive::HapticErrorCatcher errors;
  errors.Catch(felt->GetProperty());
  const bool isWritten = felt->GetProperty()->WritePreset(file.toLocal8Bit().data());
  Q_EMIT this->told(isWritten ? tr("Saved: %1").arg(file) : QString::fromStdString(errors.Drain()));
}

//------------------------------------------------------------------------------
void HapticController::showAsCT()
{
  pqPipelineSource* const touch = this->findTouch();
  pqPipelineSource* const volume = this->findVolume(touch);
  pqView* const view = this->findView();
  const QString array = touch
    ? QString(vtkSMPropertyHelper(touch->getProxy(), "Scalars").GetInputArrayNameToProcess())
    : QString();
  if (!volume || !view)
  {
    Q_EMIT this->told(tr("Select a volume in the pipeline browser, and click on a render view."));
  }
  else if (!HapticVolumeLook::ShowAsCT(volume, view, array))
  {
    Q_EMIT this->told(
      tr("%1 has no point array to be rendered as a volume. The filter \"Cell Data to Point Data\" "
         "makes one of cell arrays.")
        .arg(volume->getSMName()));
  }
}

//------------------------------------------------------------------------------
void HapticController::followRecording(bool isRecording)
{
  if (this->WasRecording && !isRecording && this->Device)
  {
    const QString file = vtkSMPropertyHelper(this->Device, "RecordingFile").GetAsString();
    this->Recorded = QFileInfo::exists(file) ? file : QString();
  }
  this->WasRecording = isRecording;
}

//------------------------------------------------------------------------------
void HapticController::openRecorded()
{
  pqServer* const server = pqActiveObjects::instance().activeServer();
  if (this->Recorded.isEmpty() || !server)
  {
    return;
  }
  if (server->isRemote())
  {
    Q_EMIT this->told(
      tr("%1 is on this computer, where the server can't read it: open it on the server.")
        .arg(this->Recorded));
    return;
  }
  const bool isTable = this->Recorded.endsWith(".csv", Qt::CaseInsensitive);
  pqPipelineSource* const touched = pqActiveObjects::instance().activeSource();
  pqPipelineSource* const reader = pqApplicationCore::instance()->getObjectBuilder()->createReader(
    "sources", isTable ? "CSVReader" : "XMLPolyDataReader", QStringList(this->Recorded), server);
  if (!reader)
  {
    Q_EMIT this->told(tr("%1 can't be opened: see the output messages.").arg(this->Recorded));
    return;
  }
  reader->getProxy()->UpdateVTKObjects();
  reader->setModifiedState(pqProxy::UNMODIFIED);
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  pqView* const view = this->findView();
  controller->ShowInPreferredView(vtkSMSourceProxy::SafeDownCast(reader->getProxy()), 0,
    view ? vtkSMViewProxy::SafeDownCast(view->getProxy()) : nullptr);
  pqApplicationCore::instance()->render();
  // Make the touched volume active again, so that the hand continues with it.
  if (this->View)
  {
    pqActiveObjects::instance().setActiveSource(touched);
  }
}

//------------------------------------------------------------------------------
QString HapticController::describeAll()
{
  QString text;
  pqServer* const server = pqActiveObjects::instance().activeServer();
  vtkSMSessionProxyManager* const manager = server ? server->proxyManager() : nullptr;
  for (const auto& [group, name] : std::initializer_list<std::pair<const char*, const char*>>{
         { "filters", "VolumeHaptics" }, { "sources", "HapticDevice" }, { "sources", "HapticPath" },
         { "sources", "HapticVolume" }, { "sources", "HapticLargeFile" } })
  {
    vtkSMProxy* const proxy = manager ? manager->GetPrototypeProxy(group, name) : nullptr;
    if (!proxy)
    {
      continue;
    }
    text += QString("<h2>%1</h2><p>%2</p><dl>")
              .arg(proxy->GetXMLLabel(),
                QString(proxy->GetDocumentation()->GetDescription()).toHtmlEscaped());
    vtkSmartPointer<vtkSMPropertyIterator> properties;
    properties.TakeReference(proxy->NewPropertyIterator());
    for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
    {
      vtkSMProperty* const property = properties->GetProperty();
      vtkSMDocumentation* const about = property->GetDocumentation();
      if (about && about->GetDescription() && !property->GetIsInternal())
      {
        text += QString("<dt><b>%1</b></dt><dd>%2</dd>")
                  .arg(property->GetXMLLabel(), QString(about->GetDescription()).toHtmlEscaped());
      }
    }
    text += "</dl>";
  }
  return text;
}

//------------------------------------------------------------------------------
HapticController::Figures HapticController::look()
{
  Figures figures;
  pqPipelineSource* const chosen = this->findTouch();
  figures.HasTouch = chosen != nullptr;
  if (chosen)
  {
    figures.Preset = vtkSMPropertyHelper(chosen->getProxy(), "Preset").GetAsString();
    figures.Method = vtkSMPropertyHelper(chosen->getProxy(), "Method").GetAsInt();
  }
  pqPipelineSource* const shown = this->findVolume(chosen);
  pqView* const view = this->findView();
  figures.CanShow = shown && view;
  figures.IsVolume = figures.CanShow && HapticVolumeLook::IsShown(shown, view);
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
  const auto isArmed = [](vtkHapticDevice* one)
  {
    const int status = one->GetStatus();
    return status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
  };
  figures.Attached = this->View != nullptr;
  figures.Armed = isArmed(device);
  figures.IsFault = figures.Attached && device->GetStatus() == vtkHapticDevice::FAULT;
  if (this->Second)
  {
    this->Second->Poll();
    vtkHapticDevice* const second = this->Second->GetDevice();
    figures.HasSecond = true;
    figures.Armed = figures.Armed || isArmed(second);
    figures.IsFault = figures.IsFault || second->GetStatus() == vtkHapticDevice::FAULT;
    figures.SecondForce = vtkMath::Norm(second->GetState()->GetForce());
    figures.SecondStatus = vtkSMPropertyHelper(this->Second, "StatusText").GetAsString();
  }
  figures.Touches = this->View && this->View->GetLink()->GetTouchMode();
  figures.Recording = vtkSMPropertyHelper(this->Device, "Recording").GetAsInt() != 0;
  this->followRecording(figures.Recording);
  figures.Recorded = this->Recorded;
  figures.IsVirtual = device->GetVirtualHand()->MayMouseLead();
  figures.CanHome = device->IsRunning() && device->GetDeviceId() != "virtual";
  figures.Status = vtkSMPropertyHelper(this->Device, "StatusText").GetAsString();
  figures.Force = vtkMath::Norm(device->GetState()->GetForce());
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
