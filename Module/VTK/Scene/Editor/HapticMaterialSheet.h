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

/** The part of the sheet under a position. */
struct MaterialPart
{
  enum KindType
  {
    Nothing,
    Name, ///< name or swatch of a row
    Felt, ///< check box of a row, like the next part; only in lists with boxes
    Forbidden,
    ScrollBar,
    ByFunctions, ///< button that removes a row's own material
    Slider
  };

  KindType Kind = Nothing;
  vtkIdType Row = 0; ///< for Name, Felt and Forbidden
  int Quantity = 0;  ///< for Slider
};

/**
 * Computes the rectangles of the parts, from top to bottom: a title with the column heads; rows
 * with swatch and name, two check boxes if the list has them, and a scroll bar; name, button and
 * sliders of the selected row. All rectangles are in pixels of the viewport.
 */
class HapticMaterialLayout
{
public:
  /** `scale`: pixels per point. */
  HapticMaterialLayout(const int rectangle[4], const HapticMaterialList& list, double scale = 1.0);

  int GetFontSize() const { return this->Font; }
  /** Returns the number of rows that fit into the rectangle. */
  vtkIdType GetRoom() const { return this->Room; }

  vtkRectf GetTitle() const;
  vtkRectf GetHead(MaterialPart::KindType column) const; ///< for Felt or Forbidden
  vtkRectf GetRow(vtkIdType row) const;
  vtkRectf GetSwatch(vtkIdType row) const;
  vtkRectf GetName(vtkIdType row) const;
  vtkRectf GetBox(vtkIdType row, MaterialPart::KindType column) const; ///< for Felt or Forbidden
  vtkRectf GetScrollBar() const;
  vtkRectf GetThumb() const;
  vtkRectf GetSelectedName() const;
  vtkRectf GetByFunctions() const;
  vtkRectf GetQuantityTitle(int quantity) const;
  vtkRectf GetSlider(int quantity) const;

  MaterialPart Find(float x, float y) const;
  /**
   * Returns the row that becomes the first visible one after a click on the scroll bar at this
   * position.
   */
  vtkIdType GetFirstRowAt(float y) const;

private:
  float GetLineTop(int line) const; ///< lines count from 0 at the top
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
  /** Makes a sheet for a list, which must outlive the sheet. */
  explicit HapticMaterialSheet(HapticMaterialList& list);
  ~HapticMaterialSheet();

  vtkContextActor* GetActor() { return this->Actor; }

  /** Sets the rectangle in pixels of the viewport: x, y, width, height. */
  void Place(const int rectangle[4], double scale = 1.0);
  HapticMaterialLayout GetLayout() const { return { this->Rectangle, this->List, this->Scale }; }

  /**
   * Handles a vtkCommand of the left button, or MouseMoveEvent, at a position in the viewport.
   * Ignores other buttons.
   */
  void SendMouse(int event, int button, int x, int y);
  /** Handles a turn of the wheel at a position in the viewport. */
  void Turn(int x, int y, double steps);

  ///@{
  /**
   * Compute the position in the viewport of a row's name or check box, or of a value on a
   * quantity's slider. Return false if the part is not shown.
   */
  bool GetRowPosition(int key, MaterialPart::KindType part, double position[2]) const;
  bool GetSliderPosition(int quantity, double value, double position[2]) const;
  ///@}

private:
  HapticMaterialList& List;

  void Press(int x, int y);
  void Move(int x, int y);
  void Release();
  /** Sets a quantity to the value at a position on its slider. */
  void Slide(int quantity, float x);

  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<HapticMaterialItem> Item;
  int Rectangle[4] = { 0, 0, 1, 1 };
  double Scale = 1.0;
  MaterialPart Held; ///< scroll bar or slider that the mouse is dragging
};

} // namespace VolumeHaptics

#endif
