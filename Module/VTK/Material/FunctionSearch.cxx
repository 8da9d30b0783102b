// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/FunctionSearch.h"

#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/HapticProposal.h"
#include "VTK/Material/SearchPart.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Largest slope in the histogram, as a multiple of the largest slope of a boundary. */
constexpr double SlopeRoom = 1.25;
/** Fraction of the time that is spent on finding functions; after that, edges are counted. */
constexpr double ProposalShare = 0.8;

EdgeHistogram MakeFrame(const SearchedData& data, double mostSlope)
{
  EdgeHistogram frame;
  std::copy_n(data.Values, 2, frame.Values);
  frame.MostSlope = SlopeRoom * mostSlope;
  return frame;
}

FoundFunctions SearchInput(
  const ProposalInput& input, const SearchedData& data, WorkMonitor* monitor)
{
  FoundFunctions found;
  MaterialProposal proposal;
  if (ProposeFromVolume(input, { monitor, 0.0, ProposalShare }, proposal, found.Error))
  {
    found.Edges =
      MakeFrame(data, *std::max_element(proposal.Slopes.begin(), proposal.Slopes.end()));
    CountEdges(input.Volume, proposal.KernelRadius, { monitor, ProposalShare, 1.0 }, found.Edges);
    found.Proposal = std::move(proposal);
  }
  return found;
}

} // namespace

FunctionSearch::DataKey FunctionSearch::MakeKey(const SearchedData& data)
{
  return { data.Image, data.Image ? data.Image->GetMTime() : 0, data.Component };
}

FoundFunctions FunctionSearch::FindNow(const SearchedData& data)
{
  FoundFunctions found;
  ProposalInput input;
  return ReadProposalInput(data.Image, data.Component, input, found.Error)
    ? SearchInput(input, data, nullptr)
    : found;
}

bool FunctionSearch::Begin(const SearchedData& data, std::string& error)
{
  // The work keeps the input until its owner ends it.
  const auto input = std::make_shared<ProposalInput>();
  this->IsWanted = ReadProposalInput(data.Image, data.Component, *input, error);
  if (this->IsWanted)
  {
    this->SearchedImage = data.Image;
    this->Search.Follow(MakeKey(data),
      [input, data](WorkMonitor& monitor) -> std::optional<FoundFunctions>
      {
        FoundFunctions found = SearchInput(*input, data, &monitor);
        return monitor.IsCancelled() ? std::nullopt : std::make_optional(std::move(found));
      });
  }
  return this->IsWanted;
}

std::optional<FoundFunctions> FunctionSearch::Follow(const SearchedData& data)
{
  if (!this->IsWanted)
  {
    return std::nullopt;
  }
  const DataKey key = MakeKey(data);
  FoundFunctions found;
  if (!this->Search.IsOf(key))
  {
    if (this->Begin(data, found.Error))
    {
      return std::nullopt;
    }
  }
  else if (const FoundFunctions* const result = this->Search.Find(key))
  {
    found = *result;
  }
  else if (this->Search.IsUnderWay())
  {
    return std::nullopt;
  }
  else
  {
    found.Error = "There was not enough memory to look for functions. Close what else is open, or "
                  "set the functions by hand.";
  }
  this->IsWanted = false;
  this->Search.Forget();
  return found;
}

void FunctionSearch::Drop()
{
  this->IsWanted = false;
  this->Search.Abandon();
}

const EdgeHistogram* FunctionSearch::FollowEdges(
  const SearchedData& data, vtkTable* boundaries, int kernelRadius)
{
  const EdgeKey key{ MakeKey(data), boundaries };
  if (this->Count.IsOf(key))
  {
    return this->Count.Find(key);
  }
  double slopes[2];
  vtkDataArray::SafeDownCast(boundaries->GetColumnByName("Slope"))->GetRange(slopes);
  const EdgeHistogram frame = MakeFrame(data, slopes[1] / data.SlopeScale);
  const auto input = std::make_shared<ProposalInput>();
  std::string error;
  const bool isThere = ReadProposalInput(data.Image, data.Component, *input, error);
  this->CountedImage = data.Image;
  return this->Count.Follow(key,
    [=](WorkMonitor& monitor) -> std::optional<EdgeHistogram>
    {
      EdgeHistogram edges = frame;
      if (isThere)
      {
        CountEdges(input->Volume, kernelRadius, { &monitor }, edges);
      }
      return edges;
    });
}

void FunctionSearch::EndUnless(vtkImageData* image)
{
  if (image != this->SearchedImage)
  {
    this->Search.Forget(); // if this search is still wanted, it starts again with the other image
    this->IsWanted = this->IsWanted && image;
  }
  if (image != this->CountedImage)
  {
    this->Count.Forget();
  }
}

double FunctionSearch::GetProgress() const
{
  double share = 1.0;
  if (this->IsWanted)
  {
    share = this->Search.GetProgress();
  }
  if (this->Count.IsUnderWay())
  {
    share = std::min(share, this->Count.GetProgress());
  }
  return share;
}

} // namespace VolumeHaptics
