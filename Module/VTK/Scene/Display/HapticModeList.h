// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the modes of a filter as clickable lines of text, each in the colour of the mode's curve.
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
  bool IsActive = true; ///< an inactive mode is drawn in grey
};

class HapticModeList
{
public:
  HapticModeList();
  ~HapticModeList();

  /**
   * Draws the lines downwards from a height (pixels). Call this in the overlay pass. Returns the
   * number of drawn texts.
   */
  int Render(const std::vector<ModeLine>& lines, int top, vtkViewport* viewport);
  /** Hides the lines, so that no click can hit one. */
  void Hide() { this->Count = 0; }
  /** Returns the index of the line at a position in the viewport (pixels); -1 if there is none. */
  int Find(int x, int y) const;
  /**
   * Returns the lower end (pixels) of the lines that extend to the right of a position; the largest
   * number if there are none.
   */
  int FindLow(int left) const;
  void Release(vtkWindow* window);

private:
  struct Line
  {
    vtkNew<vtkTextActor> Text;
    int Low = 0; ///< lower end (pixels), like the next two members
    int High = 0;
    int Width = 0;
  };
  std::array<Line, ModeColorCount> Lines;
  std::size_t Count = 0;
};

} // namespace VolumeHaptics

#endif
