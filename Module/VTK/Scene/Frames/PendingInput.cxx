// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// This file exists because X11's headers define macros with common names.
#include "VTK/Scene/Frames/PendingInput.h"

#include "vtkRenderWindow.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#include "vtkRenderingOpenGLConfigure.h"
#endif

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0) && defined(VTK_USE_X)
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkXOpenGLRenderWindow.h"
#endif

#if defined(__linux__) && __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>

#include <dlfcn.h>

namespace
{

struct Search
{
  Window Of;
  bool Found;
};

/**
 * Records whether a queued event is input. Always returns false, because true would remove the
 * event from the queue.
 */
Bool Record(Display*, XEvent* event, char* data)
{
  auto* const search = reinterpret_cast<Search*>(data);
  if (event->xany.window == search->Of)
  {
    switch (event->type)
    {
      case KeyPress:
      case ButtonPress:
      case ButtonRelease:
      case MotionNotify:
      case ClientMessage: // close button of the window manager
        search->Found = true;
        break;
      default:
        break;
    }
  }
  return False;
}

/**
 * Returns a function of libX11 if this process has loaded that library; nullptr otherwise. Not
 * every build of VTK links X11.
 */
template <typename Function>
Function* FindFunction(const char* name)
{
  void* const library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  return library ? reinterpret_cast<Function*>(dlsym(library, name)) : nullptr;
}

decltype(&XCheckIfEvent) CheckIfEvent()
{
  static const auto found = FindFunction<decltype(XCheckIfEvent)>("XCheckIfEvent");
  return found;
}

bool HasEvent(vtkRenderWindow* window)
{
  if (!VolumeHaptics::KnowsInput(window))
  {
    return false;
  }
  Search search{ reinterpret_cast<Window>(window->GetGenericWindowId()), false };
  XEvent event;
  CheckIfEvent()(static_cast<Display*>(window->GetGenericDisplayId()), &event, Record,
    reinterpret_cast<XPointer>(&search));
  return search.Found;
}

/** Ignores errors of X11, because the toolkit that owns the window may have destroyed it. */
int IgnoreError(Display*, XErrorEvent*)
{
  return 0;
}

} // namespace

bool VolumeHaptics::MayBeSeen(vtkRenderWindow* window)
{
  static const auto get = FindFunction<decltype(XGetWindowAttributes)>("XGetWindowAttributes");
  static const auto handle = FindFunction<decltype(XSetErrorHandler)>("XSetErrorHandler");
  const auto id = KnowsInput(window) ? reinterpret_cast<Window>(window->GetGenericWindowId()) : 0;
  if (id == 0 || !get || !handle)
  {
    return true;
  }
  const XErrorHandler before = handle(IgnoreError);
  XWindowAttributes attributes = {};
  const bool isThere =
    get(static_cast<Display*>(window->GetGenericDisplayId()), id, &attributes) != 0;
  handle(before);
  return isThere && attributes.map_state == IsViewable;
}

bool VolumeHaptics::KnowsInput(vtkRenderWindow* window)
{
  return window && CheckIfEvent() && window->IsA("vtkXOpenGLRenderWindow") &&
    window->GetGenericDisplayId();
}

void VolumeHaptics::WakeEventLoop(vtkRenderWindow* window)
{
  static const auto send = FindFunction<decltype(XSendEvent)>("XSendEvent");
  static const auto flush = FindFunction<decltype(XFlush)>("XFlush");
  const auto id = KnowsInput(window) ? reinterpret_cast<Window>(window->GetGenericWindowId()) : 0;
  if (id == 0 || !send || !flush)
  {
    return;
  }
  auto* const display = static_cast<Display*>(window->GetGenericDisplayId());
  XEvent event = {};
  event.type = NoExpose; // an event about copied areas, which VTK ignores
  event.xnoexpose.drawable = id;
  send(display, id, False, NoEventMask, &event);
  flush(display);
}
#else
namespace
{
bool HasEvent(vtkRenderWindow*)
{
  return false;
}
} // namespace

bool VolumeHaptics::KnowsInput(vtkRenderWindow*)
{
  return false;
}

void VolumeHaptics::WakeEventLoop(vtkRenderWindow*) {}

bool VolumeHaptics::MayBeSeen(vtkRenderWindow*)
{
  return true;
}
#endif

namespace VolumeHaptics
{

bool HasPendingInput(vtkRenderWindow* window)
{
  return window->GetEventPending() || HasEvent(window);
}

} // namespace VolumeHaptics

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0) && defined(VTK_USE_X)
namespace VolumeHaptics
{
namespace
{

/** Subclass that only gives access to a protected member of vtkXOpenGLRenderWindow. */
struct OpenedWindow : vtkXOpenGLRenderWindow
{
  static vtkTypeBool& Owns(vtkXOpenGLRenderWindow* window)
  {
    return window->*&OpenedWindow::OwnDisplay;
  }
};

/**
 * Lets the window close the connection when it is deleted. This happens with its interactor, and
 * therefore after the loop.
 */
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
