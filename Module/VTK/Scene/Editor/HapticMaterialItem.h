// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticMaterialItem
 * @brief   draws a list of materials, and the material of the selected row
 */
#ifndef HapticMaterialItem_h
#define HapticMaterialItem_h

#include "VTK/Scene/Editor/HapticMaterialLayout.h"

#include "vtkContextItem.h"

#include <string>

class HapticMaterialItem : public vtkContextItem
{
public:
  static HapticMaterialItem* New();
  vtkTypeMacro(HapticMaterialItem, vtkContextItem);

  /**
   * Sets the list to draw, which has to outlive the item; its rectangle; and the pixels for each
   * point of letters.
   */
  void Show(
    const VolumeHaptics::HapticMaterialList& list, const int rectangle[4], double scale = 1.0);

  bool Paint(vtkContext2D* painter) override;

protected:
  HapticMaterialItem();
  ~HapticMaterialItem() override;

private:
  HapticMaterialItem(const HapticMaterialItem&) = delete;
  void operator=(const HapticMaterialItem&) = delete;

  void PaintRow(
    vtkContext2D* painter, const VolumeHaptics::HapticMaterialLayout& layout, vtkIdType row);
  void PaintMaterial(vtkContext2D* painter, const VolumeHaptics::HapticMaterialLayout& layout);
  void PaintSlider(
    vtkContext2D* painter, const VolumeHaptics::HapticMaterialLayout& layout, int quantity);

  const VolumeHaptics::HapticMaterialList* List = nullptr;
  int Rectangle[4] = { 0, 0, 1, 1 };
  double Scale = 1.0; ///< pixels for each point of letters
};

#endif
