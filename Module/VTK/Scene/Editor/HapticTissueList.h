// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tissues that the function editor lists, and the material of the selected one.
 */
#ifndef HapticTissueList_h
#define HapticTissueList_h

#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "vtkHapticProperty.h"
#include "vtkSmartPointer.h"

namespace VolumeHaptics
{

/** The colour of a tissue by number, in lists and bands: RGB, 0 to 1. */
std::array<double, 3> GetTissueColor(int tissue);

class HapticTissueList : public HapticMaterialList
{
public:
  /** The property may be null. */
  explicit HapticTissueList(const vtkSmartPointer<vtkHapticProperty>& property)
    : Property(property)
  {
  }

  vtkIdType GetNumberOfRows() const override;
  int GetKey(vtkIdType row) const override { return static_cast<int>(row); }
  vtkObject* GetEdited() const override { return this->Property; }
  std::string GetTitle() const override;
  const char* GetHint() const override { return "Click on a tissue to edit its material"; }
  std::string Describe(int tissue) const override;
  std::array<double, 3> GetColor(int tissue) const override { return GetTissueColor(tissue); }

protected:
  double ReadValue(int tissue, int quantity) const override;
  void WriteValue(int tissue, int quantity, double value) override;

private:
  const vtkSmartPointer<vtkHapticProperty>& Property;
};

} // namespace VolumeHaptics

#endif
