// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The page of vtkHapticFunctionEditor that lists labels: what the mouse does to them.
 */
#ifndef HapticLabelSheet_h
#define HapticLabelSheet_h

#include "VTK/Charts/HapticLabelItem.h"
#include "VTK/Charts/HapticLabelLayout.h"
#include "VTK/Charts/HapticLabelList.h"

#include "vtkBlockItem.h"
#include "vtkContextActor.h"
#include "vtkNew.h"

namespace VolumeHaptics
{

class HapticLabelSheet
{
public:
  HapticLabelSheet();

  HapticLabelList List;

  vtkContextActor* GetActor() { return this->Actor; }

  /** The rectangle in pixels of the viewport: x, y, width, height. */
  void Place(const int rectangle[4]);
  HapticLabelLayout GetLayout() const { return { this->Rectangle, this->List }; }

  ///@{
  /** The left button and the wheel at a position in the viewport. */
  void Press(int x, int y);
  void Move(int x, int y);
  void Release();
  void Turn(int x, int y, double steps);
  ///@}

private:
  /** Sets the quantity of a slider to the value at a position on it. */
  void Slide(int quantity, float x);

  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<HapticLabelItem> Item;
  int Rectangle[4] = { 0, 0, 1, 1 };
  LabelPart Held; ///< from press to release: the scroll bar or a slider
};

} // namespace VolumeHaptics

#endif
