// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// In a file of its own, because X11's headers define macros with common names.
#include "VTK/Scene/Frames/HapticKeptDisplay.h"

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#include "vtkRenderingOpenGLConfigure.h"
#endif

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0) && defined(VTK_USE_X)
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkXOpenGLRenderWindow.h"

namespace VolumeHaptics
{
namespace
{

/** Gives access to a protected member of VTK. */
struct OpenedWindow : vtkXOpenGLRenderWindow
{
  static vtkTypeBool& Owns(vtkXOpenGLRenderWindow* window)
  {
    return window->*&OpenedWindow::OwnDisplay;
  }
};

/** Closes the connection when the window is deleted, with its interactor, so after the loop. */
void GiveBack(vtkObject* caller, unsigned long, void* display, void*)
{
  auto* const window = static_cast<vtkXOpenGLRenderWindow*>(caller);
  if (window->GetGenericDisplayId() == display)
  {
    OpenedWindow::Owns(window) = 1;
  }
}

} // namespace

void KeepDisplay(vtkRenderWindow* window)
{
  auto* const here = vtkXOpenGLRenderWindow::SafeDownCast(window);
  if (here && here->GetGenericDisplayId() && OpenedWindow::Owns(here))
  {
    OpenedWindow::Owns(here) = 0;
    vtkNew<vtkCallbackCommand> end;
    end->SetClientData(here->GetGenericDisplayId());
    end->SetCallback(GiveBack);
    here->AddObserver(vtkCommand::DeleteEvent, end);
  }
}

} // namespace VolumeHaptics
#else
void VolumeHaptics::KeepDisplay(vtkRenderWindow*) {}
#endif
