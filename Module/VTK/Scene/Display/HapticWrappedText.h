// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A text of which a viewport shows every word.
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
 * Breaks lines at spaces, and words that are longer than a line anywhere. If the lines still take
 * too much room, the letters become smaller.
 */
class HapticWrappedText
{
public:
  /** Pixels, of which some lie above what the text had better not cover. */
  struct Room
  {
    int Width;
    int Free;   ///< height above it
    int Height; ///< of all
    int DPI;
  };

  /** Gives the actor the text and the size of its letters. */
  void Fit(vtkTextActor* actor, const std::string& text, const Room& room);

  static constexpr int Largest = 14; ///< letters, points
  static constexpr int Smallest = 7;

private:
  std::string Text; ///< the last one that was fitted, and the room for it
  Room Had{ 0, 0, 0, 0 };
};

/**
 * The room of a text that begins at these shares of a viewport, without its margin at the right and
 * what other renderers draw there. `below`: pixels that it had better not cover.
 */
HapticWrappedText::Room FindRoom(vtkViewport* viewport, double left, double top, int below);

/** Breaks the lines of a text that are wider than this (pixels). */
std::string WrapLines(const std::string& text, vtkTextProperty* letters, int width, int dpi);

} // namespace VolumeHaptics

#endif
