// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows the functions that are proposed for an image, and the edges that they come from, on the
 * chart of vtkHapticFunctionEditor.
 */
#ifndef HapticProposalView_h
#define HapticProposalView_h

#include "VTK/Material/FunctionSearch.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"

#include <optional>
#include <string>

class vtkPiecewiseFunction;

namespace VolumeHaptics
{

class HapticFunctionChart;

class HapticProposalView
{
public:
  explicit HapticProposalView(HapticFunctionChart& chart)
    : Chart(chart)
  {
  }

  vtkSmartPointer<vtkHapticProperty> Property; ///< takes a proposal; may be null
  vtkSmartPointer<vtkImageData> Image;         ///< may be null
  int GetComponent() const { return this->Property ? this->Property->GetComponent() : 0; }

  ///@{
  /**
   * FindNow() waits for the end of the search. Begin() searches in the background; false, with the
   * reason and the cure in `error`, if the image can't be looked at. Follow() returns the result
   * once. Both show a proposal that was found.
   */
  FoundFunctions FindNow();
  bool Begin(std::string& error);
  std::optional<FoundFunctions> Follow();
  bool IsUnderWay() const { return this->Search.IsUnderWay(); }
  double GetProgress() const { return this->Search.GetProgress(); }
  ///@}

  /** Waits until no search uses an image that was removed. */
  void EndOtherSearch() { this->Search.EndUnless(this->Image); }

  ///@{
  /** A proposal that is neither accepted nor dropped. Drop() also ends the search. */
  bool IsThere() const { return this->Proposal != nullptr; }
  bool Take();
  bool Drop();
  ///@}

  /** Shows the edges of the proposal, or of one accepted before, once they are counted. */
  void FollowEdges();

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

} // namespace VolumeHaptics

#endif
