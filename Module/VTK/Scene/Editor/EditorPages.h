// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The pages of vtkHapticFunctionEditor: one chart per function, and the lists of labels and
 * tissues.
 */
#ifndef EditorPages_h
#define EditorPages_h

#include "Core/Realtime/BackgroundWork.h"
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
 * List of the labels in a label image, or, without an image, in the table; and the material of the
 * selected label.
 */
class HapticLabelList : public HapticMaterialList
{
public:
  vtkSmartPointer<vtkHapticLabelTable> Table;
  vtkSmartPointer<vtkImageData> Image;

  ///@{
  /**
   * Count() searches the image for labels. For a large image, the list first shows the labels of a
   * subset of the samples, until PollCount() receives the result of a worker that has searched all
   * voxels. IsCounted() returns whether the list is up to date.
   */
  void Count();
  bool IsCounted() const override;
  void PollCount();
  /** Cancels the search in an image that is no longer shown, because the program may delete it. */
  void EndOtherCount();
  /** Returns the fraction of the image in which labels were searched, 0 to 1. */
  double GetCountedFraction() const;
  ///@}

  vtkIdType GetNumberOfRows() const override;
  int GetKey(vtkIdType row) const override;
  vtkObject* GetEdited() const override;
  std::string GetTitle() const override;
  const char* GetHint() const override { return "Click on a label to edit its material"; }
  /** Returns the text of a row, such as "5 liver". */
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
  /** Image of the list; only compared, never dereferenced. */
  const vtkImageData* CountedImage = nullptr;
  vtkTimeStamp CountTime;
  // Labels being searched; null when no search is running.
  vtkSmartPointer<vtkDataArray> Counted;
  KeyedWork<vtkMTimeType, std::vector<int>> Counting;
};

/**
 * Shows proposed functions for an image on the chart of vtkHapticFunctionEditor, and the edges that
 * they were proposed from.
 */
class HapticProposalView
{
public:
  explicit HapticProposalView(HapticFunctionChart& chart)
    : Chart(chart)
  {
  }

  /** Property to receive an accepted proposal; may be null. */
  vtkSmartPointer<vtkHapticProperty> Property;
  vtkSmartPointer<vtkImageData> Image; ///< image to search; may be null
  int GetComponent() const { return this->Property ? this->Property->GetComponent() : 0; }

  ///@{
  /**
   * Search for a proposal, and show it if one is found. SearchNow() returns after the search.
   * Begin() searches in the background; it returns false, with the reason and the cure in `error`,
   * if the image can't be searched. Poll() returns the result once.
   */
  FoundFunctions SearchNow();
  bool Begin(std::string& error);
  std::optional<FoundFunctions> Poll();
  bool IsUnderWay() const { return this->Search.IsUnderWay(); }
  double GetProgress() const { return this->Search.GetProgress(); }
  ///@}

  /** Cancels the search in an image that was replaced. */
  void EndOtherSearch() { this->Search.EndUnless(this->Image); }

  ///@{
  /**
   * Handle the pending proposal: IsThere() returns whether there is one, Apply() accepts it, Drop()
   * discards it and cancels a search.
   */
  bool IsThere() const { return this->Proposal != nullptr; }
  bool Apply();
  bool Drop();
  ///@}

  /** Shows the edges of the pending or last accepted proposal once they are counted. */
  void PollEdges();

  /**
   * Draws the proposed function beside the edited one, and the limits of distinctness. `get`
   * returns the function from a property.
   */
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
  vtkSmartPointer<vtkTable> Boundaries; // boundaries on the chart
  vtkTimeStamp EdgeTime;
};

/**
 * The edited objects, and the charts and lists that show them. Shows one page at a time; in a wide
 * editor, the tissues are beside the chart of a function. Positions are pixels of the viewport.
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
  /** Returns whether a page has an object to edit. */
  bool Has(int page) const;
  const char* GetTitle() const;

  /** Returns the function that the page edits; null if it has none. */
  vtkPiecewiseFunction* GetFunction() const;
  EditedObjects GetEdited() const;
  /** Returns the objects that the current page can edit; the others are null. */
  EditedObjects GetEditable() const;
  /**
   * Returns a warning if the page shows stiffness or viscosity, and any value is too soft for its
   * viscosity; empty otherwise.
   */
  std::string GetWarning() const;
  /** Sets the scale of the value axis to that of the page's functions. */
  void ScaleValues();
  /** Returns the modification time of the edited objects, which is the time of the last edit. */
  vtkMTimeType GetEditTime() const;

  ///@{
  /** Returns whether the histogram or list of the page is complete. */
  bool IsCounted() const;
  void Count();
  void PollCounts();
  double GetCountedFraction() const;
  /** Cancels the work on an image that was replaced. */
  void EndOtherCounts();
  ///@}

  /** Fits the page into a rectangle: left, bottom, width, height. */
  void Show(const int rectangle[4], bool isDragged, double scale = 1.0);
  /** Return the actors of the current page, or of all pages. */
  std::vector<vtkContextActor*> GetActors();
  std::vector<vtkContextActor*> GetAllActors();

  /**
   * Passes a mouse event to the part under the mouse, like HapticFunctionChart::SendMouse. While a
   * button is pressed, its events go to the part where it was pressed.
   */
  void SendMouse(int event, int button, int x, int y);
  void Turn(int x, int y, double steps);

  /** Returns the list of materials on the page; null if it has none. */
  HapticMaterialSheet* GetSheet();
  HapticMaterialSheet& GetLabels() { return this->Labels; }
  HapticMaterialSheet& GetTissues() { return this->Tissues; }

private:
  bool IsSheetPage() const;
  bool IsOnSheet(int x) const;

  HapticMaterialSheet Labels{ LabelList };
  HapticMaterialSheet Tissues{ TissueList };
  int Page = 0;
  bool HasBoth = false;    ///< whether chart and tissues are side by side
  int Split = 0;           ///< x of the border between chart and tissues
  bool HoldsSheet = false; ///< whether the mouse was pressed in the list and not released yet
};

} // namespace VolumeHaptics

#endif
