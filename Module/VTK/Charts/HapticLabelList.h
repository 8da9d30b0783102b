// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The labels that the function editor lists, and the material of the selected one.
 */
#ifndef HapticLabelList_h
#define HapticLabelList_h

#include "VTK/Work/BackgroundWork.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkHapticLabelTable;
class vtkImageData;

namespace VolumeHaptics
{

/** A quantity of a label's material, as a slider shows it. */
struct LabelQuantity
{
  const char* Title;
  double Usual; ///< the end of the slider, unless the value is larger
  double Most;  ///< the largest end
  void (vtkHapticLabelTable::*Set)(int, double);
  double (vtkHapticLabelTable::*Get)(int); ///< -1: by the functions
};

/**
 * Lists the labels that a label image has or, without one, those of the table. Only what a window
 * of some rows shows is looked up, so that a million labels are as quick as ten.
 */
class HapticLabelList
{
public:
  static constexpr int Quantities = 4;
  static const LabelQuantity& GetQuantity(int quantity);

  vtkSmartPointer<vtkHapticLabelTable> Table;
  vtkSmartPointer<vtkImageData> Image;

  ///@{
  /**
   * Looks for the labels of the image, and whether that is up to date. Of a large image these are
   * the labels of spread samples at first, until FollowCount() finds that all were looked at in the
   * background.
   */
  void Count();
  bool IsCounted() const;
  void FollowCount();
  /** Ends the search in an image that is no longer the image, and that the program may remove. */
  void EndOtherCount();
  /** The share of the image that was looked at, 0 to 1. */
  double GetCountedShare() const;
  ///@}

  vtkIdType GetNumberOfLabels() const;
  int GetLabel(vtkIdType row) const;
  /** The row of a label; -1 if it is not listed. */
  vtkIdType FindRow(int label) const;

  ///@{
  /** The window of rows; the first one is moved so that all of them exist, if possible. */
  void SetVisibleRows(vtkIdType rows);
  vtkIdType GetVisibleRows() const { return this->VisibleRows; }
  void ScrollTo(vtkIdType first);
  vtkIdType GetFirstRow() const { return this->FirstRow; }
  ///@}

  ///@{
  /** The selected label, if it is listed. Select also scrolls to it, and returns whether it is. */
  bool Select(int label);
  std::optional<int> GetSelected() const;
  ///@}

  ///@{
  /** Of the selected label: the value of a quantity, -1 if it is by the functions. */
  double GetValue(int quantity) const;
  void SetValue(int quantity, double value);
  ///@}

  ///@{
  /**
   * The end of a slider. It stays while the slider is dragged; FitEnds makes it suit the value.
   */
  double GetEnd(int quantity) const { return this->Ends[static_cast<std::size_t>(quantity)]; }
  void FitEnds();
  ///@}

  /** Such as "5 liver". */
  std::string Describe(int label) const;

private:
  std::vector<int> Present;
  const vtkImageData* CountedImage = nullptr; ///< only compared
  vtkTimeStamp CountTime;
  vtkSmartPointer<vtkDataArray> Counted; // while it is looked at
  KeyedWork<vtkMTimeType, std::vector<int>> Counting;
  vtkIdType FirstRow = 0;
  vtkIdType VisibleRows = 1;
  std::optional<int> Selected;
  std::array<double, Quantities> Ends{ 1.0, 1.0, 1.0, 1.0 };
};

} // namespace VolumeHaptics

#endif
