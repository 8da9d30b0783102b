// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws a list of labels or tissues on a page of vtkHapticFunctionEditor, and handles the mouse
 * there.
 */
#ifndef HapticMaterialSheet_h
#define HapticMaterialSheet_h

#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "vtkBlockItem.h"
#include "vtkContextActor.h"
#include "vtkNew.h"
#include "vtkRect.h"
#include "vtkType.h"

class HapticMaterialItem;

namespace VolumeHaptics
{

class HapticMaterialList;

/** The part of the sheet at a position. */
struct MaterialPart
{
  enum KindType
  {
    Nothing,
    Name, ///< a row's name or swatch
    Felt, ///< box of a row, as the next part; only in lists with boxes
    Forbidden,
    ScrollBar,
    ByFunctions, ///< the button that removes a row's own material
    Slider
  };

  KindType Kind = Nothing;
  vtkIdType Row = 0; ///< the row, for Name, Felt and Forbidden
  int Quantity = 0;  ///< the quantity, for Slider
};

/**
 * Computes the rectangles of the parts, from top to bottom: a title with the heads of the columns;
 * rows with swatch and name, two boxes if the list has them, and a scroll bar; name, button and
 * sliders of the selected row. All rectangles are in pixels of the viewport.
 */
class HapticMaterialLayout
{
public:
  /** `scale`: pixels for each point of letters. */
  HapticMaterialLayout(const int rectangle[4], const HapticMaterialList& list, double scale = 1.0);

  int GetFontSize() const { return this->Font; }
  /** Returns the number of rows that fit. */
  vtkIdType GetRoom() const { return this->Room; }

  vtkRectf GetTitle() const;
  vtkRectf GetHead(MaterialPart::KindType column) const; ///< Felt or Forbidden
  vtkRectf GetRow(vtkIdType row) const;
  vtkRectf GetSwatch(vtkIdType row) const;
  vtkRectf GetName(vtkIdType row) const;
  vtkRectf GetBox(vtkIdType row, MaterialPart::KindType column) const; ///< Felt or Forbidden
  vtkRectf GetScrollBar() const;
  vtkRectf GetThumb() const;
  vtkRectf GetSelectedName() const;
  vtkRectf GetByFunctions() const;
  vtkRectf GetQuantityTitle(int quantity) const;
  vtkRectf GetSlider(int quantity) const;

  MaterialPart Find(float x, float y) const;
  /**
   * Returns the row that becomes the first visible row if the scroll bar is clicked at a position.
   */
  vtkIdType GetFirstRowAt(float y) const;

private:
  float GetLineTop(int line) const; ///< the top of a line; lines count from 0 at the top
  float GetFooterTop() const;
  float GetNamesRight() const;

  const HapticMaterialList& List;
  vtkRectf Area;
  int Font;     ///< points
  float Letter; ///< height of letters (pixels)
  float Line;
  vtkIdType Room;
};

class HapticMaterialSheet
{
public:
  /** The list must outlive the sheet. */
  explicit HapticMaterialSheet(HapticMaterialList& list);
  ~HapticMaterialSheet();

  vtkContextActor* GetActor() { return this->Actor; }

  /** Sets the rectangle in pixels of the viewport: x, y, width, height. */
  void Place(const int rectangle[4], double scale = 1.0);
  HapticMaterialLayout GetLayout() const { return { this->Rectangle, this->List, this->Scale }; }

  /**
   * Handles a vtkCommand of the left button, or MouseMoveEvent, at a position in the viewport.
   * Other buttons do nothing.
   */
  void SendMouse(int event, int button, int x, int y);
  /** Handles a turn of the wheel at a position in the viewport. */
  void Turn(int x, int y, double steps);

  ///@{
  /**
   * Compute a position in the viewport: of a row's name or one of its boxes, or of a value on the
   * slider of a quantity. Return false if the part is not shown.
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
  MaterialPart Held; ///< the scroll bar or slider that the mouse drags, from press to release
};

} // namespace VolumeHaptics

#endif
