// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects the repeated presses of a held key.
 */
#ifndef KeyRepeat_h
#define KeyRepeat_h

#include "vtkRenderWindow.h"

#include <chrono>
#include <string>

#if defined(__linux__)
#include <dlfcn.h>
#endif

namespace VolumeHaptics
{

/**
 * Distinguishes presses that a window system generates for a held key from real presses.
 *
 * An X server sends the release and the next press of a held key at the same time, and VTK passes
 * on both. A server that has the extension XKB leaves out these releases when it is asked to.
 * Without it, two presses within a few milliseconds count as one: a hand can't press a key again so
 * fast, but a window that draws slowly passes its presses on as fast.
 */
class KeyRepeat
{
public:
  /** Asks the X server of an open window to leave out the releases. Does nothing elsewhere. */
  void Watch(vtkRenderWindow* window)
  {
    void* const display =
      window && !window->GetOffScreenRendering() && window->IsA("vtkXOpenGLRenderWindow")
      ? window->GetGenericDisplayId()
      : nullptr;
    if (display != this->Display)
    {
      this->Display = display;
      this->IsAnswered = display && LeaveOutReleases(display);
    }
  }
  void RecordPress(const std::string& key)
  {
    this->Held = key;
    this->PressTime = Clock::now();
  }
  void RecordRelease(const std::string& key)
  {
    this->Held.clear();
    this->Released = key;
    this->ReleaseTime = Clock::now();
  }
  /** Returns whether a press, which is not yet recorded, repeats the last one. */
  bool IsRepeat(const std::string& key) const
  {
    constexpr std::chrono::milliseconds soon(15);
    // A window that has lost the focus gets no release. Repeats come much sooner than this.
    constexpr std::chrono::seconds forgotten(2);
    const Clock::time_point now = Clock::now();
    return this->IsAnswered ? key == this->Held && now - this->PressTime < forgotten
                            : key == this->Released && now - this->ReleaseTime < soon;
  }
  /**
   * Returns whether an action repeats while its key is held. `key` is the default key of the
   * action.
   */
  static bool MayRepeat(const std::string& key)
  {
    return key == "plus" || key == "minus" || key == "comma" || key == "period" || key == "Left" ||
      key == "Right" || key == "k";
  }

private:
  using Clock = std::chrono::steady_clock;

  static bool LeaveOutReleases(void* display)
  {
#if defined(__linux__)
    using Function = int(void*, int, int*);
    void* const library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    auto* const ask =
      library ? reinterpret_cast<Function*>(dlsym(library, "XkbSetDetectableAutoRepeat")) : nullptr;
    int isSupported = 0;
    return ask && ask(display, 1, &isSupported) != 0 && isSupported != 0;
#else
    static_cast<void>(display);
    return false;
#endif
  }

  void* Display = nullptr;
  bool IsAnswered = false; ///< whether the server leaves out the releases
  std::string Held;
  Clock::time_point PressTime;
  std::string Released;
  Clock::time_point ReleaseTime;
};

} // namespace VolumeHaptics

#endif
