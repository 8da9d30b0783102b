// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMHapticDeviceProxy.h"

#include "HapticDataLink.h"
#include "HapticOrderLink.h"
#include "HapticReport.h"
#include "HapticUndoExclusion.h"

#include "vtkCommand.h"
#include "vtkHapticDevice.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVSessionBase.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

class vtkSMProxy;

namespace VolumeHapticsLive
{
namespace
{

/**
 * Reports events after which a proxy must release the hand: an object that it needs is removed from
 * the pipeline, the session is closed, or the server is lost.
 *
 * A proxy that is no longer registered counts as deleted, because its destructor may be called
 * late: a variable in a script can keep it alive.
 */
class HapticSessionWatch
{
public:
  struct Calls
  {
    std::function<void(vtkSMProxy*)> Unregistered; ///< called with each unregistered proxy
    std::function<void()> Closed;                  ///< called before the session ends
    std::function<void()> Lost;                    ///< called if the server no longer answers
  };

  explicit HapticSessionWatch(Calls calls);
  ~HapticSessionWatch();
  HapticSessionWatch(const HapticSessionWatch&) = delete;
  void operator=(const HapticSessionWatch&) = delete;

  /** Watch this session, and stop watching any other. */
  void Watch(vtkSMSession* session);

private:
  void RecordUnregistered(vtkObject*, unsigned long, void* data);
  void RecordClosed(vtkObject*, unsigned long, void* data);
  void RecordLost();
  void LetGo();

  Calls Call;
  vtkWeakPointer<vtkObject> Session;
  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> Observers;
};

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
      &HapticSessionWatch::RecordUnregistered);
    observe(vtkProcessModule::GetProcessModule(), vtkCommand::ConnectionClosedEvent,
      &HapticSessionWatch::RecordClosed);
    observe(session, vtkPVSessionBase::ConnectionLost, &HapticSessionWatch::RecordLost);
  }
}

void HapticSessionWatch::RecordUnregistered(vtkObject*, unsigned long, void* data)
{
  const auto* const information = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  if (information && information->Proxy)
  {
    this->Call.Unregistered(information->Proxy);
  }
}

void HapticSessionWatch::RecordClosed(vtkObject*, unsigned long, void* data)
{
  vtkProcessModule* const module = vtkProcessModule::GetProcessModule();
  if (data && module && module->GetSession(*static_cast<vtkIdType*>(data)) == this->Session)
  {
    this->Call.Closed();
  }
}

void HapticSessionWatch::RecordLost()
{
  this->Call.Lost();
}

} // namespace
} // namespace VolumeHapticsLive

vtkStandardNewMacro(vtkSMHapticDeviceProxy);

using namespace VolumeHapticsLive;

//------------------------------------------------------------------------------
struct vtkSMHapticDeviceProxy::vtkInternals
{
  vtkInternals(vtkSMHapticDeviceProxy* self, HapticSessionWatch::Calls calls)
    : Data([self] { self->LoseServer(); })
    , Orders(self, Device, Report, [self] { return self->CanReachServer(); })
    , Watch(std::move(calls))
  {
  }

  vtkNew<vtkHapticDevice> Device;
  HapticReport Report;
  HapticDataLink Data;
  HapticOrderLink Orders;
  HapticSessionWatch Watch;

  bool IsBusy = false;
  bool IsClosed = false; // whether the session has ended
  bool IsLost = false;   // whether the server no longer answers
};

//------------------------------------------------------------------------------
vtkSMHapticDeviceProxy::vtkSMHapticDeviceProxy()
{
  HapticSessionWatch::Calls calls;
  calls.Unregistered = [this](vtkSMProxy* proxy)
  {
    auto& d = *this->Internals;
    if (proxy == this || d.Data.Uses(proxy))
    {
      d.Orders.Stop(proxy == this
          ? ""
          : "Stopped, since what was touched or seen was deleted. Set Touch, and Running, again.");
    }
  };
  calls.Closed = [this]
  {
    this->Shutdown();
    this->Internals->IsClosed = true;
  };
  calls.Lost = [this] { this->LoseServer(); };
  this->Internals.reset(new vtkInternals(this, std::move(calls)));
}

//------------------------------------------------------------------------------
vtkSMHapticDeviceProxy::~vtkSMHapticDeviceProxy()
{
  this->Internals->IsClosed = true;
  this->Internals->Orders.Leave();
  this->Internals->Device->Close();
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkSMHapticDeviceProxy::GetDevice()
{
  return this->Internals->Device;
}

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter* vtkSMHapticDeviceProxy::GetFilter()
{
  return this->Internals->Data.GetFilter();
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::SetVisibility(vtkVolumeProperty* property)
{
  this->Internals->Data.SetVisibility(property);
}

//------------------------------------------------------------------------------
bool vtkSMHapticDeviceProxy::CanReachServer() const
{
  return this->Session && !this->Internals->IsLost && !this->Internals->IsClosed;
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::Shutdown()
{
  auto& d = *this->Internals;
  d.Orders.Stop("");
  d.Device->Close();
  d.Device->SetVolumeHaptics(nullptr);
  d.Data.ClearRegion();
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::LoseServer()
{
  auto& d = *this->Internals;
  if (!d.IsLost)
  {
    d.IsLost = true;
    d.Device->FadeOut();
    d.Report.SetNotice("The server no longer answers, so the force was switched off. Connect to a "
                       "server again, and open the data there.");
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::UpdateVTKObjects()
{
  auto& d = *this->Internals;
  // Execute orders first, because a hand may be waiting for them.
  if (this->ObjectsCreated && d.IsBusy)
  {
    // The other orders are executed when Poll has ended.
    d.Orders.ApplyCuts();
  }
  else if (this->ObjectsCreated)
  {
    d.Orders.Apply();
  }
  if (this->CanReachServer())
  {
    this->Superclass::UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
bool vtkSMHapticDeviceProxy::Poll()
{
  auto& d = *this->Internals;
  if (d.IsBusy || !this->Session || !this->ObjectsCreated)
  {
    return false;
  }
  d.IsBusy = true;
  // These changes can't be undone, because the filter's twin, the hand's state and the orders only
  // follow other changes.
  const VolumeHapticsLive::HapticUndoExclusion exclusion;
  if (this->CanReachServer())
  {
    d.Watch.Watch(this->Session);
    d.Report.Catch(d.Device);
    d.Report.SetProblem("");
    d.Data.Update(this, d.Device, d.Report);
    const bool isOrdered = vtkSMPropertyHelper(this, "Running").GetAsInt() != 0;
    d.Orders.ApplyRunning(d.Data.GetFilter());
    d.Orders.Publish(d.Data.GetFilter());
    d.Orders.Apply();
    const std::string error = d.Report.DrainNewError();
    if (!error.empty())
    {
      vtkErrorMacro(<< error);
    }
    if (isOrdered && !d.Device->IsRunning() && d.Report.HasProblem())
    {
      d.Report.SetNotice(d.Report.GetProblem()); // shows the problem until the next start
    }
  }
  const bool isNew = d.Device->UpdateState();
  d.Orders.Continue();
  d.Orders.HandleFault(d.IsLost);
  d.Report.ReportInformation(this, d.Device, d.Data.GetLatency());
  d.IsBusy = false;
  if (isNew && this->CanReachServer())
  {
    HapticReport::ReportState(this, d.Device);
    this->Superclass::UpdateVTKObjects();
  }
  return isNew;
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::UpdatePipeline()
{
  this->Poll();
  if (this->CanReachServer())
  {
    this->Superclass::UpdatePipeline();
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::UpdatePipeline(double time)
{
  this->Poll();
  if (this->CanReachServer())
  {
    this->Superclass::UpdatePipeline(time);
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::UpdatePropertyInformationInternal(vtkSMProperty*)
{
  // Don't query the server, because these values belong to the client.
  auto& d = *this->Internals;
  if (this->ObjectsCreated && !d.IsBusy)
  {
    d.Device->UpdateState();
    d.Report.ReportInformation(this, d.Device, d.Data.GetLatency());
  }
}

//------------------------------------------------------------------------------
vtkPVXMLElement* vtkSMHapticDeviceProxy::SaveXMLState(
  vtkPVXMLElement* root, vtkSMPropertyIterator* properties)
{
  vtkPVXMLElement* const state = this->Superclass::SaveXMLState(root, properties);
  for (unsigned int i = state ? state->GetNumberOfNestedElements() : 0; i > 0; --i)
  {
    vtkPVXMLElement* const property = state->GetNestedElement(i - 1);
    const char* const name = property->GetAttribute("name");
    if (name &&
      std::any_of(std::begin(HapticOrderLink::Names), std::end(HapticOrderLink::Names),
        [name](const char* order) { return std::strcmp(order, name) == 0; }))
    {
      state->RemoveNestedElement(property);
    }
  }
  return state;
}

//------------------------------------------------------------------------------
int vtkSMHapticDeviceProxy::LoadXMLState(vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  // Restore the orders afterwards, because loading a state must not issue orders.
  auto& d = *this->Internals;
  const bool wasBusy = std::exchange(d.IsBusy, true);
  int orders[std::size(HapticOrderLink::Names)];
  std::transform(std::begin(HapticOrderLink::Names), std::end(HapticOrderLink::Names), orders,
    [this](const char* order) { return vtkSMPropertyHelper(this, order).GetAsInt(); });
  const int isLoaded = this->Superclass::LoadXMLState(element, locator);
  for (std::size_t i = 0; i < std::size(orders); ++i)
  {
    vtkSMPropertyHelper(this, HapticOrderLink::Names[i]).Set(orders[i]);
  }
  d.IsBusy = wasBusy;
  return isLoaded;
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device:\n";
  this->Internals->Device->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Filter: " << this->GetFilter() << "\n";
  os << indent << "Problem: " << this->Internals->Report.GetProblem() << "\n";
}
