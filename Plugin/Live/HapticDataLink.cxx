// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticDataLink.h"

#include "HapticReport.h"

#include "vtkCollection.h"
#include "vtkCommand.h"
#include "vtkHapticDevice.h"
#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPVSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeProperty.h"

#include <cstring>
#include <new>
#include <utility>
#include <vector>

namespace VolumeHapticsLive
{

HapticTouchLink::~HapticTouchLink()
{
  this->LetGo();
}

void HapticTouchLink::LetGo()
{
  if (this->Touch)
  {
    this->Touch->RemoveObserver(this->Observer);
    this->Touch->RemoveObserver(this->CommandObserver);
  }
  this->Observer = this->CommandObserver = 0;
  this->Touch = nullptr;
  this->Twin = nullptr;
}

void HapticTouchLink::Watch(vtkSMProxy* touch)
{
  if (touch != this->Touch || !touch)
  {
    this->LetGo();
    if (!touch || !touch->GetSession())
    {
      return;
    }
    this->Touch = touch;
    this->Observer =
      touch->AddObserver(vtkCommand::PropertyModifiedEvent, this, &HapticTouchLink::RecordChange);
    this->CommandObserver =
      touch->AddObserver(vtkCommand::UpdatePropertyEvent, this, &HapticTouchLink::PassCommand);
    this->Twin.TakeReference(
      touch->GetSessionProxyManager()->NewProxy(touch->GetXMLGroup(), touch->GetXMLName()));
    this->IsDirty = true;
    if (this->Twin)
    {
      this->Twin->SetLocation(vtkPVSession::CLIENT);
    }
  }
  if (this->Twin && this->IsDirty)
  {
    this->CopySettings();
    this->ShareRemoval();
    this->IsDirty = false;
  }
}

void HapticTouchLink::CopySettings()
{
  this->Twin->Copy(this->Touch, "vtkSMProxyProperty");
  // Copy proxies explicitly, because vtkSMProxyProperty copies only proxies in its domains, and the
  // twin's domains are empty.
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(this->Twin->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    auto* const to = vtkSMProxyProperty::SafeDownCast(properties->GetProperty());
    auto* const from =
      vtkSMProxyProperty::SafeDownCast(this->Touch->GetProperty(properties->GetKey()));
    if (to && from && !to->IsA("vtkSMInputProperty"))
    {
      std::vector<vtkSMProxy*> proxies;
      for (unsigned int i = 0; i < from->GetNumberOfProxies(); ++i)
      {
        proxies.push_back(from->GetProxy(i));
      }
      to->SetProxies(static_cast<unsigned int>(proxies.size()), proxies.data());
    }
  }
  this->Twin->UpdateVTKObjects();
}

void HapticTouchLink::ShareRemoval()
{
  vtkVolumeHapticsFilter* const touched = this->GetTouched();
  vtkVolumeHapticsFilter* const filter = this->GetFilter();
  if (touched && filter)
  {
    filter->SetRemoval(touched->GetRemoval());
  }
}

void HapticTouchLink::PassCommand(vtkObject*, unsigned long, void* name)
{
  const auto* const command = static_cast<const char*>(name);
  const auto is = [command](const char* text) { return command && !std::strcmp(command, text); };
  const bool isOfRemoval = is("UndoRemoval") || is("RedoRemoval") || is("RestoreTissue");
  if (isOfRemoval && this->Twin && !this->GetTouched())
  {
    this->Twin->InvokeCommand(command);
  }
}

vtkVolumeHapticsFilter* HapticTouchLink::GetTouched() const
{
  return this->Touch ? vtkVolumeHapticsFilter::SafeDownCast(this->Touch->GetClientSideObject())
                     : nullptr;
}

vtkVolumeHapticsFilter* HapticTouchLink::GetFilter() const
{
  return this->Twin ? vtkVolumeHapticsFilter::SafeDownCast(this->Twin->GetClientSideObject())
                    : nullptr;
}

vtkSMProxy* HapticTouchLink::GetTouch() const
{
  return this->Touch;
}

vtkSMSourceProxy* HapticTouchLink::GetInput(const char* name, unsigned int& port) const
{
  if (!this->Touch || !this->Touch->GetProperty(name))
  {
    return nullptr;
  }
  const vtkSMPropertyHelper input(this->Touch, name, true);
  if (input.GetNumberOfElements() == 0)
  {
    return nullptr;
  }
  port = input.GetOutputPort();
  return vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
}

HapticDataLink::HapticDataLink(std::function<void()> lost)
  : Lost(std::move(lost))
{
}

bool HapticDataLink::IsLocal(vtkSMProxy* proxy)
{
  vtkSMSession* const session = proxy->GetSession();
  return session && session->HasProcessRole(vtkPVSession::DATA_SERVER);
}

bool HapticDataLink::Uses(vtkSMProxy* proxy) const
{
  unsigned int port = 0;
  return proxy == this->Touch.GetTouch() || proxy == this->Touch.GetInput("Input", port) ||
    proxy == this->Opacity.GetView();
}

void HapticDataLink::Update(vtkSMProxy* proxy, vtkHapticDevice* device, HapticReport& report)
{
  vtkSMProxy* const touch = vtkSMPropertyHelper(proxy, "Touch").GetAsProxy();
  this->Touch.Watch(touch);
  vtkVolumeHapticsFilter* const filter = this->Touch.GetFilter();
  if (!filter)
  {
    if (touch && !report.HasProblem())
    {
      report.SetProblem("Touch does not name a Volume Haptics filter. Set it to one "
                        "whose Input is the volume.");
    }
    return;
  }
  report.Catch(filter);
  unsigned int port = 0;
  vtkSMSourceProxy* const volume = this->Touch.GetInput("Input", port);
  unsigned int surfacePort = 0;
  vtkSMSourceProxy* const surface = this->Touch.GetInput("Surface", surfacePort);
  unsigned int labelPort = 0;
  vtkSMSourceProxy* const labels = this->Touch.GetInput("Labels", labelPort);
  this->UpdateTime(proxy, volume);
  if (IsLocal(proxy))
  {
    this->UpdateImage(volume, port, device, report);
    this->Surface.Update(surface, surfacePort, filter, 2);
    this->Labels.Update(labels, labelPort, filter, 3);
  }
  else if (vtkSMPropertyHelper(proxy, "Running").GetAsInt())
  {
    this->PollRegion(proxy, volume, port, device, report);
    if (surface && !report.HasProblem())
    {
      report.SetProblem("A Surface on a server is not touched; the isosurface at IsoValue is. To "
                        "touch the Surface, open the data without a server.");
    }
    const char* const displacements =
      vtkSMPropertyHelper(this->Touch.GetTouch(), "DisplacementArrayName").GetAsString();
    if (displacements && *displacements && HapticTimeStepLink::IsMoving(volume, port, filter) &&
      !report.HasProblem())
    {
      report.SetProblem("Displacements on a server are not felt; the time steps are blended in "
                        "place. To feel the displacements, open the data without a server.");
    }
    if (labels && !report.HasProblem())
    {
      report.SetProblem("Labels on a server are not felt; the functions are. To feel the Labels, "
                        "open the data without a server.");
    }
  }
  vtkVolumeProperty* const seen = vtkSMPropertyHelper(proxy, "FollowOpacity").GetAsInt()
    ? this->Opacity.Find(volume, filter)
    : nullptr;
  this->Crop.Update(seen ? this->Opacity.GetRepresentation() : nullptr, filter);
  filter->GetProperty()->SetVisibilityFrom(this->Visibility ? this->Visibility.Get() : seen);
}

void HapticDataLink::UpdateTime(vtkSMProxy* proxy, vtkSMSourceProxy* volume)
{
  // Try both names of the timekeeper: exactly one exists, depending on ParaView's version.
  vtkNew<vtkCollection> keepers;
  proxy->GetSessionProxyManager()->GetProxies("timekeeper", keepers);
  vtkSMProxy* const keeper = vtkSMProxy::SafeDownCast(keepers->GetItemAsObject(0));
  const double time = keeper ? vtkSMPropertyHelper(keeper, "Time").GetAsDouble() : this->ViewTime;
  if (volume && time != this->ViewTime)
  {
    this->ViewTime = time;
    volume->UpdatePipeline(time);
  }
}

void HapticDataLink::UpdateImage(
  vtkSMSourceProxy* volume, unsigned int port, vtkHapticDevice* device, HapticReport& report)
{
  vtkVolumeHapticsFilter* const filter = this->Touch.GetFilter();
  if (volume)
  {
    volume->UpdatePipeline(); // needed to find out whether the volume has times
  }
  if (HapticTimeStepLink::IsMoving(volume, port, filter))
  {
    try
    {
      this->Image.PollTimeSteps(volume, port, this->ViewTime, filter, device, this->TimeSteps);
    }
    catch (const std::bad_alloc&) // out of memory; the next update tries again
    {
      report.SetProblem("This computer has no memory for a copy of the volume at this time, so it "
                        "is felt as it was before. Close other programs that need memory.");
    }
    return;
  }
  if (this->TimeSteps.HasBegun(filter))
  {
    this->TimeSteps.Clear();
    this->Image.Forget();
  }
  if (this->Large.Update(HapticImageLink::GetUpdatedOutput(volume, port), filter))
  {
    this->Image.Forget();
    return;
  }
  this->Image.Update(volume, port, filter, 0);
}

void HapticDataLink::PollRegion(vtkSMProxy* proxy, vtkSMSourceProxy* volume, unsigned int port,
  vtkHapticDevice* device, HapticReport& report)
{
  this->Region.SetMaximumVoxels(vtkSMPropertyHelper(proxy, "MaximumRegionVoxels").GetAsIdType());
  vtkVolumeHapticsFilter* const filter = this->Touch.GetFilter();
  filter->SetDisplacementArrayName(""); // regions contain only the touched array
  switch (this->Region.Poll(volume, port, this->ViewTime, filter, device, this->TimeSteps))
  {
    case HapticRegionLink::Answer::Lost:
      this->Lost();
      break;
    case HapticRegionLink::Answer::Refused:
      report.SetProblem(this->Region.GetProblem());
      break;
    default:
      break;
  }
}

} // namespace VolumeHapticsLive
