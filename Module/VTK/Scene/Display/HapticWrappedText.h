// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fits a text into a viewport, so that all of its words are visible.
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
 * Breaks lines at spaces, and words that are longer than a line anywhere. If the lines still need
 * too much room, makes the letters smaller.
 */
class HapticWrappedText
{
public:
  /**
   * The room for a text (pixels). The text should stay in the upper part of the room, because
   * something is drawn below.
   */
  struct Room
  {
    int Width;
    int Free;   ///< height of the upper part
    int Height; ///< whole height
    int DPI;
  };

  /** Sets the actor's text and the size of its letters. */
  void Fit(vtkTextActor* actor, const std::string& text, const Room& room);

  static constexpr int Largest = 14; ///< largest size of letters (points)
  static constexpr int Smallest = 7;

private:
  std::string Text; ///< the last fitted text
  Room Had{ 0, 0, 0, 0 };
};

/**
 * Returns the room for a text that begins at these fractions of a viewport. The room ends before
 * the right margin and before what other renderers draw there. `below`: height (pixels) that the
 * text should not cover.
 */
HapticWrappedText::Room FindRoom(vtkViewport* viewport, double left, double top, int below);

/** Breaks those lines of a text that are wider than `width` (pixels). */
std::string WrapLines(const std::string& text, vtkTextProperty* letters, int width, int dpi);

/**
 * Limits how often the figures of a text are drawn.
 *
 * Figures, such as a force, change from frame to frame while the hand moves, faster than people can
 * read. With a software renderer, drawing them anew takes a tenth of a frame's time. So while the
 * hand moves, figures change at most ten times a second, and not in the first frame, because the
 * hand waits for that frame. Words always change at once. At rest, figures change at once, too.
 */
class HapticTextPace
{
public:
  static constexpr double Shortest = 0.1; ///< s between changes of figures

  /**
   * Returns the text to draw at the time `now` (s). `moves`: whether the frame belongs to a motion.
   */
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
