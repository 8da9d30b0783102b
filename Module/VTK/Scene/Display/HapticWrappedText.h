// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A text that fits into a viewport, with all of its words visible.
 */
#ifndef HapticWrappedText_h
#define HapticWrappedText_h

#include <algorithm>
#include <cctype>
#include <string>

class vtkTextActor;
class vtkTextProperty;
class vtkViewport;

namespace VolumeHaptics
{

/**
 * Breaks lines at spaces, and breaks words longer than a line anywhere. If the lines still need too
 * much room, makes the letters smaller.
 */
class HapticWrappedText
{
public:
  /**
   * The room for a text in pixels. Its upper part, Free high, lies above what the text should not
   * cover.
   */
  struct Room
  {
    int Width;
    int Free;   ///< height of the upper part
    int Height; ///< whole height
    int DPI;
  };

  /** Gives the actor the text and the size of its letters. */
  void Fit(vtkTextActor* actor, const std::string& text, const Room& room);

  static constexpr int Largest = 14; ///< largest size of letters (points)
  static constexpr int Smallest = 7;

private:
  std::string Text; ///< the last fitted text, and its room
  Room Had{ 0, 0, 0, 0 };
};

/**
 * Returns the room for a text that begins at these fractions of a viewport. The margin at the right
 * and what other renderers draw there do not count as room. `below`: pixels that the text should
 * not cover.
 */
HapticWrappedText::Room FindRoom(vtkViewport* viewport, double left, double top, int below);

/** Breaks lines of a text wider than this (pixels). */
std::string WrapLines(const std::string& text, vtkTextProperty* letters, int width, int dpi);

/**
 * Limits how often the figures of a text are drawn.
 *
 * Figures of a text, such as a force, change from frame to frame while the hand moves. With a
 * software renderer, setting their letters takes a tenth of a frame's time, and they would change
 * faster than people can read. So while the hand moves, figures change at most ten times a second,
 * and not in the first frame, for which the hand waits. Words always change at once, and figures do
 * at rest.
 */
class HapticTextPace
{
public:
  static constexpr double Shortest = 0.1; ///< s between figures

  /** Returns the text to draw at a time (s). `moves`: the frame belongs to a motion. */
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
