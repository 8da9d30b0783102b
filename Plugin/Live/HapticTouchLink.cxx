// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticTouchLink.h"

#include "vtkCommand.h"
#include "vtkObject.h"
#include "vtkPVSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkVolumeHapticsFilter.h"

#include <cstring>
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

void HapticTouchLink::Follow(vtkSMProxy* touch)
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
      touch->AddObserver(vtkCommand::PropertyModifiedEvent, this, &HapticTouchLink::NoteChange);
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
  // Properties copy only proxies in their domains, and the twin's domains are empty.
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
  vtkVolumeHapticsFilter* const touched = this->FindTouched();
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
  if (isOfRemoval && this->Twin && !this->FindTouched())
  {
    this->Twin->InvokeCommand(command);
  }
}

vtkVolumeHapticsFilter* HapticTouchLink::FindTouched() const
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

} // namespace VolumeHapticsLive
