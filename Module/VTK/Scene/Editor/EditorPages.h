// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The pages of vtkHapticFunctionEditor: a chart for each function, and lists of labels and tissues.
 */
#ifndef EditorPages_h
#define EditorPages_h

#include "VTK/Base/BackgroundWork.h"
#include "VTK/Material/FunctionSearch.h"
#include "VTK/Scene/Editor/EditHistory.h"
#include "VTK/Scene/Editor/HapticFunctionChart.h"
#include "VTK/Scene/Editor/HapticMaterialList.h"
#include "VTK/Scene/Editor/HapticMaterialSheet.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"
#include "vtkVolumeProperty.h"

#include <optional>
#include <string>
#include <vector>

class vtkHapticLabelTable;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

class HapticFunctionChart;

/**
 * The labels of a label image or, without an image, of the table; and the material of the selected
 * one.
 */
class HapticLabelList : public HapticMaterialList
{
public:
  vtkSmartPointer<vtkHapticLabelTable> Table;
  vtkSmartPointer<vtkImageData> Image;

  ///@{
  /**
   * Searches the image for labels, and reports whether the list is up to date. A large image gives
   * the labels of spread samples at first, until PollCount() finds that all voxels were searched
   * in the background.
   */
  void Count();
  bool IsCounted() const override;
  void PollCount();
  /** Ends the search in an image that is no longer shown; the program may delete it. */
  void EndOtherCount();
  /** Returns the fraction of the image that was searched, 0 to 1. */
  double GetCountedFraction() const;
  ///@}

  vtkIdType GetNumberOfRows() const override;
  int GetKey(vtkIdType row) const override;
  vtkObject* GetEdited() const override;
  std::string GetTitle() const override;
  const char* GetHint() const override { return "Click on a label to edit its material"; }
  /** Returns a text such as "5 liver". */
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
  vtkSmartPointer<vtkDataArray> Counted; // searched labels, during the search
  KeyedWork<vtkMTimeType, std::vector<int>> Counting;
};

/**
 * Shows the functions that are proposed for an image, and the edges that they come from, on the
 * chart of vtkHapticFunctionEditor.
 */
class HapticProposalView
{
public:
  explicit HapticProposalView(HapticFunctionChart& chart)
    : Chart(chart)
  {
  }

  vtkSmartPointer<vtkHapticProperty> Property; ///< receives an accepted proposal; may be null
  vtkSmartPointer<vtkImageData> Image;         ///< searched image; may be null
  int GetComponent() const { return this->Property ? this->Property->GetComponent() : 0; }

  ///@{
  /**
   * SearchNow() waits for the end of the search. Begin() searches in the background; false, with
   * the reason and the cure in `error`, if the image can't be looked at. Poll() returns the
   * result once. Both show a proposal that was found.
   */
  FoundFunctions SearchNow();
  bool Begin(std::string& error);
  std::optional<FoundFunctions> Poll();
  bool IsUnderWay() const { return this->Search.IsUnderWay(); }
  double GetProgress() const { return this->Search.GetProgress(); }
  ///@}

  /** Ends the search in an image that was removed. */
  void EndOtherSearch() { this->Search.EndUnless(this->Image); }

  ///@{
  /**
   * Tell of, accept and drop a proposal that is neither accepted nor dropped yet. Drop() also ends
   * the search.
   */
  bool IsThere() const { return this->Proposal != nullptr; }
  bool Apply();
  bool Drop();
  ///@}

  /** Shows the edges of the proposal, or of one accepted before, once they are counted. */
  void PollEdges();

  /** Draws the proposed function beside the edited one, and the limits of distinctness. */
  void ShowFunction(vtkPiecewiseFunction* (vtkHapticProperty::*get)());

private:
  vtkHapticProperty* GetProposed() const;
  bool ShowsEdges() const;
  SearchedData GetSearched();
  void Show(const FoundFunctions& found);
  void Show(const EdgeHistogram& edges);

  HapticFunctionChart& Chart;
  FunctionSearch Search;
  vtkSmartPointer<vtkHapticProperty> Proposal;
  vtkSmartPointer<vtkTable> Boundaries; // shown by the chart
  vtkTimeStamp EdgeTime;
};

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

  /** Sets the page, a vtkHapticFunctionEditor::FunctionType. */
  void SetPage(int page) { this->Page = page; }
  /** Whether there is something to edit on a page. */
  bool Has(int page) const;
  const char* GetTitle() const;

  /** Returns the function of the page; null if it has none. */
  vtkPiecewiseFunction* GetFunction() const;
  EditedObjects GetEdited() const;
  /** Returns the functions that can be edited on the page. */
  EditedObjects GetEditable() const;
  /** Returns the error in stiffness and viscosity, on their pages; empty if there is none. */
  std::string GetWarning() const;
  /** Gives the axis of values the scale of the page's functions. */
  void ScaleValues();
  /** Returns the time of the last edit. */
  vtkMTimeType GetEditTime() const;

  ///@{
  /** Whether the histogram or the list of the page is complete. */
  bool IsCounted() const;
  void Count();
  void PollCounts();
  double GetCountedFraction() const;
  /** Ends the work on an image that was removed. */
  void EndOtherCounts();
  ///@}

  /** Fits the page into a rectangle: left, bottom, width and height. */
  void Show(const int rectangle[4], bool isDragged, double scale = 1.0);
  /** Returns the actors that draw the page. */
  std::vector<vtkContextActor*> GetActors();
  std::vector<vtkContextActor*> GetAllActors();

  /**
   * Passes a mouse event to the part under the mouse, as HapticFunctionChart::SendMouse does; after
   * a press, to the part that was pressed.
   */
  void SendMouse(int event, int button, int x, int y);
  void Turn(int x, int y, double steps);

  /** Returns the page's list with sliders; null if it has none. */
  HapticMaterialSheet* GetSheet();
  HapticMaterialSheet& GetLabels() { return this->Labels; }
  HapticMaterialSheet& GetTissues() { return this->Tissues; }

private:
  bool IsSheetPage() const;
  bool IsOnSheet(int x) const;

  HapticMaterialSheet Labels{ LabelList };
  HapticMaterialSheet Tissues{ TissueList };
  int Page = 0;
  bool HasBoth = false;    ///< whether chart and tissues are shown side by side
  int Split = 0;           ///< x coordinates between chart and tissues
  bool HoldsSheet = false; ///< true between press and release
};

} // namespace VolumeHaptics

#endif
