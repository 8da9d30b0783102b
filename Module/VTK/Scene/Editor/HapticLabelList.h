// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The labels that the function editor lists, and the material of the selected one.
 */
#ifndef HapticLabelList_h
#define HapticLabelList_h

#include "VTK/Base/BackgroundWork.h"
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <vector>

class vtkHapticLabelTable;
class vtkImageData;

namespace VolumeHaptics
{

/** Lists the labels that a label image has or, without one, those of the table. */
class HapticLabelList : public HapticMaterialList
{
public:
  vtkSmartPointer<vtkHapticLabelTable> Table;
  vtkSmartPointer<vtkImageData> Image;

  ///@{
  /**
   * Looks for the labels of the image, and whether that is up to date. Of a large image these are
   * the labels of spread samples at first, until FollowCount() finds that all were looked at in the
   * background.
   */
  void Count();
  bool IsCounted() const override;
  void FollowCount();
  /** Ends the search in an image that is no longer the image, and that the program may remove. */
  void EndOtherCount();
  /** The share of the image that was looked at, 0 to 1. */
  double GetCountedShare() const;
  ///@}

  vtkIdType GetNumberOfRows() const override;
  int GetKey(vtkIdType row) const override;
  vtkObject* GetEdited() const override;
  std::string GetTitle() const override;
  const char* GetHint() const override { return "Click on a label to edit its material"; }
  /** Such as "5 liver". */
  std::string Describe(int label) const override;
  std::array<double, 3> GetColor(int label) const override;
  bool HasBoxes() const override { return true; }
  bool IsFelt(int label) const override;
  bool IsForbidden(int label) const override;
  void ToggleFelt(int label) override;
  void ToggleForbidden(int label) override;
  bool HasMaterial(int label) const override;
  void RemoveMaterial(int label) override;

protected:
  double ReadValue(int label, int quantity) const override;
  void WriteValue(int label, int quantity, double value) override;

private:
  std::vector<int> Present;
  const vtkImageData* CountedImage = nullptr; ///< only compared
  vtkTimeStamp CountTime;
  vtkSmartPointer<vtkDataArray> Counted; // while it is looked at
  KeyedWork<vtkMTimeType, std::vector<int>> Counting;
};

} // namespace VolumeHaptics

#endif
