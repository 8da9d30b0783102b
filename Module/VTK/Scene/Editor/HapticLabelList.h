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

/** Lists the labels of a label image or, without an image, of the table. */
class HapticLabelList : public HapticMaterialList
{
public:
  vtkSmartPointer<vtkHapticLabelTable> Table;
  vtkSmartPointer<vtkImageData> Image;

  ///@{
  /**
   * Searches the image for labels, and reports whether the list is up to date. A large image gives
   * the labels of spread samples at first, until FollowCount() finds that all voxels were searched
   * in the background.
   */
  void Count();
  bool IsCounted() const override;
  void FollowCount();
  /** Ends the search in an image that is no longer shown; the program may delete it. */
  void EndOtherCount();
  /** The fraction of the image that was searched, 0 to 1. */
  double GetCountedShare() const;
  ///@}

  vtkIdType GetNumberOfRows() const override;
  int GetKey(vtkIdType row) const override;
  vtkObject* GetEdited() const override;
  std::string GetTitle() const override;
  const char* GetHint() const override { return "Click on a label to edit its material"; }
  /** A text such as "5 liver". */
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
  const vtkImageData* CountedImage = nullptr; ///< never dereferenced, only compared
  vtkTimeStamp CountTime;
  vtkSmartPointer<vtkDataArray> Counted; // during the search
  KeyedWork<vtkMTimeType, std::vector<int>> Counting;
};

} // namespace VolumeHaptics

#endif
