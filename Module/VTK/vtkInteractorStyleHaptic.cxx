// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInteractorStyleHaptic.h"

#include "VTK/Baking/HapticBaker.h"
#include "VTK/Scene/HapticViewRay.h"
#include "vtkInteractorStyleHapticInternals.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkInteractorStyleHaptic);

using namespace VolumeHaptics;

//------------------------------------------------------------------------------
vtkInteractorStyleHaptic::vtkInteractorStyleHaptic()
  : Internals(new vtkInternals(this))
{
  auto& d = *this->Internals;
  d.TimerObserver->SetClientData(&d);
  d.TimerObserver->SetCallback([](vtkObject*, unsigned long, void* self, void* id)
    { static_cast<vtkInternals*>(self)->FiredTimer = id ? *static_cast<int*>(id) : 0; });
  d.DisarmObserver->SetClientData(&d);
  d.DisarmObserver->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      static_cast<vtkInternals*>(self)->ArmAfterClutch = false;
      static_cast<vtkInternals*>(self)->IsTouchBeginning = false;
    });
  d.WorkObserver->SetClientData(this);
  d.WorkObserver->SetCallback(
    [](vtkObject* worker, unsigned long event, void* self, void*)
    {
      static_cast<vtkInteractorStyleHaptic*>(self)->FollowWork(
        worker, event == vtkCommand::StartEvent);
    });
}

//------------------------------------------------------------------------------
vtkInteractorStyleHaptic::~vtkInteractorStyleHaptic()
{
  this->SetInteractor(nullptr);
  if (this->Internals->Device)
  {
    this->Internals->Device->RemoveObserver(this->Internals->DisarmObserver);
    this->Internals->Device->RemoveObserver(this->Internals->WorkObserver);
    this->Internals->Device->RemoveReader(this->Internals->Reader);
  }
  this->SetFunctionEditor(nullptr);
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetDevice(vtkHapticDevice* device)
{
  auto& d = *this->Internals;
  if (d.Device != device)
  {
    this->LetGo(); // an observer of it may take the device away, too
    if (d.Device)
    {
      d.Device->RemoveObserver(d.DisarmObserver);
      d.Device->RemoveObserver(d.WorkObserver);
      d.Device->RemoveReader(d.Reader);
    }
    d.Device = device;
    if (device)
    {
      d.Reader = device->AddReader();
      d.Updated = device->GetTime();
      device->AddObserver(vtkCommand::DisableEvent, d.DisarmObserver);
      device->AddObserver(vtkCommand::StartEvent, d.WorkObserver);
      device->AddObserver(vtkCommand::EndEvent, d.WorkObserver);
    }
    d.ArmAfterClutch = false;
    this->Clutch = false;
    d.Watch.Reset();
    d.IsPlaced = false;
    d.Published = 0;
    this->TouchMode = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkInteractorStyleHaptic::GetDevice()
{
  return this->Internals->Device;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetHeadUpDisplay(vtkHapticHeadUpDisplay* display)
{
  if (this->Internals->Display != display)
  {
    this->Internals->Display = display;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay* vtkInteractorStyleHaptic::GetHeadUpDisplay()
{
  return this->Internals->Display;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetFunctionEditor(vtkHapticFunctionEditor* editor)
{
  auto& d = *this->Internals;
  if (d.Editor != editor)
  {
    if (d.Editor)
    {
      d.Editor->RemoveObserver(d.WorkObserver);
      this->FollowWork(d.Editor, false);
    }
    d.Editor = editor;
    if (editor)
    {
      editor->AddObserver(vtkCommand::StartEvent, d.WorkObserver);
      editor->AddObserver(vtkCommand::EndEvent, d.WorkObserver);
    }
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticFunctionEditor* vtkInteractorStyleHaptic::GetFunctionEditor()
{
  return this->Internals->Editor;
}

//------------------------------------------------------------------------------
vtkTable* vtkInteractorStyleHaptic::GetStates()
{
  return this->Internals->States;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  auto& d = *this->Internals;
  if (interactor == this->Interactor)
  {
    return;
  }
  if (this->Interactor)
  {
    this->LetGo();
    // There is no timer (0) where the application brings its own.
    if (d.Timer != 0)
    {
      this->Interactor->DestroyTimer(d.Timer);
    }
    this->Interactor->RemoveObserver(d.TimerObserver);
    d.Timer = 0;
  }
  this->Superclass::SetInteractor(interactor);
  d.Window.SetInteractor(interactor);
  if (this->Interactor)
  {
    const double period = 1000.0 / this->DisplayRate;
    d.Timer = this->Interactor->CreateRepeatingTimer(static_cast<unsigned long>(period));
    // Before the style itself hears of the event.
    this->Interactor->AddObserver(vtkCommand::TimerEvent, d.TimerObserver, this->Priority + 1.0f);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::LetGo()
{
  this->SetTouchMode(false);
  if (this->Internals->Device)
  {
    this->Internals->Device->Disarm();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkInteractorStyleHaptic::GetHapticRenderer()
{
  // There is no current one before the first button.
  vtkRenderer* const chosen = this->CurrentRenderer ? this->CurrentRenderer : this->DefaultRenderer;
  if (chosen || !this->Interactor || !this->Interactor->GetRenderWindow())
  {
    return chosen;
  }
  return this->Interactor->GetRenderWindow()->GetRenderers()->GetFirstRenderer();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::PlaceWorkspace(vtkRenderer* renderer)
{
  auto& d = *this->Internals;
  vtkCamera* const camera = renderer->GetActiveCamera();
  const vtkMTimeType time = std::max(camera->GetMTime(), this->GetMTime());
  if (!this->WorkspaceFollowsCamera || !d.IsReal() || (d.IsPlaced && time == d.Placed))
  {
    return false;
  }
  d.Device->SetDeviceToWorld(d.Workspace.Place(camera, this->GetEffectiveScale()));
  d.Placed = time;
  d.IsPlaced = true;
  return true;
}

//------------------------------------------------------------------------------
double vtkInteractorStyleHaptic::GetEffectiveScale()
{
  vtkVolumeHapticsFilter* const filter = this->Internals->Device->GetVolumeHaptics();
  const double natural = filter ? 1.0 / filter->GetMetersPerWorldUnit() : 1000.0;
  return this->WorkspaceScale > 0.0 ? this->WorkspaceScale : natural;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::RecenterWorkspace()
{
  this->Internals->Workspace.Recenter();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetClutch(bool on)
{
  auto& d = *this->Internals;
  vtkRenderer* const renderer = this->GetHapticRenderer();
  if (on == this->Clutch || !d.IsReal() || !renderer)
  {
    return;
  }
  d.Device->UpdateState();
  const double* const x = d.Device->GetTipPosition();
  const Vector3 tip{ x[0], x[1], x[2] };
  this->Clutch = on;
  if (on)
  {
    const bool wasArmed = d.IsArmed();
    d.ClutchedTip = tip;
    d.Device->Disarm();
    d.ArmAfterClutch = wasArmed;
  }
  else
  {
    d.Workspace.Shift(renderer->GetActiveCamera(), tip, d.ClutchedTip);
    this->Modified();
    this->UpdateHaptics();
    if (this->ArmsAfterClutch())
    {
      d.Device->Arm();
    }
    d.ArmAfterClutch = false;
  }
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::ArmsAfterClutch()
{
  return this->Internals->ArmAfterClutch;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetTouchMode(bool on)
{
  auto& d = *this->Internals;
  if (!on)
  {
    d.IsTouchBeginning = false;
  }
  if (on == this->TouchMode)
  {
    return;
  }
  if (on)
  {
    this->BeginTouch();
    return;
  }
  this->TouchMode = false;
  d.Window.Look();
  if (d.Device)
  {
    d.Device->Disarm();
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::BeginTouch()
{
  auto& d = *this->Internals;
  if (!d.Device || !d.Device->IsRunning())
  {
    vtkErrorMacro("There is nothing to touch with: SetDevice() one that is open and started.");
    return;
  }
  if (!this->Interactor)
  {
    vtkErrorMacro("The touch mode needs a window, but this style has no interactor: pass the style "
                  "to SetInteractorStyle() of the window's interactor.");
    return;
  }
  if (d.Window.IsClosed())
  {
    vtkErrorMacro(
      "The touch mode needs a window, but it was closed: Render() it to open it again.");
    return;
  }
  // Observers of the long work may end the loop, disarm, or take the device or the interactor away.
  // Each of these ends the beginning, too, and nothing is armed then.
  const vtkSmartPointer<vtkInteractorStyleHaptic> self(this);
  const vtkSmartPointer<vtkHapticDevice> device = d.Device;
  const vtkSmartPointer<vtkRenderer> renderer = this->GetHapticRenderer();
  const bool leadsTip = d.IsVirtual() && renderer;
  Vector3 start;
  d.IsTouchBeginning = true;
  if (leadsTip)
  {
    const double* const focus = renderer->GetActiveCamera()->GetFocalPoint();
    const int pointer[2] = { this->Interactor->GetEventPosition()[0],
      this->Interactor->GetEventPosition()[1] };
    start = UnderPointer(renderer, pointer, { focus[0], focus[1], focus[2] });
    if (const vtkSmartPointer<vtkVolumeHapticsFilter> filter = device->GetVolumeHaptics())
    {
      const LongWork work(device, "the surface is meshed", HapticBaker(filter).EstimateTime());
      if (d.IsTouchBeginning)
      {
        FindFirstContact(renderer, pointer, filter, start);
      }
    }
  }
  d.Window.Look();
  if (!std::exchange(d.IsTouchBeginning, false))
  {
    return;
  }
  if (leadsTip)
  {
    d.Lead = start;
    device->PlaceVirtualTip(start.X, start.Y, start.Z);
  }
  this->TouchMode = true;
  if (!this->Clutch)
  {
    device->Arm();
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto& d = *this->Internals;
  os << indent << "Device: " << d.Device.GetPointer() << "\n";
  os << indent << "HeadUpDisplay: " << d.Display.GetPointer() << "\n";
  os << indent << "FunctionEditor: " << d.Editor.GetPointer() << "\n";
  os << indent << "TouchMode: " << (this->TouchMode ? "On" : "Off") << "\n";
  os << indent << "DepthStep: " << this->DepthStep << "\n";
  os << indent << "DisplayRate: " << this->DisplayRate << " Hz\n";
  os << indent << "WorkspaceFollowsCamera: " << (this->WorkspaceFollowsCamera ? "On" : "Off")
     << "\n";
  os << indent << "WorkspaceScale: " << this->WorkspaceScale << "\n";
  os << indent << "Clutch: " << (this->Clutch ? "On" : "Off") << "\n";
}
