// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticLabelItem
 * @brief   draws a list of labels, and the material of the selected one
 */
#ifndef HapticLabelItem_h
#define HapticLabelItem_h

#include "VTK/Charts/HapticLabelLayout.h"

#include "vtkContextItem.h"

#include <string>

class HapticLabelItem : public vtkContextItem
{
public:
  static HapticLabelItem* New();
  vtkTypeMacro(HapticLabelItem, vtkContextItem);

  /** The list to draw, and its rectangle; the list has to outlive the item. */
  void Show(const VolumeHaptics::HapticLabelList& list, const int rectangle[4]);

  bool Paint(vtkContext2D* painter) override;

protected:
  HapticLabelItem();
  ~HapticLabelItem() override;

private:
  HapticLabelItem(const HapticLabelItem&) = delete;
  void operator=(const HapticLabelItem&) = delete;

  void PaintRow(
    vtkContext2D* painter, const VolumeHaptics::HapticLabelLayout& layout, vtkIdType row);
  void PaintMaterial(vtkContext2D* painter, const VolumeHaptics::HapticLabelLayout& layout);
  void PaintSlider(
    vtkContext2D* painter, const VolumeHaptics::HapticLabelLayout& layout, int quantity);

  const VolumeHaptics::HapticLabelList* List = nullptr;
  int Rectangle[4] = { 0, 0, 1, 1 };
};

#endif
