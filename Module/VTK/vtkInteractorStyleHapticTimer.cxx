// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The part of vtkInteractorStyleHaptic that its timer drives: from the servo and back, and when to
// draw.
#include "vtkInteractorStyleHaptic.h"

#include "VTK/Baking/HapticMethods.h"
#include "VTK/Scene/HapticViewRay.h"
#include "vtkInteractorStyleHapticInternals.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkTransform.h"

#include <algorithm>
#include <utility>

using namespace VolumeHaptics;

namespace
{
/// What of a pause the view turns for (s): nobody saw the rest.
constexpr double LongestTurn = 0.1;
} // namespace

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnTimer()
{
  auto& d = *this->Internals;
  if (!this->Interactor)
  {
    return;
  }
  if (d.FiredTimer != d.Timer)
  {
    this->Superclass::OnTimer();
    return;
  }
  using Frame = HapticRenderPace::Frame;
  const bool isNew = this->UpdateHaptics();
  const bool moves = this->State != VTKIS_NONE || this->HasMoved();
  const double now = vtkTimerLog::GetUniversalTime();
  const Frame frame = d.Pace.Next(now, moves, isNew);
  if (frame == Frame::None)
  {
    return;
  }
  this->Draw(frame == Frame::Quick);
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::DrawScene(bool quickly)
{
  if (!this->Interactor)
  {
    return;
  }
  // What VTK calls down-sampling: mappers draw as well as the wanted rate of frames lets them.
  if (vtkRenderWindow* window = this->Interactor->GetRenderWindow())
  {
    window->SetDesiredUpdateRate(
      quickly ? this->Interactor->GetDesiredUpdateRate() : this->Interactor->GetStillUpdateRate());
  }
  this->Interactor->Render();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::Draw(bool quickly)
{
  auto& d = *this->Internals;
  if (!this->Interactor || d.Window.IsClosed())
  {
    return;
  }
  if (d.Editor && d.Editor->GetVisibility())
  {
    // Before the frame: once that is under way, nothing can be shown any more.
    d.Editor->Update();
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->DrawScene(quickly);
  const double end = vtkTimerLog::GetUniversalTime();
  d.Pace.Drawn(quickly, end, end - start);
  d.HasHappened = false;
  if (d.Device)
  {
    const double* const tip = d.Device->GetTipPosition();
    const double* const proxy = d.Device->GetProxyPosition();
    d.DrawnTip = { tip[0], tip[1], tip[2] };
    d.DrawnProxy = { proxy[0], proxy[1], proxy[2] };
  }
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::HasMoved()
{
  auto& d = *this->Internals;
  vtkRenderer* const renderer = this->GetHapticRenderer();
  if (d.HasHappened || !d.Device || !renderer || !renderer->IsActiveCameraCreated())
  {
    return d.HasHappened;
  }
  const double* const t = d.Device->GetTipPosition();
  const double* const p = d.Device->GetProxyPosition();
  const Vector3 tip{ t[0], t[1], t[2] };
  const Vector3 proxy{ p[0], p[1], p[2] };
  const int here[2] = { 0, 0 };
  const int beside[2] = { 1, 0 };
  const double pixel =
    Norm(UnderPointer(renderer, beside, tip) - UnderPointer(renderer, here, tip));
  // A hand never holds quite still: what nobody can see is no movement.
  return Norm(tip - d.DrawnTip) > 0.5 * pixel || Norm(proxy - d.DrawnProxy) > 0.5 * pixel;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::Notify(const std::string& notice)
{
  auto& d = *this->Internals;
  if (!d.Display || notice == d.Display->GetNotice())
  {
    return;
  }
  d.Display->SetNotice(notice.c_str());
  if (this->Interactor && this->Interactor->GetRenderWindow())
  {
    this->Draw(true);
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::FollowWork(vtkObject* worker, bool begins)
{
  auto& d = *this->Internals;
  if (worker == d.Editor)
  {
    if (d.DeviceAtRest)
    {
      // Taken first, since the end of the work calls back.
      const auto device = std::move(d.DeviceAtRest);
      d.DeviceAtRest = nullptr;
      device->EndLongWork();
    }
    if (begins && d.Device && d.Editor)
    {
      d.DeviceAtRest = d.Device;
      d.Device->BeginLongWork("the histogram is counted", d.Editor->EstimateUpdateTime());
    }
    return;
  }
  vtkRenderWindow* const window = this->Interactor ? this->Interactor->GetRenderWindow() : nullptr;
  d.HasHappened = true;
  if (begins && d.Display && worker == d.Device && d.IsArmed() && window &&
    !window->CheckInRenderStatus())
  {
    this->Draw(true);
  }
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::NextMethod()
{
  auto& d = *this->Internals;
  // Observers of what follows may take any of these away.
  const vtkSmartPointer<vtkInteractorStyleHaptic> self(this);
  const vtkSmartPointer<vtkHapticDevice> device = d.Device;
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter =
    device ? device->GetVolumeHaptics() : nullptr;
  if (!filter)
  {
    vtkErrorMacro(
      "There is no method to change: SetDevice() one that SetVolumeHaptics() was called on.");
    return false;
  }
  const int method = filter->GetMethod();
  const int solver = filter->GetSolver();
  const std::string before = filter->GetMethodText();
  const bool wasPublished = d.Published == d.GetChangeTime();
  if (!d.Unfelt.empty() && d.FeltInstead == before)
  {
    filter->SetMethodByName(d.Unfelt.c_str());
  }
  filter->NextMethod();
  const std::string wanted = filter->GetMethodText();
  const bool isPrepared = GetMethodChoice(filter->GetMethod(), filter->GetSolver()).IsPrepared;
  this->Notify(isPrepared ? wanted + " is being prepared ..." : "");
  d.Unfelt.clear();
  const bool isFelt = device->Publish();
  const bool isOurs = d.Device == device;
  if (isFelt)
  {
    d.Published = isOurs ? d.GetChangeTime() : d.Published;
    this->Notify("");
    return true;
  }
  d.Unfelt = filter->GetMethodName();
  d.FeltInstead = before;
  filter->SetMethod(method);
  filter->SetSolver(solver);
  // The servo has never had anything else, unless there is more to be published.
  d.Published = isOurs && wasPublished ? d.GetChangeTime() : 0;
  vtkErrorMacro(<< wanted << " can't be felt here, for the reason given before; " << before
                << " goes on.");
  this->Notify(wanted + " can't be felt here: see the messages.\n" + before + " goes on.");
  return false;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::TurnVolume(vtkRenderer* renderer, double time)
{
  const double* const t = this->Internals->Device->GetTurnRate();
  const Vector3 rate{ t[0], t[1], t[2] };
  const double angle = Norm(rate) * std::clamp(time, 0.0, LongestTurn);
  if (angle == 0.0)
  {
    return;
  }
  // What the eye sees turning with the cap is the camera turning the other way.
  vtkCamera* const camera = renderer->GetActiveCamera();
  const double* const focus = camera->GetFocalPoint();
  const Vector3 axis = Transpose(CameraAxes(camera)) * rate;
  vtkNew<vtkTransform> turn;
  turn->Translate(focus);
  turn->RotateWXYZ(-vtkMath::DegreesFromRadians(angle), axis.X, axis.Y, axis.Z);
  turn->Translate(-focus[0], -focus[1], -focus[2]);
  camera->ApplyTransform(turn);
  camera->OrthogonalizeViewUp();
  if (this->AutoAdjustCameraClippingRange)
  {
    renderer->ResetCameraClippingRange();
  }
  this->Internals->HasHappened = true;
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::UpdateHaptics()
{
  auto& d = *this->Internals;
  d.Window.Look();
  if (!d.Device || !d.Device->IsRunning())
  {
    return false;
  }
  // Observers of what follows may take any of these away.
  const vtkSmartPointer<vtkInteractorStyleHaptic> self(this);
  const vtkSmartPointer<vtkHapticDevice> device = d.Device;
  const vtkSmartPointer<vtkRenderer> renderer = this->GetHapticRenderer();
  // What has changed goes to the servo first, so that it is felt before it is seen.
  const bool placed = renderer && !this->Clutch && this->PlaceWorkspace(renderer);
  if (d.Device != device)
  {
    return false;
  }
  const vtkMTimeType time = d.GetChangeTime();
  // Somebody else may have published it.
  const bool hasChanged = time != d.Published && !device->IsPublished();
  d.Published = time;
  if (placed || hasChanged)
  {
    // Once, also where it fails: it will not succeed before something changes.
    if (device->Publish() && hasChanged && d.Display)
    {
      d.Display->SetNotice("");
    }
  }

  bool isNew = device->UpdateState();
  if (d.Device != device || !device->IsRunning())
  {
    return false;
  }
  // Another style with this device may have taken the state before.
  const double before = std::exchange(d.Updated, device->GetTime());
  if (d.Updated > before && renderer)
  {
    this->TurnVolume(renderer, d.Updated - before);
  }
  if (d.Device != device)
  {
    return false;
  }
  if (this->Clutch && d.IsArmed())
  {
    // By a button or a script, or not yet seen as disarmed. The hand moves without the tip, and
    // must not be held.
    const bool arms = d.ArmAfterClutch;
    device->Disarm();
    if (d.Device != device)
    {
      return false;
    }
    d.ArmAfterClutch = arms;
  }
  device->DrainStates(d.States, d.Reader);
  isNew = isNew || d.States->GetNumberOfRows() > 0;
  if (d.Display)
  {
    d.Display->AddStates(d.States);
  }
  for (const unsigned long event : d.Watch.Watch(d.States))
  {
    d.HasHappened = true;
    this->InvokeEvent(event);
  }
  if (isNew)
  {
    this->InvokeEvent(StatesEvent);
  }
  this->CheckShownVolumes();
  // An observer of the events may have ended the loop.
  d.Window.Look();
  return isNew;
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::CheckShownVolumes()
{
  auto& d = *this->Internals;
  vtkRenderer* const renderer = this->GetHapticRenderer();
  vtkVolumeHapticsFilter* const filter = d.Device ? d.Device->GetVolumeHaptics() : nullptr;
  auto* const image =
    filter ? vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0)) : nullptr;
  if (renderer && image)
  {
    for (const std::string& warning : d.Volumes.Check(renderer, image))
    {
      vtkWarningMacro(<< warning);
    }
  }
}
