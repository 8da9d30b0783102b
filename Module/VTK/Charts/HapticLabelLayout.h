// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the parts of the list of labels stand.
 */
#ifndef HapticLabelLayout_h
#define HapticLabelLayout_h

#include "vtkRect.h"
#include "vtkType.h"

namespace VolumeHaptics
{

class HapticLabelList;

/** The part of the list at a position. */
struct LabelPart
{
  enum KindType
  {
    Nothing,
    Name, ///< with the swatch
    Felt,
    Forbidden,
    ScrollBar,
    ByFunctions, ///< the button that takes the material away
    Slider
  };

  KindType Kind = Nothing;
  vtkIdType Row = 0; ///< of Name, Felt and Forbidden, in the list
  int Quantity = 0;  ///< of Slider
};

/**
 * From top to bottom: a title with the heads of the columns; rows with swatch, name and two boxes,
 * and a bar to scroll them; name, button and sliders of the selected label. All rectangles are in
 * pixels of the viewport.
 */
class HapticLabelLayout
{
public:
  HapticLabelLayout(const int rectangle[4], const HapticLabelList& list);

  int GetFontSize() const { return this->Font; }
  /** How many rows there is room for. */
  vtkIdType GetRoom() const { return this->Room; }

  vtkRectf GetTitle() const;
  vtkRectf GetHead(LabelPart::KindType column) const; ///< Felt or Forbidden
  vtkRectf GetRow(vtkIdType row) const;
  vtkRectf GetSwatch(vtkIdType row) const;
  vtkRectf GetName(vtkIdType row) const;
  vtkRectf GetBox(vtkIdType row, LabelPart::KindType column) const; ///< Felt or Forbidden
  vtkRectf GetScrollBar() const;
  vtkRectf GetThumb() const;
  vtkRectf GetSelectedName() const;
  vtkRectf GetByFunctions() const;
  vtkRectf GetQuantityTitle(int quantity) const;
  vtkRectf GetSlider(int quantity) const;

  LabelPart Find(float x, float y) const;
  /** The first row for a position on the scroll bar. */
  vtkIdType GetFirstRowAt(float y) const;

private:
  float GetLineTop(int line) const; ///< counted from 0, from the top
  float GetFooterTop() const;

  const HapticLabelList& List;
  vtkRectf Area;
  int Font;
  float Line;
  vtkIdType Room;
};

} // namespace VolumeHaptics

#endif
