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
 * The edited objects, and the charts and lists that show them: one page at a time, and in a wide
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
  /** The functions that can be edited on the page. */
  EditedObjects GetEditable() const;
  /** The error in stiffness and viscosity, on their pages; empty if there is none. */
  std::string FindWarning() const;
  /** Gives the axis of values the scale of the page's functions. */
  void ScaleValues();
  /** The time of the last edit. */
  vtkMTimeType GetEditTime() const;

  ///@{
  /** The histogram or the list of the page. */
  bool IsCounted() const;
  void Count();
  void FollowCounts();
  double GetCountedShare() const;
  /** Stops work on an image that was removed. */
  void EndOtherCounts();
  ///@}

  /** Fits the page into a rectangle: left, bottom, width and height. */
  void Show(const int rectangle[4], bool isDragged, double scale = 1.0);
  /** The actors that draw the page. */
  std::vector<vtkContextActor*> GetActors();
  std::vector<vtkContextActor*> GetAllActors();

  /** Like HapticFunctionChart::SendMouse; events after a press go to the part that was pressed. */
  void SendMouse(int event, int button, int x, int y);
  void Turn(int x, int y, double steps);

  /** The page's list with sliders; null if it has none. */
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
  int Split = 0;           ///< x coordinates between chart and tissues
  bool HoldsSheet = false; ///< true between press and release
};

} // namespace VolumeHaptics

#endif
