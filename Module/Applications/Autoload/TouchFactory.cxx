// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Adds a vtkHapticWidget to the windows of a program that was not built with this library. The
 * environment variable VOLUMEHAPTICS_PRESET names the widget's preset, such as "CT contrast".
 */
#include "Applications/Autoload/InteractorFactory.h"

#include "vtkABI.h"
#include "vtkCallbackCommand.h"
#include "vtkHapticProperty.h"
#include "vtkHapticWidget.h"
#include "vtkNew.h"
#include "vtkRenderingContext2DModule.h" // registers the class that draws the plot
#include "vtkWeakPointer.h"

#include <cstdlib>

namespace
{

/** An interactor's widget, and the observer that enables it. */
struct Touch
{
  vtkNew<vtkHapticWidget> Widget;
  vtkWeakPointer<vtkCallbackCommand> Observer;
};

/** Enables the widget once the interactor has a window. */
void Begin(vtkObject* caller, unsigned long event, void* data, void*)
{
  auto* const interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  auto* const touch = static_cast<Touch*>(data);
  // f3d removes all observers of timers when its event loop begins, including this library's.
  const bool isWhole = interactor->HasObserver(vtkCommand::TimerEvent, touch->Observer) != 0;
  if (event == vtkCommand::TimerEvent || !interactor->GetRenderWindow() ||
    (touch->Widget->GetEnabled() && (isWhole || touch->Widget->GetTouchMode())))
  {
    return;
  }
  if (!isWhole)
  {
    interactor->AddObserver(vtkCommand::TimerEvent, touch->Observer);
  }
  touch->Widget->Off();
  touch->Widget->SetInteractor(interactor);
  touch->Widget->On();
}

class TouchFactory : public VolumeHaptics::InteractorFactory
{
public:
  static TouchFactory* New();
  vtkTypeMacro(TouchFactory, VolumeHaptics::InteractorFactory);
  const char* GetDescription() override { return "Volumes in windows of VTK can be touched"; }

protected:
  void Attach(vtkRenderWindowInteractor* made) override
  {
    auto* const touch = new Touch;
    if (const char* const preset = std::getenv("VOLUMEHAPTICS_PRESET"))
    {
      // reports an error that lists the presets if the name is wrong
      touch->Widget->GetProperty()->ApplyPreset(preset);
    }
    vtkNew<vtkCallbackCommand> begin;
    touch->Observer = begin;
    begin->SetClientData(touch);
    begin->SetClientDataDeleteCallback([](void* data) { delete static_cast<Touch*>(data); });
    begin->SetCallback(Begin);
    for (const unsigned long event :
      { vtkCommand::EnableEvent, vtkCommand::RenderEvent, vtkCommand::MouseMoveEvent })
    {
      made->AddObserver(event, begin, 1.0f); // a higher priority than the widget's
    }
  }
};

vtkStandardNewMacro(TouchFactory);

} // namespace

// VTK declares these functions as exported by CommonCore, so other libraries can't define them on
// Windows.
#undef VTK_FACTORY_INTERFACE_EXPORT
#define VTK_FACTORY_INTERFACE_EXPORT VTK_ABI_EXPORT
VTK_FACTORY_INTERFACE_IMPLEMENT(TouchFactory)
