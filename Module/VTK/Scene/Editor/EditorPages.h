// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The pages of vtkHapticFunctionEditor: a chart for each function, and lists of labels and tissues.
 */
#ifndef EditorPages_h
#define EditorPages_h

#include "VTK/Scene/Editor/EditHistory.h"
#include "VTK/Scene/Editor/HapticFunctionChart.h"
#include "VTK/Scene/Editor/HapticLabelList.h"
#include "VTK/Scene/Editor/HapticMaterialSheet.h"
#include "VTK/Scene/Editor/HapticProposalView.h"
#include "VTK/Scene/Editor/HapticTissueList.h"

#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * What an editor edits, and the charts and lists that show it: one page at a time, and in a wide
 * editor the tissues beside the chart of a function. Positions are pixels of the viewport.
 */
class EditorPages
{
public:
  vtkSmartPointer<vtkVolumeProperty> VolumeProperty;
  HapticFunctionChart Chart;
  HapticProposalView Proposed{ Chart };
  HapticLabelList LabelList;
  HapticTissueList TissueList{ Proposed.Property };

  /** The page: vtkHapticFunctionEditor::FunctionType. */
  void SetPage(int page) { this->Page = page; }
  /** Whether there is something to edit on a page. */
  bool Has(int page) const;
  const char* GetTitle() const;

  /** The function of the page, or none. */
  vtkPiecewiseFunction* GetFunction() const;
  EditedObjects GetEdited() const;
  /** Those of them that can be edited on the page. */
  EditedObjects GetEditable() const;
  /** What is wrong with the stiffness and the viscosity, on their pages; empty if nothing is. */
  std::string FindWarning() const;
  /** Makes the axis of values that of the page's functions. */
  void ScaleValues();
  /** When something was last edited. */
  vtkMTimeType GetEditTime() const;

  ///@{
  /** The histogram or the list of the page. */
  bool IsCounted() const;
  void Count();
  void FollowCounts();
  double GetCountedShare() const;
  /** No work goes on with an image that was taken away. */
  void EndOtherCounts();
  ///@}

  /** Fits the page into a rectangle: left, bottom, width and height. */
  void Show(const int rectangle[4], bool isDragged, double scale = 1.0);
  /** What draws the page. */
  std::vector<vtkContextActor*> GetActors();
  std::vector<vtkContextActor*> GetAllActors();

  /** As HapticFunctionChart::SendMouse; what a press begins goes on where it began. */
  void SendMouse(int event, int button, int x, int y);
  void Turn(int x, int y, double steps);

  /** The list with sliders that the page shows; null if none. */
  HapticMaterialSheet* GetSheet();
  HapticMaterialSheet& GetLabels() { return this->Labels; }
  HapticMaterialSheet& GetTissues() { return this->Tissues; }

private:
  bool IsSheetPage() const;
  bool IsOnSheet(int x) const;

  HapticMaterialSheet Labels{ LabelList };
  HapticMaterialSheet Tissues{ TissueList };
  int Page = 0;
  bool HasBoth = false;    ///< chart and tissues
  int Split = 0;           ///< x between them
  bool HoldsSheet = false; ///< from press to release
};

} // namespace VolumeHaptics

#endif
