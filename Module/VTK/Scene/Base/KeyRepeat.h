// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects the repeated presses of a held key.
 */
#ifndef KeyRepeat_h
#define KeyRepeat_h

#include <chrono>
#include <string>

namespace VolumeHaptics
{

/**
 * Distinguishes presses that a window system generates for a held key from real presses.
 *
 * An X server sends the release and the next press of a held key at the same time, and VTK passes
 * on both. A hand can't press a key again so fast.
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

  std::string Released;
  Clock::time_point ReleaseTime;
};

} // namespace VolumeHaptics

#endif
