// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The layout of the parts of a list of materials.
 */
#ifndef HapticMaterialLayout_h
#define HapticMaterialLayout_h

#include "vtkRect.h"
#include "vtkType.h"

namespace VolumeHaptics
{

class HapticMaterialList;

/** The part of the list at a position. */
struct MaterialPart
{
  enum KindType
  {
    Nothing,
    Name, ///< name and swatch
    Felt, ///< this part and the next: in lists with boxes
    Forbidden,
    ScrollBar,
    ByFunctions, ///< the button that removes the material
    Slider
  };

  KindType Kind = Nothing;
  vtkIdType Row = 0; ///< row of Name, Felt or Forbidden
  int Quantity = 0;  ///< quantity of Slider
};

/**
 * Places the parts from top to bottom: a title with the heads of the columns; rows with swatch and
 * name, two boxes if the list has them, and a scroll bar; name, button and sliders of the selected
 * row. All rectangles are in pixels of the viewport.
 */
class HapticMaterialLayout
{
public:
  /** `scale`: pixels for each point of letters. */
  HapticMaterialLayout(const int rectangle[4], const HapticMaterialList& list, double scale = 1.0);

  int GetFontSize() const { return this->Font; }
  /** The number of rows that fit. */
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
  /** The first visible row for a position on the scroll bar. */
  vtkIdType GetFirstRowAt(float y) const;

private:
  float GetLineTop(int line) const; ///< counted from 0, from the top
  float GetFooterTop() const;
  float GetNamesRight() const;

  const HapticMaterialList& List;
  vtkRectf Area;
  int Font;     ///< points
  float Letter; ///< pixels: their height
  float Line;
  vtkIdType Room;
};

} // namespace VolumeHaptics

#endif
