// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The mouse on a page of vtkHapticFunctionEditor that lists labels or tissues.
 */
#ifndef HapticMaterialSheet_h
#define HapticMaterialSheet_h

#include "VTK/Scene/Editor/HapticMaterialItem.h"
#include "VTK/Scene/Editor/HapticMaterialLayout.h"
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "vtkBlockItem.h"
#include "vtkContextActor.h"
#include "vtkNew.h"

namespace VolumeHaptics
{

class HapticMaterialSheet
{
public:
  /** The list has to outlive the sheet. */
  explicit HapticMaterialSheet(HapticMaterialList& list);

  vtkContextActor* GetActor() { return this->Actor; }

  /** The rectangle in pixels of the viewport: x, y, width, height. */
  void Place(const int rectangle[4], double scale = 1.0);
  HapticMaterialLayout GetLayout() const { return { this->Rectangle, this->List, this->Scale }; }

  /**
   * Passes on a vtkCommand of the left button, or MouseMoveEvent, at a position in the viewport.
   * Other buttons do nothing.
   */
  void SendMouse(int event, int button, int x, int y);
  /** The wheel at a position in the viewport. */
  void Turn(int x, int y, double steps);

  ///@{
  /**
   * The position in the viewport of a row's name or one of its boxes, or of a value on the slider
   * of a quantity. False if it is not shown.
   */
  bool GetRowPosition(int key, MaterialPart::KindType part, double position[2]) const;
  bool GetSliderPosition(int quantity, double value, double position[2]) const;
  ///@}

private:
  HapticMaterialList& List;

  void Press(int x, int y);
  void Move(int x, int y);
  void Release();
  /** Sets the quantity of a slider to the value at a position on it. */
  void Slide(int quantity, float x);

  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<HapticMaterialItem> Item;
  int Rectangle[4] = { 0, 0, 1, 1 };
  double Scale = 1.0;
  MaterialPart Held; ///< between press and release: the scroll bar or a slider
};

} // namespace VolumeHaptics

#endif
