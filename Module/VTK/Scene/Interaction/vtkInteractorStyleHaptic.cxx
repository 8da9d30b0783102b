// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInteractorStyleHaptic.h"

#include "VTK/Scene/Interaction/HapticInteraction.h"
#include "VTK/Scene/Interaction/HapticStyleSettings.h"
#include "VTK/Scene/Interaction/TimerWatch.h"

#include "vtkCallbackCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkInteractorStyleHaptic);

using namespace VolumeHaptics;

namespace
{

/**
 * Returns whether an interactor has a window. Without a window, VTK's own styles would crash on
 * these events, which do not normally occur then.
 */
bool HasWindow(vtkRenderWindowInteractor* interactor)
{
  return interactor && interactor->GetRenderWindow();
}

} // namespace

//------------------------------------------------------------------------------
struct vtkInteractorStyleHaptic::vtkInternals
{
  explicit vtkInternals(vtkInteractorStyleHaptic* self)
    : Interaction(self,
        { [self](bool quickly) { self->DrawScene(quickly); },
          [self] { return self->ArmsAfterClutch(); } })
    , Loop(self)
  {
    this->TimerObserver->SetClientData(this);
    this->TimerObserver->SetCallback([](vtkObject*, unsigned long, void* internals, void* id)
      { static_cast<vtkInternals*>(internals)->FiredTimer = id ? *static_cast<int*>(id) : 0; });
    this->MotionObserver->SetClientData(this);
    this->MotionObserver->SetCallback([](vtkObject*, unsigned long, void* internals, void*)
      { static_cast<vtkInternals*>(internals)->Interaction.Touch.RecordMotion(); });
    // A passive observer gets even the events that others have used.
    this->MotionObserver->SetPassiveObserver(1);
    this->EnableObserver->SetClientData(self);
    this->EnableObserver->SetCallback(
      [](vtkObject*, unsigned long, void* style, void*)
      {
        auto* const self = static_cast<vtkInteractorStyleHaptic*>(style);
        auto& d = *self->Internals;
        const bool wasEnabled = std::exchange(d.IsEnabled, self->Interactor->GetEnabled() != 0);
        if (d.IsEnabled && !wasEnabled)
        {
          d.StopTimer(self->Interactor);
          d.StartTimer(self->Interactor, self->DisplayRate);
        }
      });
  }

  void StartTimer(vtkRenderWindowInteractor* interactor, double rate)
  {
    this->Timer = interactor->CreateRepeatingTimer(static_cast<unsigned long>(1000.0 / rate));
    this->IsEnabled = interactor->GetEnabled() != 0;
    // This class always reports the id of the newest timer, whichever timer has fired.
    this->SharesTimers =
      std::strcmp(interactor->GetClassName(), "vtkGenericRenderWindowInteractor") == 0;
  }
  void StopTimer(vtkRenderWindowInteractor* interactor)
  {
    if (this->Timer != 0)
    {
      interactor->DestroyTimer(this->Timer);
    }
    this->Timer = 0;
  }

  HapticInteraction Interaction;
  TimerWatch Loop;
  int Timer = 0; ///< id of this style's timer; 0 if the application has its own timer
  /** Id of the last timer that fired, which interactors pass to observers but not to styles. */
  int FiredTimer = 0;
  bool SharesTimers = false; ///< whether a timer event may come from any of the interactor's timers
  vtkNew<vtkCallbackCommand> TimerObserver;
  vtkNew<vtkCallbackCommand> MotionObserver;
  /**
   * Whether the interactor is enabled. Earlier timer events are ignored, because wx has only one
   * kind of them.
   */
  bool IsEnabled = false;
  vtkNew<vtkCallbackCommand> EnableObserver;
};

//------------------------------------------------------------------------------
vtkInteractorStyleHaptic::vtkInteractorStyleHaptic()
  : Internals(new vtkInternals(this))
{
}

//------------------------------------------------------------------------------
vtkInteractorStyleHaptic::~vtkInteractorStyleHaptic()
{
  this->SetInteractor(nullptr);
  this->Internals->Interaction.Leave();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetDevice(vtkHapticDevice* device)
{
  if (this->Internals->Interaction.SetDevice(device))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkInteractorStyleHaptic::GetDevice()
{
  return this->Internals->Interaction.GetDevice();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetSecondDevice(vtkHapticDevice* device)
{
  if (this->Internals->Interaction.SetSecondDevice(device))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkInteractorStyleHaptic::GetSecondDevice()
{
  return this->Internals->Interaction.Second.Scene.Device;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetHeadUpDisplay(vtkHapticHeadUpDisplay* display)
{
  auto& scene = this->Internals->Interaction.Scene;
  if (scene.Display != display)
  {
    scene.Display = display;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay* vtkInteractorStyleHaptic::GetHeadUpDisplay()
{
  return this->Internals->Interaction.Scene.Display;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetFunctionEditor(vtkHapticFunctionEditor* editor)
{
  if (this->Internals->Interaction.SetFunctionEditor(editor))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticFunctionEditor* vtkInteractorStyleHaptic::GetFunctionEditor()
{
  return this->Internals->Interaction.Scene.Editor;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetSliceView(vtkHapticSliceView* slices)
{
  auto& scene = this->Internals->Interaction.Scene;
  if (scene.Slices != slices)
  {
    scene.Slices = slices;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticSliceView* vtkInteractorStyleHaptic::GetSliceView()
{
  return this->Internals->Interaction.Scene.Slices;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetCoarseVolume(vtkVolume* volume)
{
  if (this->GetCoarseVolume() != volume)
  {
    this->Internals->Interaction.SetCoarseVolume(volume);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolume* vtkInteractorStyleHaptic::GetCoarseVolume()
{
  return this->Internals->Interaction.Refined.GetVolume();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetMeasurements(vtkHapticMeasurements* measurements)
{
  if (this->Internals->Interaction.SetMeasurements(measurements))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticMeasurements* vtkInteractorStyleHaptic::GetMeasurements()
{
  return this->Internals->Interaction.Scene.Measurements;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetTouchMode(bool on)
{
  this->Internals->Interaction.Touch.Set(on);
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::GetTouchMode()
{
  return this->Internals->Interaction.Touch.IsOn();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetHoldClicks(int clicks)
{
  const int before = std::exchange(this->HoldClicks, std::clamp(clicks, 0, 2));
  if (before == 1 && this->HoldClicks != 1)
  {
    this->Internals->Interaction.Touch.ForgetView();
  }
  if (before != this->HoldClicks)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::FadeOut()
{
  // Keep this style alive, because observers may delete it.
  const vtkSmartPointer<vtkInteractorStyleHaptic> keep(this);
  this->Internals->Interaction.FadeOut();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::RecenterWorkspace()
{
  this->Internals->Interaction.Workspace.Recenter();
  this->Internals->Interaction.Second.Workspace.Recenter();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetClutch(bool on)
{
  this->Internals->Interaction.Workspace.SetClutch(on);
  this->Internals->Interaction.Second.Workspace.SetClutch(on);
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::GetClutch()
{
  return this->Internals->Interaction.Workspace.IsClutched();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::ArmsAfterClutch()
{
  vtkHapticDevice* const device = this->GetDevice();
  return device && device->ArmsAfterClutch();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::SetApplicationKeys(const char* keys)
{
  const std::string text = keys ? keys : "";
  if (std::exchange(this->Internals->Interaction.Displays.ApplicationKeys, text) != text)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkInteractorStyleHaptic::GetApplicationKeys()
{
  return this->Internals->Interaction.Displays.ApplicationKeys.c_str();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::SetKey(const char* action, const char* keys)
{
  std::string error;
  if (!this->Internals->Interaction.Keys.Set(action ? action : "", keys ? keys : "", error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkInteractorStyleHaptic::GetKey(const char* action)
{
  return this->Internals->Interaction.Keys.Get(action ? action : "");
}

//------------------------------------------------------------------------------
vtkStringArray* vtkInteractorStyleHaptic::GetKeyActions()
{
  static const vtkSmartPointer<vtkStringArray> actions = []
  {
    auto names = vtkSmartPointer<vtkStringArray>::New();
    for (const std::string& name : KeyMap::ListActions())
    {
      names->InsertNextValue(name);
    }
    return names;
  }();
  return actions;
}

//------------------------------------------------------------------------------
std::string vtkInteractorStyleHaptic::GetActionText(const char* action)
{
  return KeyMap::GetText(action ? action : "", this->Internals->Interaction.Displays.FindParts());
}

//------------------------------------------------------------------------------
std::string vtkInteractorStyleHaptic::GetActionGroup(const char* action)
{
  return KeyMap::GetGroup(action ? action : "");
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::PerformAction(const char* action)
{
  // Keep this style alive, because observers may delete it.
  const vtkSmartPointer<vtkInteractorStyleHaptic> keep(this);
  return HasWindow(this->Interactor) &&
    this->Internals->Interaction.Perform(KeyMap::FindDefaultKey(action ? action : ""));
}

//------------------------------------------------------------------------------
std::string vtkInteractorStyleHaptic::GetKeys()
{
  return this->Internals->Interaction.Displays.ListKeys();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::NextMethod()
{
  return this->Internals->Interaction.NextMethod();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::SwapSettings()
{
  return this->Internals->Interaction.SwapSettings();
}

//------------------------------------------------------------------------------
std::string vtkInteractorStyleHaptic::GetComparedSettings()
{
  return this->Internals->Interaction.Compared.GetName();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::EndComparison()
{
  this->Internals->Interaction.Compared.End();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::UpdateHaptics()
{
  this->Internals->Loop.RecordUpdate();
  return this->Internals->Interaction.UpdateHaptics();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::TouchVolume(vtkVolume* volume)
{
  return this->Internals->Interaction.Touched.Set(volume);
}

//------------------------------------------------------------------------------
vtkVolume* vtkInteractorStyleHaptic::GetTouchedVolume()
{
  return this->Internals->Interaction.Touched.Get();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::AddTouchedVolume(vtkVolume* volume, vtkVolumeHapticsFilter* filter)
{
  return this->Internals->Interaction.Touched.Add(volume, filter);
}

//------------------------------------------------------------------------------
int vtkInteractorStyleHaptic::GetNumberOfTouchedVolumes()
{
  return this->Internals->Interaction.Touched.GetCount();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::CheckShownVolumes()
{
  this->Internals->Interaction.CheckShownVolumes();
}

//------------------------------------------------------------------------------
vtkTable* vtkInteractorStyleHaptic::GetStates()
{
  return this->Internals->Interaction.States;
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
    d.Interaction.LetGo();
    d.StopTimer(this->Interactor);
    this->Interactor->RemoveObserver(d.TimerObserver);
    this->Interactor->RemoveObserver(d.MotionObserver);
    this->Interactor->RemoveObserver(d.EnableObserver);
    d.Interaction.Frames.SetWindow(nullptr);
  }
  this->Superclass::SetInteractor(interactor);
  d.Interaction.Window.SetInteractor(interactor);
  d.Loop.SetInteractor(interactor);
  if (this->Interactor)
  {
    d.StartTimer(this->Interactor, this->DisplayRate);
    this->Interactor->AddObserver(vtkCommand::ModifiedEvent, d.EnableObserver);
    this->Interactor->AddObserver(vtkCommand::MouseMoveEvent, d.MotionObserver);
    // Observe with a higher priority than the style's, so that this is called first.
    this->Interactor->AddObserver(vtkCommand::TimerEvent, d.TimerObserver, this->Priority + 1.0f);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::IsOwnTimer() const
{
  const auto& d = *this->Internals;
  return d.Timer != 0 && d.FiredTimer == d.Timer && !d.SharesTimers;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnTimer()
{
  auto& d = *this->Internals;
  if (!this->Interactor)
  {
    return;
  }
  if (d.FiredTimer != d.Timer && !d.SharesTimers)
  {
    this->Superclass::OnTimer();
    return;
  }
  this->DrawHaptics();
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::DrawHaptics()
{
  // Keep this style alive, because observers may delete it.
  const vtkSmartPointer<vtkInteractorStyleHaptic> keep(this);
  const bool isNew = this->UpdateHaptics();
  return this->Internals->Interaction.Frames.DrawIfDue(isNew);
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::DrawWholeFrame()
{
  return this->Internals->Interaction.Frames.DrawWhole();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::DrawScene(bool quickly)
{
  if (!this->Interactor)
  {
    return;
  }
  const vtkSmartPointer<vtkRenderWindow> window = this->Interactor->GetRenderWindow();
  if (!window)
  {
    this->Interactor->Render();
    return;
  }
  // Mappers choose their quality by this rate. Restore the previous rate afterwards for other
  // frames, such as those of a dragged widget.
  const double before = window->GetDesiredUpdateRate();
  window->SetDesiredUpdateRate(
    quickly ? this->Interactor->GetDesiredUpdateRate() : this->Interactor->GetStillUpdateRate());
  this->Interactor->Render();
  window->SetDesiredUpdateRate(before);
}

//------------------------------------------------------------------------------
VolumeHaptics::HapticInteraction& vtkInteractorStyleHaptic::GetInteraction()
{
  return this->Internals->Interaction;
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::UseMouseMove()
{
  auto& interaction = this->Internals->Interaction;
  if (!interaction.MoveMouse())
  {
    return false;
  }
  const double travel = interaction.Scene.Device ? interaction.Touch.GetTravelTime() : 0.0;
  if (interaction.Frames.AwaitLateMotion(travel))
  {
    this->DrawHaptics();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnMouseMove()
{
  if (!HasWindow(this->Interactor) || this->UseMouseMove())
  {
    return;
  }
  // Pass on the event only if the renderer has a window, whose size the superclass needs. A
  // renderer that the application has set or removed may have none.
  const int* const now = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(now[0], now[1]);
  if (this->CurrentRenderer && this->CurrentRenderer->GetRenderWindow())
  {
    this->Superclass::OnMouseMove();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnLeftButtonDown()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.PressLeftButton())
  {
    this->Superclass::OnLeftButtonDown();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnLeftButtonUp()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.ReleaseLeftButton())
  {
    this->Superclass::OnLeftButtonUp();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnLeftButtonDoubleClick()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.DoubleClickLeftButton())
  {
    this->Superclass::OnLeftButtonDoubleClick();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnRightButtonDown()
{
  if (!HasWindow(this->Interactor) || this->Internals->Interaction.PressRightButton())
  {
    return;
  }
  // In the touch mode, the right button turns the camera while the touch continues.
  this->GetTouchMode() ? this->Superclass::OnLeftButtonDown()
                       : this->Superclass::OnRightButtonDown();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnRightButtonUp()
{
  if (!HasWindow(this->Interactor) || this->Internals->Interaction.ReleaseRightButton())
  {
    return;
  }
  // End the action that the press began, even if the touch mode has changed since.
  this->State == VTKIS_DOLLY ? this->Superclass::OnRightButtonUp()
                             : this->Superclass::OnLeftButtonUp();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnMouseWheelForward()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.TurnWheel(1.0))
  {
    this->Internals->Interaction.Zoom([this] { this->Superclass::OnMouseWheelForward(); });
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnMouseWheelBackward()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.TurnWheel(-1.0))
  {
    this->Internals->Interaction.Zoom([this] { this->Superclass::OnMouseWheelBackward(); });
  }
}

//------------------------------------------------------------------------------
std::string vtkInteractorStyleHaptic::GetKeyName()
{
  const char* const symbol = this->Interactor->GetKeySym();
  const char code = this->Interactor->GetKeyCode();
  this->Internals->Interaction.Keys.RecordPress(symbol, code);
  return KeyMap::FindName(
    symbol, code, this->Interactor->GetShiftKey() != 0, this->Interactor->GetControlKey() != 0);
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::IsPressOf(const char* action)
{
  return this->Internals->Interaction.IsPressOf(this->GetKeyName(), KeyMap::FindDefaultKey(action));
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnKeyPress()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.PressKey(this->GetKeyName()))
  {
    this->Superclass::OnKeyPress();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnKeyRelease()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.ReleaseKey(this->GetKeyName()))
  {
    this->Superclass::OnKeyRelease();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnChar()
{
  if (HasWindow(this->Interactor) && !this->Internals->Interaction.TypeKey(this->GetKeyName()))
  {
    this->Superclass::OnChar();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto& scene = this->Internals->Interaction.Scene;
  os << indent << "SecondDevice: " << this->GetSecondDevice() << "\n";
  os << indent << "Device: " << scene.Device.GetPointer() << "\n";
  os << indent << "HeadUpDisplay: " << scene.Display.GetPointer() << "\n";
  os << indent << "FunctionEditor: " << scene.Editor.GetPointer() << "\n";
  os << indent << "SliceView: " << scene.Slices.GetPointer() << "\n";
  os << indent << "CoarseVolume: " << this->GetCoarseVolume() << "\n";
  os << indent << "Measurements: " << scene.Measurements.GetPointer() << "\n";
  os << indent << "TouchMode: " << (this->GetTouchMode() ? "On" : "Off") << "\n";
  PrintSettings(os, indent, this, StyleSettings);
  os << indent << "ComparedSettings: " << this->GetComparedSettings() << "\n";
  os << indent << "ApplicationKeys: " << this->GetApplicationKeys() << "\n";
  for (const std::string& action : KeyMap::ListActions())
  {
    os << indent << "Key of " << action << ": " << this->GetKey(action.c_str()) << "\n";
  }
  os << indent << "Clutch: " << (this->GetClutch() ? "On" : "Off") << "\n";
}
