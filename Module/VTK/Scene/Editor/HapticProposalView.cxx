// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticProposalView.h"

#include "VTK/Material/HapticProposal.h"
#include "VTK/Scene/Editor/HapticFunctionChart.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{

/** The property whose edges are shown: the proposal, or a property with an earlier proposal. */
vtkHapticProperty* HapticProposalView::GetProposed() const
{
  vtkHapticProperty* const any = this->Proposal ? this->Proposal : this->Property;
  return this->Image && any && any->GetProposedBoundaries() ? any : nullptr;
}

/** The data to search for edges; shows their histogram first. */
SearchedData HapticProposalView::GetSearched()
{
  this->Chart.ShowData(this->Image, this->GetComponent());
  SearchedData data;
  data.Image = this->Image;
  data.Component = this->GetComponent();
  std::copy_n(this->Chart.GetDataRange(), 2, data.Values);
  vtkHapticProperty* const proposed = this->GetProposed();
  data.SlopeScale = proposed ? proposed->GetScalarScale() : 1.0;
  return data;
}

void HapticProposalView::Show(const FoundFunctions& found)
{
  if (found.Proposal)
  {
    this->Proposal = vtkSmartPointer<vtkHapticProperty>::New();
    if (this->Property)
    {
      this->Proposal->SetScalarShift(this->Property->GetScalarShift());
      this->Proposal->SetScalarScale(this->Property->GetScalarScale());
      this->Proposal->NoteShift(this->Property->GetFoundShift());
    }
    FillFromProposal(*found.Proposal, this->Proposal);
    this->Show(found.Edges);
  }
}

void HapticProposalView::Show(const EdgeHistogram& edges)
{
  this->Boundaries = this->GetProposed()->GetProposedBoundaries();
  this->EdgeTime.Modified();
  this->Chart.ShowEdges(edges, this->GetProposed());
}

FoundFunctions HapticProposalView::FindNow()
{
  this->Search.Drop();
  FoundFunctions found = FunctionSearch::FindNow(this->GetSearched());
  this->Show(found);
  return found;
}

bool HapticProposalView::Begin(std::string& error)
{
  return this->IsUnderWay() || this->Search.Begin(this->GetSearched(), error);
}

std::optional<FoundFunctions> HapticProposalView::Follow()
{
  if (!this->IsUnderWay())
  {
    return std::nullopt;
  }
  std::optional<FoundFunctions> found = this->Search.Follow(this->GetSearched());
  if (found)
  {
    this->Show(*found);
  }
  return found;
}

bool HapticProposalView::Take()
{
  const auto proposal = std::exchange(this->Proposal, nullptr);
  const bool isTaken = proposal && this->Property;
  if (isTaken)
  {
    CopyProposal(proposal, this->Property);
  }
  return isTaken;
}

bool HapticProposalView::Drop()
{
  const bool wasThere = std::exchange(this->Proposal, nullptr) != nullptr || this->IsUnderWay();
  if (wasThere)
  {
    this->Search.Drop();
  }
  return wasThere;
}

bool HapticProposalView::ShowsEdges() const
{
  vtkHapticProperty* const proposed = this->GetProposed();
  return proposed ? this->Boundaries == proposed->GetProposedBoundaries() &&
      this->EdgeTime > this->Image->GetMTime()
                  : !this->Chart.ShowsEdges();
}

void HapticProposalView::FollowEdges()
{
  if (this->ShowsEdges())
  {
    return;
  }
  vtkHapticProperty* const proposed = this->GetProposed();
  if (!proposed)
  {
    this->Boundaries = nullptr;
    this->Chart.HideEdges();
  }
  else if (const EdgeHistogram* const edges = this->Search.FollowEdges(this->GetSearched(),
             proposed->GetProposedBoundaries(), proposed->GetProposedKernelRadius()))
  {
    this->Show(*edges);
  }
}

void HapticProposalView::ShowFunction(vtkPiecewiseFunction* (vtkHapticProperty::*get)())
{
  this->Chart.NoteSearch(this->GetProgress());
  this->Chart.ShowProposed(this->Proposal && get ? (this->Proposal.Get()->*get)() : nullptr);
  if (vtkHapticProperty* const felt = this->GetProposed())
  {
    const double* const range = felt->GetDistinctness()->GetRange();
    const double scale = felt->GetScalarScale();
    this->Chart.ShowDistinctness(range[0] / scale, range[1] / scale);
  }
}

} // namespace VolumeHaptics
