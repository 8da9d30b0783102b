// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the modes of a filter as lines of text that can be clicked on. Each line has the colour of
 * the mode's curve.
 */
#ifndef HapticModeList_h
#define HapticModeList_h

#include "VTK/Scene/Base/HapticModeColors.h"

#include "vtkNew.h"

#include <array>
#include <string>
#include <vector>

class vtkTextActor;
class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{

struct ModeLine
{
  std::string Text;
  bool IsActive = true; ///< an inactive mode is grey
};

class HapticModeList
{
public:
  HapticModeList();
  ~HapticModeList();

  /**
   * Draws the lines from a height (pixels) downwards. Call it in the overlay pass. Returns the
   * number of texts that were drawn.
   */
  int Render(const std::vector<ModeLine>& lines, int top, vtkViewport* viewport);
  /** Removes the lines, so that a click hits none. */
  void Hide() { this->Count = 0; }
  /** Returns the number of the line at a position of the viewport (pixels); -1 if there is none. */
  int Find(int x, int y) const;
  /**
   * Returns the lower end (pixels) of the lines that reach to the right of a position; the largest
   * number if there are none.
   */
  int FindLow(int left) const;
  void Release(vtkWindow* window);

private:
  struct Line
  {
    vtkNew<vtkTextActor> Text;
    int Low = 0; ///< pixels: the lower end, like the next two members
    int High = 0;
    int Width = 0;
  };
  std::array<Line, ModeColorCount> Lines;
  std::size_t Count = 0;
};

} // namespace VolumeHaptics

#endif
