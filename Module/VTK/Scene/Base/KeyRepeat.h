// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Presses of a held key.
 */
#ifndef KeyRepeat_h
#define KeyRepeat_h

#include <chrono>
#include <string>

namespace VolumeHaptics
{

/**
 * Distinguishes the presses that a window system repeats for a held key from real presses.
 *
 * An X server sends the release and the next press of a held key at the same time, and VTK passes
 * both. No hand presses a key again so soon.
 */
class KeyRepeat
{
public:
  void RecordRelease(const std::string& key)
  {
    this->Released = key;
    this->ReleaseTime = Clock::now();
  }
  bool IsRepeat(const std::string& key) const
  {
    constexpr std::chrono::milliseconds soon(15);
    return key == this->Released && Clock::now() - this->ReleaseTime < soon;
  }
  /** Returns whether an action repeats while its key is held. `key` is the action's default key. */
  static bool MayRepeat(const std::string& key)
  {
    return key == "plus" || key == "minus" || key == "comma" || key == "period" || key == "Left" ||
      key == "Right" || key == "k";
  }

private:
  using Clock = std::chrono::steady_clock;

  std::string Released;
  Clock::time_point ReleaseTime;
};

} // namespace VolumeHaptics

#endif
