// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/FunctionSearch.h"

#include "Core/Field/FieldSampler.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/HapticProposal.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t MostCounted = 200000; // voxels
/** Number of voxels in one piece of background work: some milliseconds. */
constexpr std::size_t CountedAtOnce = 1024;

/** Largest gradient magnitude in the histogram, as a multiple of the steepest boundary's slope. */
constexpr double SlopeRoom = 1.25;
/** Fraction of the search's progress that the functions take. The rest is for counting edges. */
constexpr double ProposalFraction = 0.8;

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
  if (ProposeFromVolume(input, { monitor, 0.0, ProposalFraction }, proposal, found.Error))
  {
    found.Edges =
      MakeFrame(data, *std::max_element(proposal.Slopes.begin(), proposal.Slopes.end()));
    CountEdges(
      input.Volume, proposal.KernelRadius, { monitor, ProposalFraction, 1.0 }, found.Edges);
    found.Proposal = std::move(proposal);
  }
  return found;
}

} // namespace

//------------------------------------------------------------------------------
void CountEdges(
  const HapticVolume& volume, int kernelRadius, const SearchPart& part, EdgeHistogram& histogram)
{
  histogram.Fractions.clear();
  const GradientKernel kernel(GradientEstimator::Gaussian, kernelRadius);
  const FieldSampler field(volume.View, kernel);
  const Matrix3 toWorld = Transpose(Inverse(volume.IndexToWorld.Linear));
  const std::vector<Vector3> voxels = ScatterVoxels(volume.View);
  const std::size_t count = std::min(voxels.size(), MostCounted);
  constexpr int none = -1;
  std::vector<int> cells(count, none);
  const double width = (histogram.Values[1] - histogram.Values[0]) / EdgeHistogram::Columns;
  const double height = histogram.MostSlope / EdgeHistogram::Rows;
  auto look = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const Vector3& index = voxels[i * voxels.size() / count];
      const double slope = Norm(toWorld * field.Gradient(index).Gradient);
      const double column = (field.Value(index) - histogram.Values[0]) / width;
      const double row = slope / height;
      if (column >= 0.0 && column <= EdgeHistogram::Columns && row < EdgeHistogram::Rows)
      {
        cells[i] = static_cast<int>(row) * EdgeHistogram::Columns +
          std::min(static_cast<int>(column), EdgeHistogram::Columns - 1);
      }
    }
  };
  if (!LookAtAll(count, CountedAtOnce, part, look))
  {
    return;
  }
  histogram.Fractions.assign(EdgeHistogram::Columns * EdgeHistogram::Rows, 0.0);
  for (const int cell : cells)
  {
    if (cell != none)
    {
      histogram.Fractions[cell] += 1.0;
    }
  }
  // Ignore the lowest gradients when scaling: they are so frequent that edges would look too pale.
  constexpr int edges = EdgeHistogram::Columns * EdgeHistogram::Rows / 8;
  const double most = std::max(
    1.0, *std::max_element(histogram.Fractions.begin() + edges, histogram.Fractions.end()));
  for (double& fraction : histogram.Fractions)
  {
    fraction = std::min(1.0, std::log1p(fraction) / std::log1p(most));
  }
}

FunctionSearch::DataKey FunctionSearch::MakeKey(const SearchedData& data)
{
  return { data.Image, data.Image ? data.Image->GetMTime() : 0, data.Component };
}

FoundFunctions FunctionSearch::SearchNow(const SearchedData& data)
{
  FoundFunctions found;
  ProposalInput input;
  return ReadProposalInput(data.Image, data.Component, input, found.Error)
    ? SearchInput(input, data, nullptr)
    : found;
}

bool FunctionSearch::Begin(const SearchedData& data, std::string& error)
{
  // The background work owns the input, until it is abandoned.
  const auto input = std::make_shared<ProposalInput>();
  this->IsWanted = ReadProposalInput(data.Image, data.Component, *input, error);
  if (this->IsWanted)
  {
    this->SearchedImage = data.Image;
    this->Search.Poll(MakeKey(data),
      [input, data](WorkMonitor& monitor) -> std::optional<FoundFunctions>
      {
        FoundFunctions found = SearchInput(*input, data, &monitor);
        return monitor.IsCancelled() ? std::nullopt : std::make_optional(std::move(found));
      });
  }
  return this->IsWanted;
}

std::optional<FoundFunctions> FunctionSearch::Poll(const SearchedData& data)
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

const EdgeHistogram* FunctionSearch::PollEdges(
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
  return this->Count.Poll(key,
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
    // If this search is still wanted, Poll() starts it again with the other image.
    this->Search.Forget();
    this->IsWanted = this->IsWanted && image;
  }
  if (image != this->CountedImage)
  {
    this->Count.Forget();
  }
}

double FunctionSearch::GetProgress() const
{
  double fraction = 1.0;
  if (this->IsWanted)
  {
    fraction = this->Search.GetProgress();
  }
  if (this->Count.IsUnderWay())
  {
    fraction = std::min(fraction, this->Count.GetProgress());
  }
  return fraction;
}

} // namespace VolumeHaptics
