// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/HapticInteraction.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Scene/Base/HapticViewRay.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTable.h"
#include "vtkVolume.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Factor by which a press of the key + or - scales the workspace. */
constexpr double WorkspaceStep = 1.25;

constexpr int LeftButton = vtkHapticFunctionEditor::LEFT_BUTTON;

bool IsArmed(vtkHapticDevice* device)
{
  const int status = device->GetStatus();
  return status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
}

} // namespace

std::vector<unsigned long> HapticStateWatch::Watch(vtkTable* states)
{
  std::vector<unsigned long> events;
  auto* const contact = vtkDataArray::SafeDownCast(states->GetColumnByName("Contact"));
  auto* const armed = vtkDataArray::SafeDownCast(states->GetColumnByName("Armed"));
  auto* const fault = vtkDataArray::SafeDownCast(states->GetColumnByName("Fault"));
  const auto note = [&](bool& was, bool is, unsigned long begins, unsigned long ends)
  {
    if (is != was && (is || ends != 0))
    {
      events.push_back(is ? begins : ends);
    }
    was = is;
  };
  for (vtkIdType i = 0; contact && armed && fault && i < states->GetNumberOfRows(); ++i)
  {
    const bool hasFault = fault->GetComponent(i, 0) != 0.0;
    note(this->HasFault, hasFault, vtkInteractorStyleHaptic::FaultEvent, 0);
    // A fault invokes only FaultEvent, without DisarmedEvent.
    note(this->IsArmed, armed->GetComponent(i, 0) != 0.0, vtkInteractorStyleHaptic::ArmedEvent,
      hasFault ? 0 : vtkInteractorStyleHaptic::DisarmedEvent);
    note(this->IsTouching, contact->GetComponent(i, 0) != 0.0,
      vtkInteractorStyleHaptic::ContactBeginEvent, vtkInteractorStyleHaptic::ContactEndEvent);
  }
  return events;
}

//------------------------------------------------------------------------------
HapticInteraction::HapticInteraction(vtkInteractorStyleHaptic* style, Calls calls)
  : Scene(style)
  , Window(style, [this] { this->LetGo(); })
  , Frames(Scene, Window, std::move(calls.DrawScene))
  , Workspace(Scene, std::move(calls.ArmsAfterClutch))
  , Second(Scene)
  , Touch(Scene, Window, Workspace)
  , Turn(Scene)
  , Displays(Scene, Touch, Turn, Keys)
  , Touched(Scene, ShownTimeSteps, Carved)
  , Publisher(Scene)
  , Compared(Scene, Publisher)
  , Playback(Scene)
  , Modes(Scene)
  , Editor(Scene, Frames)
  , Slices(Scene, Touch)
  , Measure(Scene, Frames)
{
  this->Scene.Second = &this->Second.Scene;
  this->Touch.BeforeBegin = [this] { this->UpdateVolumes(); };
  this->Touch.BeforeLanding = [this](vtkRenderer* renderer, const Vector3& through)
  { this->Touched.ChooseAt(renderer, through); };
  this->DisarmObserver->SetClientData(this);
  this->DisarmObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<HapticInteraction*>(self)->Touch.StopBeginning(); });
  this->WorkObserver->SetClientData(this);
  this->WorkObserver->SetCallback(
    [](vtkObject* worker, unsigned long event, void* self, void*) {
      static_cast<HapticInteraction*>(self)->HandleWork(worker, event == vtkCommand::StartEvent);
    });
}

//------------------------------------------------------------------------------
void HapticInteraction::Leave()
{
  this->LeaveDevice();
  this->Second.SetDevice(nullptr);
  this->SetFunctionEditor(nullptr);
}

//------------------------------------------------------------------------------
void HapticInteraction::LeaveDevice()
{
  if (vtkHapticDevice* const device = this->Scene.Device)
  {
    device->RemoveObserver(this->DisarmObserver);
    device->RemoveObserver(this->WorkObserver);
    device->GetState()->RemoveReader(this->Reader);
    this->Workspace.LeaveDevice();
    this->ShownTimeSteps.Restore();
    this->Carved.Clear();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* HapticInteraction::GetDevice() const
{
  return this->NextDevice ? this->NextDevice->GetPointer() : this->Scene.Device.GetPointer();
}

//------------------------------------------------------------------------------
bool HapticInteraction::SetDevice(vtkHapticDevice* device)
{
  if (this->GetDevice() == device)
  {
    return false;
  }
  if (this->IsUpdating)
  {
    this->NextDevice = vtkSmartPointer<vtkHapticDevice>(device);
  }
  if (device && device == this->Second.Scene.Device)
  {
    this->Second.SetDevice(nullptr); // the mode has one tip, which is now the first hand's
  }
  this->LetGo(); // an observer of this call's events may also remove the device
  if (this->IsUpdating)
  {
    return true;
  }
  this->LeaveDevice();
  this->Scene.Device = device;
  if (device)
  {
    this->Reader = device->GetState()->AddReader();
    this->Updated = device->GetState()->GetTime();
    device->AddObserver(vtkCommand::DisableEvent, this->DisarmObserver);
    device->AddObserver(vtkCommand::StartEvent, this->WorkObserver);
    device->AddObserver(vtkCommand::EndEvent, this->WorkObserver);
  }
  this->Workspace.Reset();
  this->Watch.Reset();
  this->Publisher.Reset();
  this->Compared.End();
  this->Touch.Reset();
  return true;
}

//------------------------------------------------------------------------------
bool HapticInteraction::SetSecondDevice(vtkHapticDevice* device)
{
  if (device && device == this->GetDevice())
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "The second device is the first one, which has one tip. Open() another vtkHapticDevice for "
      "the other hand.");
    return false;
  }
  return this->Second.SetDevice(device);
}

//------------------------------------------------------------------------------
bool HapticInteraction::SetFunctionEditor(vtkHapticFunctionEditor* editor)
{
  if (this->Scene.Editor == editor)
  {
    return false;
  }
  if (this->Scene.Editor)
  {
    this->Scene.Editor->RemoveObserver(this->WorkObserver);
    this->HandleWork(this->Scene.Editor, false);
  }
  this->Scene.Editor = editor;
  if (editor)
  {
    editor->AddObserver(vtkCommand::StartEvent, this->WorkObserver);
    editor->AddObserver(vtkCommand::EndEvent, this->WorkObserver);
  }
  return true;
}

//------------------------------------------------------------------------------
bool HapticInteraction::SetMeasurements(vtkHapticMeasurements* measurements)
{
  if (this->Scene.Measurements == measurements)
  {
    return false;
  }
  this->Measure.End();
  this->Scene.Measurements = measurements;
  return true;
}

//------------------------------------------------------------------------------
void HapticInteraction::LetGo()
{
  // s: longest wait for the disarmed state, which takes one or two ticks of the servo
  constexpr double most = 0.1;
  this->Second.Disarm(); // disarm first, because observers of the other hand's events may take long
  this->Measure.End();
  this->Touch.Set(false);
  if (const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device)
  {
    device->Disarm();
  }
  // Update the states now, because the last states report force, and perhaps no later update
  // follows.
  const std::int64_t begin = ServoClock::Now();
  for (const TouchedScene* const scene : { &this->Scene, &this->Second.Scene })
  {
    const vtkSmartPointer<vtkHapticDevice> device = scene->Device;
    while (device && scene->Device == device && device->IsRunning() && scene->IsArmed() &&
      ServoClock::SecondsSince(begin) < most)
    {
      std::this_thread::sleep_for(std::chrono::microseconds(500));
      device->UpdateState();
    }
  }
}

//------------------------------------------------------------------------------
void HapticInteraction::FadeOut()
{
  this->Measure.End();
  if (const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device)
  {
    device->FadeOut();
  }
  this->Second.FadeOut();
  this->Touch.Set(false);
}

//------------------------------------------------------------------------------
bool HapticInteraction::MoveMouse()
{
  vtkRenderWindowInteractor* const interactor = this->Scene.Style->GetInteractor();
  const std::array<int, 2> before = this->Touch.TakeMotion();
  const std::array<int, 2> now = this->Touch.FindPointer();
  if (this->Scene.Style->GetState() == VTKIS_NONE && this->Scene.Editor &&
    this->Scene.Editor->MouseMove(now[0], now[1]))
  {
    this->Frames.Draw(true);
    return true;
  }
  if (this->Slices.Move(now[0], now[1]))
  {
    return this->DrawSlices();
  }
  if (this->Scene.Style->GetState() == VTKIS_NONE && this->Turn.IsOn())
  {
    this->Turn.Roll(before.data(), now.data());
    return true;
  }
  const bool leads = this->Touch.LeadsTip();
  if (!leads || this->Scene.Style->GetHoldClicks() == 1)
  {
    return leads;
  }
  if (interactor->GetControlKey())
  {
    constexpr double stepsPerPixel = 0.25;
    this->Touch.MoveInDepth(stepsPerPixel * (now[1] - before[1]));
  }
  else
  {
    this->Touch.MoveInPlane(before, now);
  }
  return true;
}

//------------------------------------------------------------------------------
bool HapticInteraction::PressLeftButton()
{
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  if (this->Scene.Editor && this->Scene.Editor->ButtonPress(LeftButton, at[0], at[1]))
  {
    this->EditorHasMouse = true;
    return true;
  }
  if (this->Slices.Press(at[0], at[1], false))
  {
    return this->DrawSlices();
  }
  if (this->Modes.Click(at[0], at[1]))
  {
    this->ListHasMouse = true;
    this->Frames.Draw(true);
    return true;
  }
  if (this->Touch.LeadsTip())
  {
    const int hold = this->Scene.Style->GetHoldClicks();
    hold > 0 ? this->Scene.Style->SetHoldClicks(hold - 1) : this->Touch.PressButton();
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
bool HapticInteraction::ReleaseLeftButton()
{
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  if (std::exchange(this->EditorHasMouse, false))
  {
    if (this->Scene.Editor) // checked again, because an observer may have removed the editor
    {
      this->Scene.Editor->ButtonRelease(LeftButton, at[0], at[1]);
      this->Frames.Draw(true);
    }
    return true;
  }
  if (this->Slices.Release(false) || std::exchange(this->ListHasMouse, false))
  {
    return true;
  }
  return this->Touch.ReleaseButton() || this->Touch.LeadsTip();
}

//------------------------------------------------------------------------------
bool HapticInteraction::DoubleClickLeftButton()
{
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  if (this->Scene.Editor && this->Scene.Editor->DoubleClick(LeftButton, at[0], at[1]))
  {
    this->Frames.Draw(true);
    return true;
  }
  return this->Slices.Press(at[0], at[1], false) && this->DrawSlices();
}

//------------------------------------------------------------------------------
bool HapticInteraction::PressRightButton()
{
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  return this->Slices.Press(at[0], at[1], true);
}

//------------------------------------------------------------------------------
bool HapticInteraction::ReleaseRightButton()
{
  return this->Slices.Release(true);
}

//------------------------------------------------------------------------------
bool HapticInteraction::DrawSlices()
{
  if (this->Slices.DrainChange())
  {
    this->Frames.Draw(true);
  }
  return true;
}

//------------------------------------------------------------------------------
bool HapticInteraction::TurnWheel(double steps)
{
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  constexpr double lines = 3.0; // lines of the list of keys per step of the wheel
  if (this->Scene.Display &&
    this->Scene.Display->ScrollHelp(static_cast<int>(std::lround(-lines * steps))))
  {
    this->Frames.Draw(true);
    return true;
  }
  if (this->Scene.Editor && this->Scene.Editor->TurnWheel(steps, at[0], at[1]))
  {
    this->Frames.Draw(true);
    return true;
  }
  if (this->Slices.TurnWheel(steps, at[0], at[1]))
  {
    return this->DrawSlices();
  }
  if (this->Turn.IsOn())
  {
    this->Turn.Twist(steps);
    return true;
  }
  if (!this->Touch.LeadsTip() || this->Scene.Style->GetInteractor()->GetControlKey())
  {
    return false;
  }
  if (this->Scene.Style->GetHoldClicks() != 1)
  {
    this->Touch.MoveInDepth(steps);
  }
  return true;
}

//------------------------------------------------------------------------------
void HapticInteraction::Zoom(const std::function<void()>& zoom)
{
  const vtkSmartPointer<vtkRenderWindowInteractor> interactor = this->Scene.Style->GetInteractor();
  if (!this->Touch.LeadsTip() || !interactor->GetEnableRender())
  {
    zoom();
    return;
  }
  interactor->EnableRenderOff(); // render only once, with the camera in its final position
  this->Touch.KeepInWindow(zoom);
  interactor->EnableRenderOn();
  this->Frames.Draw(true);
}

//------------------------------------------------------------------------------
bool HapticInteraction::PressKey(const std::string& pressed)
{
  const std::string key = this->FindAction(pressed);
  const bool isRepeat = this->Repeat.IsRepeat(pressed);
  this->Repeat.RecordPress(pressed);
  if (isRepeat && !KeyRepeat::MayRepeat(key))
  {
    return pressed == this->UsedKey;
  }
  const bool isUsed = this->Perform(key, true);
  this->UsedKey = isUsed ? pressed : std::string();
  return isUsed;
}

//------------------------------------------------------------------------------
std::string HapticInteraction::FindAction(const std::string& pressed) const
{
  // In the touch mode, Ctrl and the mouse move in depth, so keys for the hand must work with Ctrl,
  // too.
  const std::string key = this->Keys.Find(pressed);
  const std::string plain = this->Keys.FindReleased(pressed);
  const bool isOfHand =
    plain.size() == 1 && std::string("ta12345").find(plain) != std::string::npos;
  return key.empty() && isOfHand && this->Touch.IsOn() ? plain : key;
}

//------------------------------------------------------------------------------
bool HapticInteraction::Perform(const std::string& key, bool isPressed)
{
  auto& scene = this->Scene;
  if (key.empty())
  {
    return false;
  }
  if (key == "t")
  {
    this->Touch.Set(!this->Touch.IsOn());
  }
  else if (key == "Escape")
  {
    this->Second.Disarm(); // disarm first, because observers of the other hand's events may take
                           // long
    this->Displays.HideKeys();
    this->Measure.End();
    this->Touch.Set(false);
    if (scene.Device)
    {
      scene.Device->Disarm();
      // Release the clutch here, too: if the window loses the focus while the key k is held, the
      // release of the key never arrives.
      this->Workspace.SetClutch(false);
    }
    this->Second.Workspace.SetClutch(false);
  }
  else if (key == "a" && scene.Device)
  {
    this->ArmOrDisarm();
  }
  else if (key == "c" && scene.IsAnyReal())
  {
    this->Workspace.Recenter();
    this->Second.Workspace.Recenter();
  }
  else if (key == "k" && scene.IsAnyReal())
  {
    this->Workspace.SetClutch(true);
    this->Second.Workspace.SetClutch(true);
  }
  else if ((key == "plus" || key == "minus") && scene.Device && scene.IsAnyReal())
  {
    const bool larger = key == "plus";
    scene.Style->SetWorkspaceScale(
      this->Workspace.GetScale() * (larger ? WorkspaceStep : 1.0 / WorkspaceStep));
  }
  else if (key == "Home" && scene.IsAnyReal())
  {
    this->HomeDevices();
  }
  else if (key == "m" && scene.Device)
  {
    this->NextMethod();
  }
  else if (key == "y" && scene.Device)
  {
    this->SwapSettings();
  }
  else if (key == "s" && scene.Slices)
  {
    scene.Slices->SetVisibility(!scene.Slices->GetVisibility());
  }
  else if (key == "j" && this->Modes.Next())
  {
    // Next() has already changed the mode, so there is nothing else to do.
  }
  else if (!this->Displays.Press(key) && !this->Editor.Press(key, isPressed) &&
    !this->Playback.Press(key) && !this->Measure.Press(key))
  {
    return false;
  }
  this->Frames.Draw(true);
  return true;
}

//------------------------------------------------------------------------------
bool HapticInteraction::ReleaseKey(const std::string& released)
{
  this->Repeat.RecordRelease(released);
  if (this->Keys.FindReleased(released) != "k")
  {
    return false;
  }
  this->Workspace.SetClutch(false);
  this->Second.Workspace.SetClutch(false);
  return true;
}

//------------------------------------------------------------------------------
void HapticInteraction::ArmOrDisarm()
{
  const vtkSmartPointer<vtkHapticDevice> devices[] = { this->Scene.Device,
    this->Second.Scene.Device };
  const bool isClutched = this->Workspace.IsClutched() || this->Second.Workspace.IsClutched();
  bool isArmedNow = false;
  for (const vtkSmartPointer<vtkHapticDevice>& device : devices)
  {
    const bool isThere = device && (device->IsRunning() || !devices[1]);
    if (isThere && !isClutched && !IsArmed(device))
    {
      device->Arm();
      // A refused Arm() has already reported the reason. With a single device, never disarm here.
      isArmedNow = isArmedNow || IsArmed(device) || !devices[1];
    }
  }
  for (const vtkSmartPointer<vtkHapticDevice>& device : devices)
  {
    if (device && !isArmedNow)
    {
      device->Disarm();
    }
  }
}

//------------------------------------------------------------------------------
void HapticInteraction::HomeDevices()
{
  std::vector<vtkSmartPointer<vtkHapticDevice>> real;
  for (const TouchedScene* const scene : { &this->Scene, &this->Second.Scene })
  {
    if (scene->IsReal())
    {
      real.emplace_back(scene->Device);
    }
  }
  const auto waits = [](const vtkSmartPointer<vtkHapticDevice>& device)
  {
    const int status = device->GetStatus();
    return status == vtkHapticDevice::HOMING || status == vtkHapticDevice::FIRMWARE ||
      status == vtkHapticDevice::FAULT;
  };
  const bool doesAnyWait = std::any_of(real.begin(), real.end(), waits);
  for (const vtkSmartPointer<vtkHapticDevice>& device : real)
  {
    if (!doesAnyWait || waits(device))
    {
      device->Home();
    }
  }
}

//------------------------------------------------------------------------------
bool HapticInteraction::TypeKey(const std::string& typed) const
{
  // While a hand touches or is armed, do not pass on keys of the superclass that would disturb it:
  // f would fly the camera away from the hand, and the workspace of a device with it. Never pass on
  // keys that have an action here and another in the superclass: m starts an animation, p picks a
  // prop, s shows surfaces, 3 shows red-blue stereo. Nor pass on keys that the application has
  // assigned to an action.
  const std::string key = this->FindAction(typed);
  const bool isBusy = this->Touch.IsOn() || this->Second.IsArmOrdered() ||
    (this->Scene.Device && this->Scene.Device->IsArmOrdered());
  const bool flies = typed == "f" || typed == "F" || typed == "Ctrl+f" || typed == "Ctrl+F";
  return (isBusy && flies) || key == "m" || key == "j" || (key == "s" && this->Scene.Slices) ||
    ((key == "p" || key == "u") && this->Scene.Editor) ||
    (key == "3" && this->Scene.Measurements) || (!key.empty() && key != typed);
}

//------------------------------------------------------------------------------
void HapticInteraction::HandleWork(vtkObject* worker, bool begins)
{
  auto& scene = this->Scene;
  if (worker == scene.Editor)
  {
    // Clear the member first, because EndLongWork() calls this function recursively.
    for (const auto& device : std::exchange(this->DevicesAtRest, {}))
    {
      device->EndLongWork();
    }
    const vtkSmartPointer<vtkHapticDevice> devices[] = { scene.Device, this->Second.Scene.Device };
    for (const vtkSmartPointer<vtkHapticDevice>& device : devices)
    {
      if (begins && device && worker == scene.Editor)
      {
        this->DevicesAtRest.push_back(device);
        device->BeginLongWork("materials are proposed", scene.Editor->EstimateUpdateTime());
      }
    }
    return;
  }
  vtkRenderWindowInteractor* const interactor = scene.Style->GetInteractor();
  vtkRenderWindow* const window = interactor ? interactor->GetRenderWindow() : nullptr;
  this->Frames.RecordEvent();
  if (begins && scene.Display && worker == scene.Device && scene.IsArmed() && window &&
    !window->CheckInRenderStatus())
  {
    this->Frames.Draw(true);
  }
}

//------------------------------------------------------------------------------
bool HapticInteraction::NextMethod()
{
  return this->Publisher.NextMethod(
    [this](const std::string& notice) { this->Frames.Notify(notice); });
}

//------------------------------------------------------------------------------
bool HapticInteraction::SwapSettings()
{
  return this->Compared.Swap([this](const std::string& notice) { this->Frames.Notify(notice); });
}

//------------------------------------------------------------------------------
bool HapticInteraction::UpdateHaptics()
{
  // Keep a reference to the style, because observers of an update may remove it. A device that they
  // set takes effect at the end of the update.
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  const bool isOuter = !std::exchange(this->IsUpdating, true);
  const bool isNew = this->Update(style);
  if (!isOuter)
  {
    return isNew;
  }
  this->IsUpdating = false;
  if (!this->NextDevice)
  {
    return isNew;
  }
  const vtkSmartPointer<vtkHapticDevice> next = *std::exchange(this->NextDevice, std::nullopt);
  this->SetDevice(next);
  return false;
}

//------------------------------------------------------------------------------
bool HapticInteraction::Update(vtkInteractorStyleHaptic* style)
{
  auto& scene = this->Scene;
  this->Window.Look();
  this->Window.LookAt(scene.ChooseRenderer());
  vtkRenderWindowInteractor* const interactor = style->GetInteractor();
  this->Repeat.Watch(interactor ? interactor->GetRenderWindow() : nullptr);
  this->Frames.SetWindow(
    interactor && style->GetAutoAdjustVolumeQuality() ? interactor->GetRenderWindow() : nullptr,
    style->GetAutoAdjustOffScreen());
  this->Editor.PollProposal();
  this->Displays.UpdateHint();
  this->Compared.Report();
  this->UpdateCarving();
  this->UpdateRefined();
  const vtkSmartPointer<vtkRenderer> renderer = scene.ChooseRenderer();
  if (this->Second.IsArmOrdered() && this->Window.HasVanished())
  {
    this->FadeOut();
  }
  // Update the first hand first, so that it leads the regions of a volume beyond memory.
  const bool isFirstNew = this->UpdateFirst(style, renderer);
  return this->Second.Update(renderer) || isFirstNew;
}

//------------------------------------------------------------------------------
bool HapticInteraction::UpdateFirst(vtkInteractorStyleHaptic* style, vtkRenderer* renderer)
{
  auto& scene = this->Scene;
  if (!scene.Device || !scene.Device->IsRunning())
  {
    if (this->Second.IsArmOrdered())
    {
      this->UpdateVolumes();
    }
    return false;
  }
  vtkHapticDevice* const device = scene.Device;
  // Publish changes before drawing, so that they are felt before they are seen.
  const bool isPlaced =
    renderer && !this->Workspace.IsClutched() && this->Workspace.Update(renderer);
  if ((this->Touch.IsOn() || device->IsArmOrdered()) && this->Window.HasVanished())
  {
    this->FadeOut();
  }
  this->UpdateVolumes();
  this->Touched.ChooseAhead(renderer);
  this->Publisher.Update(isPlaced);

  if (renderer)
  {
    this->ShownTimeSteps.Collect(renderer, device);
  }
  bool isNew = device->UpdateState();
  if (!device->IsRunning())
  {
    return false;
  }
  if (this->ShownTimeSteps.Show(device))
  {
    this->Frames.RecordEvent();
  }
  // Another style with this device may already have fetched the state, so compare its time with
  // this style's last update.
  const double before = std::exchange(this->Updated, device->GetState()->GetTime());
  if (this->Updated > before && renderer)
  {
    const double* const rate = device->GetState()->GetTurnRate();
    if (TurnView(renderer, { rate[0], rate[1], rate[2] }, this->Updated - before,
          style->GetAutoAdjustCameraClippingRange() != 0))
    {
      this->Frames.RecordEvent();
    }
  }
  this->Workspace.KeepClutch();
  device->GetState()->Drain(this->States, this->Reader);
  isNew = isNew || this->States->GetNumberOfRows() > 0;
  if (scene.Display)
  {
    scene.Display->AddStates(this->States);
  }
  this->Measure.Update(this->States);
  for (const unsigned long event : this->Watch.Watch(this->States))
  {
    this->Frames.RecordEvent();
    style->InvokeEvent(event);
  }
  if (isNew)
  {
    style->InvokeEvent(vtkInteractorStyleHaptic::StatesEvent);
  }
  this->CheckShownVolumes();
  // Detect that an observer of the events has ended the event loop.
  this->Window.Look();
  return isNew;
}

//------------------------------------------------------------------------------
void HapticInteraction::UpdateVolumes()
{
  this->Touched.Update();
  if (this->Scene.Hidden.empty())
  {
    return;
  }
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const bool isArmOrdered = device && device->IsArmOrdered();
  if (this->Touch.IsOn() || isArmOrdered || this->Second.IsArmOrdered())
  {
    vtkWarningWithObjectMacro(this->Scene.Style, << this->Scene.Hidden);
    // Hiding a volume is no emergency, so fade the force instead of cutting it off.
    this->FadeOut();
    return;
  }
  // Choose another volume only after the fade, because its surface could push the hand.
  if (device && this->Scene.Device == device && !this->Scene.IsArmed())
  {
    this->Touched.FeelShown();
  }
}

//------------------------------------------------------------------------------
void HapticInteraction::SetCoarseVolume(vtkVolume* volume)
{
  this->Refined.SetRenderer(nullptr);
  this->Refined.SetVolume(volume);
  this->UpdateRefined();
}

//------------------------------------------------------------------------------
void HapticInteraction::UpdateRefined()
{
  vtkVolume* const volume = this->Refined.GetVolume();
  vtkRenderWindowInteractor* const interactor = this->Scene.Style->GetInteractor();
  vtkRenderWindow* const window = interactor ? interactor->GetRenderWindow() : nullptr;
  if (!volume)
  {
    return;
  }
  vtkRenderer* shown = nullptr;
  vtkRendererCollection* const renderers = window ? window->GetRenderers() : nullptr;
  for (int i = 0; renderers && !shown && i < renderers->GetNumberOfItems(); ++i)
  {
    auto* const renderer = vtkRenderer::SafeDownCast(renderers->GetItemAsObject(i));
    shown = renderer && renderer->HasViewProp(volume) ? renderer : nullptr;
  }
  vtkVolumeHapticsFilter* const filter =
    this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
  this->Refined.SetVolumeHaptics(filter);
  this->Refined.SetSource(filter ? filter->GetRegionSource() : nullptr);
  this->Refined.SetRenderer(shown);
}

//------------------------------------------------------------------------------
void HapticInteraction::UpdateCarving()
{
  vtkRenderer* const renderer = this->Scene.ChooseRenderer();
  if (!renderer || !this->Scene.Device)
  {
    return;
  }
  const std::vector<CarvedArray> arrays = this->Touched.CollectCarved();
  // Count the changes, too, because slices and regions of large volumes also show removed tissue.
  std::uint64_t changes = 0;
  for (const CarvedArray& array : arrays)
  {
    changes += array.Removal->Bricks.GetChanges();
  }
  const bool isNew = changes != std::exchange(this->CarvedChanges, changes);
  if (this->Carved.Update(renderer, arrays) || isNew)
  {
    this->Frames.RecordEvent();
  }
}

//------------------------------------------------------------------------------
void HapticInteraction::CheckShownVolumes()
{
  vtkRenderer* const renderer = this->Scene.ChooseRenderer();
  vtkImageData* const image = this->Scene.GetImage();
  if (renderer && image)
  {
    vtkVolumeHapticsFilter* const filter = this->Scene.Device->GetVolumeHaptics();
    for (const std::string& warning : this->Volumes.Check(
           renderer, image, filter, this->ShownTimeSteps, this->Carved, this->Touched.Get()))
    {
      vtkWarningWithObjectMacro(this->Scene.Style, << warning);
    }
  }
}

} // namespace VolumeHaptics
