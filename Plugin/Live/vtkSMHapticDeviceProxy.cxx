// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMHapticDeviceProxyInternals.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"

#include <algorithm>
#include <chrono>
#include <thread>

vtkStandardNewMacro(vtkSMHapticDeviceProxy);

namespace
{

/**
 * How long (s) Poll may stay away from an armed device. A user interface that stands still for
 * longer, be it since a server does not answer, can't be used to stop the hand.
 */
constexpr double AttentionTime = 2.0;

} // namespace

//------------------------------------------------------------------------------
vtkSMHapticDeviceProxy::vtkSMHapticDeviceProxy()
{
  VolumeHapticsLive::HapticSessionWatch::Calls calls;
  calls.Unregistered = [this](vtkSMProxy* proxy)
  {
    auto& d = *this->Internals;
    unsigned int port = 0;
    if (proxy == this || proxy == d.Touch.GetTouch() || proxy == d.Touch.GetInput("Input", port) ||
      proxy == d.Opacity.GetView())
    {
      this->StopHand(proxy == this
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
  this->Internals.reset(new vtkInternals(std::move(calls)));
  this->Internals->Device->SetAttentionTime(AttentionTime);
}

//------------------------------------------------------------------------------
vtkSMHapticDeviceProxy::~vtkSMHapticDeviceProxy()
{
  this->Internals->IsClosed = true;
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
  return this->Internals->Touch.GetFilter();
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::SetVisibility(vtkVolumeProperty* property)
{
  this->Internals->Visibility = property;
}

//------------------------------------------------------------------------------
bool vtkSMHapticDeviceProxy::CanReachServer() const
{
  return this->Session && !this->Internals->IsLost && !this->Internals->IsClosed;
}

//------------------------------------------------------------------------------
int vtkSMHapticDeviceProxy::GetInt(const char* name)
{
  return vtkSMPropertyHelper(this, name).GetAsInt();
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::Reset(const char* name)
{
  vtkSMPropertyHelper(this, name).Set(0);
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::StopHand(const std::string& why)
{
  auto& d = *this->Internals;
  if (d.Device->IsRunning())
  {
    this->EndForce();
    d.Log.Continue(d.Device);
    d.Device->Stop(); // writes a recording, too
    d.Notice = why;
  }
  std::string error;
  if (!d.Log.Stop(d.Device, error))
  {
    vtkErrorMacro(<< error);
  }
  d.IsArmed = false;
  d.IsRecording = false;
  for (const char* const name : { "Armed", "Recording", "Running" })
  {
    if (this->GetProperty(name))
    {
      this->Reset(name);
    }
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::EndForce()
{
  vtkHapticDevice* const device = this->Internals->Device;
  device->Disarm();
  // So that a recording ends with what was sent last.
  for (int i = 0; i < 50; ++i)
  {
    device->UpdateState();
    const double* const force = device->GetForce();
    if (device->GetStatus() <= vtkHapticDevice::READY &&
      std::all_of(force, force + 3, [](double f) { return f == 0.0; }))
    {
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::Shutdown()
{
  auto& d = *this->Internals;
  this->StopHand("");
  d.Device->Close();
  d.Device->SetVolumeHaptics(nullptr);
  d.Region.Clear();
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::LoseServer()
{
  auto& d = *this->Internals;
  if (!d.IsLost)
  {
    d.IsLost = true;
    d.Device->FadeOut();
    d.Notice = "The server does not answer any more, and force was let go of. Connect to a server "
               "anew, and open "
               "the data there.";
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::UpdateVTKObjects()
{
  auto& d = *this->Internals;
  // First of all what a hand may be waiting for.
  if (this->ObjectsCreated && d.IsBusy)
  {
    // The rest is for when Poll is through.
    this->TakeCuts();
  }
  else if (this->ObjectsCreated)
  {
    this->TakeOrders();
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
  if (this->CanReachServer())
  {
    d.Watch.Watch(this->Session);
    d.Errors.Catch(d.Device);
    d.Problem.clear();
    this->FollowData();
    this->FollowRunning();
    this->Publish();
    this->TakeOrders();
    this->Report();
  }
  const bool isNew = d.Device->UpdateState();
  d.Log.Continue(d.Device);
  this->FollowFault();
  this->TellInformation();
  d.IsBusy = false;
  if (isNew && this->CanReachServer())
  {
    this->ShowState();
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
void vtkSMHapticDeviceProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device:\n";
  this->Internals->Device->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Filter: " << this->GetFilter() << "\n";
  os << indent << "Problem: " << this->Internals->Problem << "\n";
}
