// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Frames/HapticWindowWatch.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Scene/Frames/PendingInput.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <utility>

namespace VolumeHaptics
{

/**
 * Detects the end of a window: before a window is finalized or destroyed, it makes each texture in
 * its context release its resources. This class is therefore a texture, though without pixels. VTK
 * has a callback for this purpose, but does not install its header.
 */
class HapticWindowWatch::Closing final : public vtkTextureObject
{
public:
  vtkTypeMacro(Closing, vtkTextureObject);
  static Closing* New() { return new Closing; }

  /** Sets the watched window; nullptr stops watching. */
  void SetWindow(vtkOpenGLRenderWindow* window)
  {
    // During a release, do nothing: the window itself removes this object from its list after the
    // call.
    if (window != this->Window && !this->IsInRelease)
    {
      // Leaving a window also calls ReleaseGraphicsResources(), which is then not a sign of the
      // window's end.
      this->IsInRelease = true;
      this->SetContext(window);
      this->IsInRelease = false;
      this->Window = window;
    }
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    const vtkSmartPointer<Closing> keep(this);
    this->Superclass::ReleaseGraphicsResources(window);
    if (this->IsInRelease)
    {
      return;
    }
    this->IsInRelease = true;
    this->Window = nullptr;
    if (this->Watch)
    {
      this->Watch->OnRelease();
    }
    this->IsInRelease = false;
    if (this->GetReferenceCount() == 1)
    {
      // If an observer has deleted the style, and so the watch, keep this object alive: the window
      // still uses it after the call.
      static vtkSmartPointer<Closing> last;
      last = this;
    }
  }
  HapticWindowWatch* Watch = nullptr;

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  bool IsInRelease = false;
};

/**
 * The observer is a separate class, so that a watch can recognise the observers of other watches.
 */
class HapticWindowWatch::Observer final : public vtkCommand
{
public:
  vtkTypeMacro(Observer, vtkCommand);
  static Observer* New() { return new Observer; }
  void Execute(vtkObject*, unsigned long event, void*) override
  {
    switch (event)
    {
      case vtkCommand::ExitEvent:
        this->Watch->OnExit();
        break;
      case vtkCommand::ModifiedEvent:
        this->Watch->OnModified();
        break;
      case vtkCommand::StartEvent:
        this->Watch->OnRender();
        break;
      default:
        this->Watch->Look();
    }
  }
  HapticWindowWatch* Watch = nullptr;

  /**
   * Returns whether the application observes an interactor's ExitEvent, that is, whether the event
   * has an observer that does not belong to a watch.
   */
  static bool IsExitTaken(vtkRenderWindowInteractor* interactor)
  {
    // Tags ascend, so the tag of a new observer is above all tags in use.
    vtkNew<Observer> last;
    const unsigned long end = interactor->AddObserver(vtkCommand::NoEvent, last);
    interactor->RemoveObserver(end);
    for (unsigned long tag = 1; tag < end; ++tag)
    {
      vtkCommand* const command = interactor->GetCommand(tag);
      if (command && !dynamic_cast<Observer*>(command) &&
        interactor->HasObserver(vtkCommand::ExitEvent, command))
      {
        return true;
      }
    }
    return false;
  }
};

HapticWindowWatch::HapticWindowWatch(vtkObject* owner, std::function<void()> end)
  : Owner(owner)
  , ReportEnd(std::move(end))
  , Events(vtkSmartPointer<Observer>::New())
  , WindowClosing(vtkSmartPointer<Closing>::New())
{
  this->Events->Watch = this;
  this->WindowClosing->Watch = this;
}

HapticWindowWatch::~HapticWindowWatch()
{
  this->SetInteractor(nullptr);
  this->WindowClosing->Watch = nullptr;
}

void HapticWindowWatch::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Events);
  }
  this->OnRender();
  this->WindowClosing->SetWindow(nullptr);
  this->Interactor = interactor;
  this->WasViewable = false;
  if (interactor)
  {
    this->IsEnabled = interactor->GetEnabled() != 0;
    this->IsDone = interactor->GetDone();
    // Call the watch before the application's observers, because these may take long, for example
    // to ask the user whether to quit.
    interactor->AddObserver(vtkCommand::ExitEvent, this->Events, VTK_FLOAT_MAX);
    interactor->AddObserver(vtkCommand::ModifiedEvent, this->Events);
    // Call the watch after the application's observers, because these may call TerminateApp(), and
    // the loop then ends with these events.
    for (const unsigned long event :
      { vtkCommand::KeyPressEvent, vtkCommand::KeyReleaseEvent, vtkCommand::CharEvent,
        vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
        vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
        vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent,
        vtkCommand::MouseMoveEvent, vtkCommand::TimerEvent })
    {
      interactor->AddObserver(event, this->Events, -VTK_FLOAT_MAX);
    }
    this->Look();
  }
}

void HapticWindowWatch::Look()
{
  if (!this->Interactor)
  {
    return;
  }
  vtkRenderWindow* const window = this->Interactor->GetRenderWindow();
  const bool wasDone = std::exchange(this->IsDone, this->Interactor->GetDone());
  if (!this->IsReleased)
  {
    // Do not watch a window that was never rendered, since it has no resources to release.
    const bool isRendered = window && !window->GetNeverRendered();
    this->WindowClosing->SetWindow(
      isRendered ? vtkOpenGLRenderWindow::SafeDownCast(window) : nullptr);
    KeepDisplay(window);
  }
  if (this->IsDone && !wasDone)
  {
    this->End();
  }
}

void HapticWindowWatch::LookAt(vtkRenderer* renderer)
{
  vtkRenderWindow* const window = this->Interactor ? this->Interactor->GetRenderWindow() : nullptr;
  const auto isShown = [window](vtkRenderer* shown)
  { return shown && window && window->HasRenderer(shown); };
  const bool isGone = this->HasSeen && !isShown(this->Seen);
  this->HasSeen = isShown(renderer);
  this->Seen = this->HasSeen ? renderer : nullptr;
  if (isGone)
  {
    this->End();
  }
}

bool HapticWindowWatch::HasVanished()
{
  constexpr double pause = 0.1; // s
  vtkRenderWindow* const window = this->Interactor ? this->Interactor->GetRenderWindow() : nullptr;
  if (!window || window->GetNeverRendered() || ServoClock::SecondsSince(this->ViewTime) < pause)
  {
    return false;
  }
  this->ViewTime = ServoClock::Now();
  const bool wasViewable = std::exchange(this->WasViewable, MayBeSeen(window));
  return wasViewable && !this->WasViewable;
}

bool HapticWindowWatch::IsClosed() const
{
  return this->IsReleased && this->Interactor && this->Interactor->GetDone();
}

void HapticWindowWatch::OnExit()
{
  const vtkSmartPointer<vtkObject> keep(this->Owner);
  const vtkSmartPointer<vtkRenderWindowInteractor> interactor(this->Interactor.GetPointer());
  KeepDisplay(interactor->GetRenderWindow());
  this->End();
  // ExitCallback() calls TerminateApp() only if ExitEvent has no observers. Terminate here if this
  // watch is the only one.
  if (!Observer::IsExitTaken(interactor))
  {
    interactor->TerminateApp();
  }
}

void HapticWindowWatch::OnModified()
{
  const bool wasEnabled = std::exchange(this->IsEnabled, this->Interactor->GetEnabled() != 0);
  if (wasEnabled && !this->IsEnabled)
  {
    this->End();
  }
}

void HapticWindowWatch::OnRelease()
{
  this->IsReleased = true;
  vtkRenderWindow* const window = this->Interactor ? this->Interactor->GetRenderWindow() : nullptr;
  if (window && window->GetReferenceCount() > 0)
  {
    this->ReleasedWindow = window;
    window->AddObserver(vtkCommand::StartEvent, this->Events);
  }
  this->End();
}

void HapticWindowWatch::OnRender()
{
  this->IsReleased = false;
  if (this->ReleasedWindow)
  {
    this->ReleasedWindow->RemoveObserver(this->Events);
    this->ReleasedWindow = nullptr;
  }
}

void HapticWindowWatch::End()
{
  const vtkSmartPointer<vtkObject> keep(this->Owner);
  this->ReportEnd();
}

} // namespace VolumeHaptics
