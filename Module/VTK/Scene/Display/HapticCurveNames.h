// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticCurveNames
 * @brief   draws a title, and below it the names of curves in their colours
 *
 * Above a small chart, where a legend would cover the curves.
 */
#ifndef HapticCurveNames_h
#define HapticCurveNames_h

#include "vtkContextItem.h"

#include <array>
#include <string>
#include <vector>

class HapticCurveNames : public vtkContextItem
{
public:
  static HapticCurveNames* New();
  vtkTypeMacro(HapticCurveNames, vtkContextItem);

  struct Name
  {
    std::string Text;
    std::array<unsigned char, 3> Color;
  };
  void SetTitle(const std::string& title) { this->Title = title; }
  void SetNames(const std::vector<Name>& names) { this->Names = names; }
  /**
   * The left end of the first letter, and the upper edge (pixels); the size of letters (points).
   */
  void Place(float left, float top, int letters, float scale = 1.0f);
  /** The height of both lines (pixels). */
  static float GetHeight(int letters);

  bool Paint(vtkContext2D* painter) override;

protected:
  HapticCurveNames();
  ~HapticCurveNames() override;

private:
  HapticCurveNames(const HapticCurveNames&) = delete;
  void operator=(const HapticCurveNames&) = delete;

  std::string Title;
  std::vector<Name> Names;
  float Left = 0.0f;
  float Top = 0.0f;
  int Letters = 10;
  float Scale = 1.0f; ///< pixels for each point
};

#endif
