// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Drops a file on a window, as a file manager does; usage: DropFile WINDOW FILE. Plays the source
// in the drag-and-drop protocol of X (XDND, version 5), without a mouse. Exits with 0 if the window
// has taken the file.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

namespace
{
class Source
{
public:
  Source(Window target, const std::string& file)
    : Shown(XOpenDisplay(nullptr))
    , Target(target)
    , Uri("file://" + file + "\r\n")
  {
    if (this->Shown)
    {
      this->Own =
        XCreateSimpleWindow(this->Shown, DefaultRootWindow(this->Shown), 0, 0, 1, 1, 0, 0, 0);
      XSetSelectionOwner(this->Shown, this->FindAtom("XdndSelection"), this->Own, CurrentTime);
    }
  }

  bool Drop()
  {
    if (!this->Shown)
    {
      return false;
    }
    constexpr long version = 5;
    this->Send(
      "XdndEnter", version << 24, static_cast<long>(this->FindAtom("text/uri-list")), 0, 0);
    this->Send("XdndPosition", 0, 100L << 16 | 100L, CurrentTime,
      static_cast<long>(this->FindAtom("XdndActionCopy")));
    if (!this->WaitFor("XdndStatus"))
    {
      return false;
    }
    this->Send("XdndDrop", 0, CurrentTime, 0, 0);
    return this->WaitFor("XdndFinished");
  }

private:
  Atom FindAtom(const char* name) { return XInternAtom(this->Shown, name, False); }

  void Send(const char* type, long first, long second, long third, long fourth)
  {
    XEvent event = {};
    event.xclient.type = ClientMessage;
    event.xclient.window = this->Target;
    event.xclient.message_type = this->FindAtom(type);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(this->Own);
    event.xclient.data.l[1] = first;
    event.xclient.data.l[2] = second;
    event.xclient.data.l[3] = third;
    event.xclient.data.l[4] = fourth;
    XSendEvent(this->Shown, this->Target, False, NoEventMask, &event);
    XFlush(this->Shown);
  }

  void Answer(const XSelectionRequestEvent& request)
  {
    XChangeProperty(this->Shown, request.requestor, request.property, request.target, 8,
      PropModeReplace, reinterpret_cast<const unsigned char*>(this->Uri.data()),
      static_cast<int>(this->Uri.size()));
    XEvent event = {};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(this->Shown, request.requestor, False, NoEventMask, &event);
    XFlush(this->Shown);
  }

  /// Waits up to half a minute for a message of this type, and answers requests meanwhile.
  bool WaitFor(const char* type)
  {
    const Atom wanted = this->FindAtom(type);
    for (int i = 0; i < 3000; ++i)
    {
      while (XPending(this->Shown) > 0)
      {
        XEvent event;
        XNextEvent(this->Shown, &event);
        if (event.type == SelectionRequest)
        {
          this->Answer(event.xselectionrequest);
        }
        else if (event.type == ClientMessage && event.xclient.message_type == wanted)
        {
          return true;
        }
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::cerr << "no " << type << " came\n";
    return false;
  }

  Display* const Shown;
  const Window Target;
  const std::string Uri;
  Window Own = 0;
};
} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    return 2;
  }
  Source source(std::strtoul(argv[1], nullptr, 0), argv[2]);
  return source.Drop() ? 0 : 1;
}
