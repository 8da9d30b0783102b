// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Distinguishes presses that a window system repeats for a held key from presses of a hand.
 */
#ifndef KeyRepeat_h
#define KeyRepeat_h

#include "Core/Realtime/ServoClock.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/**
 * An X server sends the release and the next press of a held key at the same time, and VTK passes
 * both. No hand presses a key again so soon.
 */
class KeyRepeat
{
public:
  void NoteRelease(const std::string& key)
  {
    this->Released = key;
    this->ReleaseTime = ServoClock::Now();
  }
  bool IsRepeat(const std::string& key) const
  {
    constexpr double soon = 0.015; // s
    return key == this->Released && ServoClock::SecondsSince(this->ReleaseTime) < soon;
  }
  /** Whether an action repeats while its key, by default this one, is held. */
  static bool MayRepeat(const std::string& key)
  {
    for (const char* const step : { "plus", "minus", "comma", "period", "Left", "Right", "k" })
    {
      if (key == step)
      {
        return true;
      }
    }
    return false;
  }

private:
  std::string Released;
  std::int64_t ReleaseTime = 0; ///< ServoClock
};

} // namespace VolumeHaptics

#endif
