// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Limits how often the figures of a text are drawn.
 */
#ifndef HapticTextPace_h
#define HapticTextPace_h

#include <algorithm>
#include <cctype>
#include <string>

namespace VolumeHaptics
{

/**
 * Figures of a text, such as a force, change from frame to frame while the hand moves. With a
 * software renderer, setting their letters takes a tenth of a frame's time, and they would change
 * faster than one can read. So in motion, figures change ten times a second at most, and not in the
 * first frame, because the hand waits for it. Words change at once; at rest, figures do, too.
 */
class HapticTextPace
{
public:
  static constexpr double Shortest = 0.1; ///< s between figures

  /** The text to draw now (s). `moves`: the frame belongs to a motion. */
  const std::string& Choose(const std::string& text, bool moves, double now)
  {
    const bool waits = moves && (!this->Moved || now < this->Last + Shortest);
    this->Moved = moves;
    if (!waits || GetWords(text) != GetWords(this->Shown))
    {
      this->Shown = text;
      this->Last = now;
    }
    return this->Shown;
  }

private:
  static std::string GetWords(std::string text)
  {
    const auto isFigure = [](unsigned char c) { return std::isdigit(c) != 0 || c == '.'; };
    text.erase(std::remove_if(text.begin(), text.end(), isFigure), text.end());
    return text;
  }

  std::string Shown;
  double Last = 0.0;
  bool Moved = false;
};

} // namespace VolumeHaptics

#endif
