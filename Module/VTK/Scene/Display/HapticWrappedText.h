// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fits a text into a viewport by wrapping lines and reducing the font size.
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
 * Wraps lines at spaces, and breaks a word only if it is longer than a line. If the lines still
 * need too much space, reduces the font size.
 */
class HapticWrappedText
{
public:
  /**
   * Space for a text (pixels). The text should stay in the upper part, because something else is
   * drawn below.
   */
  struct Room
  {
    int Width;
    int Free;   ///< height of the upper part
    int Height; ///< total height
    int DPI;
  };

  /** Sets the text and the font size of an actor. */
  void Fit(vtkTextActor* actor, const std::string& text, const Room& room);

  static constexpr int Largest = 14; ///< largest font size (points)
  static constexpr int Smallest = 7;

private:
  std::string Text; ///< the last fitted text
  Room Had{ 0, 0, 0, 0 };
};

/**
 * Returns the space for a text that begins at these fractions of a viewport. It ends at the right
 * margin, or before other renderers' drawings there. `below`: height (pixels) at the bottom that
 * the text should not cover.
 */
HapticWrappedText::Room FindRoom(vtkViewport* viewport, double left, double top, int below);

/** Wraps the lines of a text that are wider than `width` (pixels). */
std::string WrapLines(const std::string& text, vtkTextProperty* letters, int width, int dpi);

/**
 * Limits how often the numbers in a text are redrawn.
 *
 * Numbers, such as a force, change from frame to frame while the hand moves, faster than people can
 * read. With a software renderer, redrawing them takes a tenth of a frame's time. While the hand
 * moves, numbers therefore change at most ten times a second, and not in the first frame of a
 * motion, because the hand waits for that frame. Words always change at once, and at rest, numbers
 * do, too.
 */
class HapticTextPace
{
public:
  static constexpr double Shortest = 0.1; ///< s between changes of numbers

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
