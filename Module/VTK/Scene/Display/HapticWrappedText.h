// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A text whose every word is visible in a viewport.
 */
#ifndef HapticWrappedText_h
#define HapticWrappedText_h

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
  /** Room in pixels. Its upper part, Free high, lies above what the text should not cover. */
  struct Room
  {
    int Width;
    int Free;   ///< height of the upper part
    int Height; ///< whole height
    int DPI;
  };

  /** Gives the actor the text and the size of its letters. */
  void Fit(vtkTextActor* actor, const std::string& text, const Room& room);

  static constexpr int Largest = 14; ///< letters, points
  static constexpr int Smallest = 7;

private:
  std::string Text; ///< the last fitted text, and its room
  Room Had{ 0, 0, 0, 0 };
};

/**
 * The room for a text that begins at these fractions of a viewport, without its margin at the right
 * and what other renderers draw there. `below`: pixels that the text should not cover.
 */
HapticWrappedText::Room FindRoom(vtkViewport* viewport, double left, double top, int below);

/** Breaks lines of a text wider than this (pixels). */
std::string WrapLines(const std::string& text, vtkTextProperty* letters, int width, int dpi);

} // namespace VolumeHaptics

#endif
