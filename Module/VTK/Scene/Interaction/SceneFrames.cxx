// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/SceneFrames.h"

#include "VTK/Scene/Base/HapticViewRay.h"
#include "VTK/Scene/Frames/HapticWindowWatch.h"
#include "VTK/Scene/Frames/PendingInput.h"

#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace VolumeHaptics
{

namespace
{
// s: After a longer frame, wake the event loop, because VTK 9.1 delays timers that are 1 s late by
// another second.
constexpr double LongestTimerDelay = 0.8;
} // namespace

SceneFrames::SceneFrames(
  TouchedScene& scene, const HapticWindowWatch& window, std::function<void(bool)> drawScene)
  : Scene(scene)
  , Window(window)
  , DrawScene(std::move(drawScene))
  , Quality(
      [this]
      {
        using Touch = FrameQuality::Touch;
        vtkHapticDevice* const device = this->Scene.Device;
        const bool isArmed = device && this->Scene.IsArmed();
        // A playing volume counts as touched, because it is rendered continuously.
        const bool isBusy = this->Scene.Style->GetTouchMode() ||
          (device && device->GetPlayback()->HasTimeSteps() && device->GetPlayback()->IsPlaying());
        return isArmed ? Touch::Armed : isBusy ? Touch::On : Touch::Off;
      })
{
}

void SceneFrames::Draw(bool quickly)
{
  if (!this->Scene.Style->GetInteractor() || this->Window.IsClosed())
  {
    return;
  }
  vtkHapticFunctionEditor* const editor = this->Scene.Editor;
  if (editor && editor->GetVisibility())
  {
    // Update the editor before the frame, because its long work redraws the head-up display, which
    // is impossible during a frame.
    editor->Update();
    this->CountedFraction = editor->GetCountedFraction();
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->DrawScene(quickly);
  const double end = vtkTimerLog::GetUniversalTime();
  this->Pace.Drawn(quickly, end, end - start);
  this->HasHappened = false;
  vtkRenderWindowInteractor* const interactor = this->Scene.Style->GetInteractor();
  if (end - start > LongestTimerDelay && interactor && !this->Window.IsClosed() &&
    interactor->IsA("vtkXRenderWindowInteractor"))
  {
    WakeEventLoop(interactor->GetRenderWindow());
  }
  if (this->Scene.Device)
  {
    this->DrawnTip = this->Scene.GetTip();
    this->DrawnProxy = this->Scene.GetProxy();
  }
}

bool SceneFrames::DrawWhole()
{
  constexpr int most = 6; // frames; while armed, a slow frame is drawn again with fewer rays
  this->Quality.SetInterruptible(false);
  auto why = FrameQuality::Interruption::Slow;
  for (int i = 0; i < most && why != FrameQuality::Interruption::None; ++i)
  {
    this->Quality.DrainInterruption();
    this->Draw(false);
    why = this->Quality.DrainInterruption();
  }
  this->Quality.SetInterruptible(true);
  return this->Scene.Style->GetInteractor() && !this->Window.IsClosed();
}

void SceneFrames::PollEditor()
{
  constexpr double step = 0.05;
  vtkHapticFunctionEditor* const editor = this->Scene.Editor;
  if (editor && editor->GetVisibility() && this->CountedFraction < 1.0)
  {
    editor->Update();
    const double fraction = editor->GetCountedFraction();
    this->HasHappened =
      this->HasHappened || fraction == 1.0 || fraction > this->CountedFraction + step;
  }
}

bool SceneFrames::DrawIfDue(bool isNew)
{
  using Frame = HapticRenderPace::Frame;
  this->PollEditor();
  const double now = vtkTimerLog::GetUniversalTime();
  switch (this->Quality.DrainInterruption())
  {
    case FrameQuality::Interruption::Input:
    case FrameQuality::Interruption::Resized:
      this->Pace.Interrupted(now);
      break;
    case FrameQuality::Interruption::Slow:
      this->Pace.GivenUp();
      break;
    case FrameQuality::Interruption::None:
      break;
  }
  const bool moves = this->Scene.Style->GetState() != VTKIS_NONE || this->HasMoved();
  const Frame frame = this->Pace.Next(now, moves, isNew, this->IsIdle());
  if (frame != Frame::None)
  {
    this->Draw(frame == Frame::Quick);
  }
  return frame != Frame::None;
}

bool SceneFrames::IsIdle() const
{
  vtkRenderWindowInteractor* const interactor = this->Scene.Style->GetInteractor();
  vtkRenderWindow* const window = interactor ? interactor->GetRenderWindow() : nullptr;
  return KnowsInput(window) && !HasPendingInput(window);
}

bool SceneFrames::AwaitLateMotion(double travel) const
{
  if (!this->Scene.Device || !this->Scene.Style->GetTouchMode() || !this->IsIdle())
  {
    return false;
  }
  const double now = vtkTimerLog::GetUniversalTime();
  const bool isFirst = this->Pace.IsFirst(now);
  if (isFirst)
  {
    // Wait for the hand to arrive: a slow frame of it on its way would take longer than the rest of
    // the way.
    std::this_thread::sleep_for(std::chrono::duration<double>(
      std::min(HapticRenderPace::FeltTime + travel, HapticRenderPace::LongestAwaited)));
  }
  return isFirst || this->Pace.IsLate(now);
}

bool SceneFrames::HasMoved() const
{
  vtkRenderer* const renderer = this->Scene.ChooseRenderer();
  if (this->HasHappened || !this->Scene.Device || !renderer || !renderer->IsActiveCameraCreated())
  {
    return this->HasHappened;
  }
  const Vector3 tip = this->Scene.GetTip();
  const double pixel = PixelSize(renderer, tip);
  // A hand never rests completely, so ignore motions of less than half a pixel.
  return Norm(tip - this->DrawnTip) > 0.5 * pixel ||
    Norm(this->Scene.GetProxy() - this->DrawnProxy) > 0.5 * pixel;
}

void SceneFrames::Notify(const std::string& notice)
{
  vtkHapticHeadUpDisplay* const display = this->Scene.Display;
  if (!display || notice == display->GetNotice())
  {
    return;
  }
  display->SetNotice(notice.c_str());
  vtkRenderWindowInteractor* const interactor = this->Scene.Style->GetInteractor();
  if (interactor && interactor->GetRenderWindow())
  {
    this->Draw(true);
  }
}

} // namespace VolumeHaptics
