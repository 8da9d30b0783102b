// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticSessionWatch.h"

#include "vtkCommand.h"
#include "vtkPVSessionBase.h"
#include "vtkProcessModule.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"

namespace VolumeHapticsLive
{

HapticSessionWatch::HapticSessionWatch(Calls calls)
  : Call(std::move(calls))
{
}

HapticSessionWatch::~HapticSessionWatch()
{
  this->LetGo();
}

void HapticSessionWatch::LetGo()
{
  for (const auto& [object, tag] : this->Observers)
  {
    if (object)
    {
      object->RemoveObserver(tag);
    }
  }
  this->Observers.clear();
}

void HapticSessionWatch::Watch(vtkSMSession* session)
{
  if (session == this->Session)
  {
    return;
  }
  this->LetGo();
  this->Session = session;
  const auto observe = [this](vtkObject* object, unsigned long event, auto method)
  {
    if (object)
    {
      this->Observers.emplace_back(object, object->AddObserver(event, this, method));
    }
  };
  if (session)
  {
    observe(session->GetSessionProxyManager(), vtkCommand::UnRegisterEvent,
      &HapticSessionWatch::NoteUnregistered);
    observe(vtkProcessModule::GetProcessModule(), vtkCommand::ConnectionClosedEvent,
      &HapticSessionWatch::NoteClosed);
    observe(session, vtkPVSessionBase::ConnectionLost, &HapticSessionWatch::NoteLost);
  }
}

void HapticSessionWatch::NoteUnregistered(vtkObject*, unsigned long, void* data)
{
  const auto* const information = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  if (information && information->Proxy)
  {
    this->Call.Unregistered(information->Proxy);
  }
}

void HapticSessionWatch::NoteClosed(vtkObject*, unsigned long, void* data)
{
  vtkProcessModule* const module = vtkProcessModule::GetProcessModule();
  if (data && module && module->GetSession(*static_cast<vtkIdType*>(data)) == this->Session)
  {
    this->Call.Closed();
  }
}

void HapticSessionWatch::NoteLost()
{
  this->Call.Lost();
}

} // namespace VolumeHapticsLive
