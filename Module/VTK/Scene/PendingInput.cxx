// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// In a file of its own, because X11's headers define macros with common names.
#include "VTK/Scene/PendingInput.h"

#include "vtkRenderWindow.h"

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

/** True would take the event out of the queue. */
Bool Note(Display*, XEvent* event, char* data)
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
      case ClientMessage: // of the window manager's close button
        search->Found = true;
        break;
      default:
        break;
    }
  }
  return False;
}

/** Of the library that VTK has loaded, in case it has: not every VTK is linked to it. */
decltype(&XCheckIfEvent) FindXCheckIfEvent()
{
  void* const library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  return library ? reinterpret_cast<decltype(&XCheckIfEvent)>(dlsym(library, "XCheckIfEvent"))
                 : nullptr;
}

decltype(&XCheckIfEvent) CheckIfEvent()
{
  static const auto found = FindXCheckIfEvent();
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
  CheckIfEvent()(static_cast<Display*>(window->GetGenericDisplayId()), &event, Note,
    reinterpret_cast<XPointer>(&search));
  return search.Found;
}

} // namespace

bool VolumeHaptics::KnowsInput(vtkRenderWindow* window)
{
  return window && CheckIfEvent() && window->IsA("vtkXOpenGLRenderWindow") &&
    window->GetGenericDisplayId();
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
#endif

namespace VolumeHaptics
{

bool HasPendingInput(vtkRenderWindow* window)
{
  return window->GetEventPending() || HasEvent(window);
}

} // namespace VolumeHaptics
