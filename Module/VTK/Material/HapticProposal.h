// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Proposes functions from the edges of an image (vtkHapticProperty::ProposeFromImage). The edges
 * are found by examining a limited number of voxels.
 */
#ifndef HapticProposal_h
#define HapticProposal_h

#include "Core/Proposal/EdgeLine.h"
#include "Core/Proposal/MaterialProposal.h"
#include "Core/Realtime/BackgroundWork.h"
#include "VTK/Base/HapticVolume.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

class vtkHapticProperty;

namespace VolumeHaptics
{

/**
 * One part of a search through many voxels. Without a monitor, the search runs on all cores while
 * the caller waits. With a monitor, it runs in the background.
 */
struct SearchPart
{
  WorkMonitor* Monitor = nullptr;
  ///@{
  /** Progress of the whole search when this part begins and ends. */
  double Begin = 0.0;
  double End = 1.0;
  ///@}

  bool IsCancelled() const { return this->Monitor && this->Monitor->IsCancelled(); }
};

/**
 * Calls look(first, end) for ranges that cover all numbers below `count`: on all cores, or, with a
 * monitor, piece by piece on this low-priority thread alone. Returns false if the search is
 * cancelled.
 */
template <typename Look>
bool LookAtAll(std::size_t count, std::size_t piece, const SearchPart& part, Look&& look)
{
  if (!part.Monitor)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), look);
    return true;
  }
  for (std::size_t first = 0; first < count; first += piece)
  {
    const double fraction = static_cast<double>(first) / static_cast<double>(count);
    if (!part.Monitor->GoesOn(part.Begin + fraction * (part.End - part.Begin)))
    {
      return false;
    }
    look(static_cast<vtkIdType>(first), static_cast<vtkIdType>(std::min(first + piece, count)));
  }
  return !part.IsCancelled();
}

/**
 * Picks one voxel in each of at most about a million equal blocks, at a position in the block that
 * is pseudo-random but always the same.
 *
 * A large volume (IsLargeVolume) may be mapped from a file. There, picks the voxels of up to 512
 * rows along the first axis, with up to 2048 voxels each, at pseudo-random positions. All voxels
 * are still equally likely, but the samples of a row are adjacent, so that only few pages of the
 * file are read, however large the volume is.
 */
std::vector<Vector3> ScatterVoxels(const VolumeView& view);

/**
 * Traces lines through the voxels that are on an edge, some ten thousand at most. The result is
 * incomplete if the search is cancelled.
 */
std::vector<EdgeLine> DetectEdges(const VolumeView& view, const EdgeTracer& tracer,
  const EdgeThresholds& thresholds, const SearchPart& part);

/** A component of an image, in a form that a search on another thread may read. */
struct ProposalInput
{
  vtkSmartPointer<vtkImageData> Image; ///< new image that shares the arrays of the user's image
  int Component = 0;
  HapticVolume Volume;
};

/**
 * Reads the input. Returns false, with the reason and the cure in `error`, if there is nothing to
 * search.
 */
bool ReadProposalInput(
  vtkImageData* image, int component, ProposalInput& input, std::string& error);

/**
 * Proposes functions from a limited number of an image's voxels. Returns false, with the reason and
 * the cure in `error`, if there is nothing to propose, or if the search was cancelled.
 */
bool ProposeFromVolume(const ProposalInput& input, const SearchPart& part,
  MaterialProposal& proposal, std::string& error);

/** Sets the five functions, the side and the table of boundaries of a property in place. */
void FillFromProposal(const MaterialProposal& proposal, vtkHapticProperty* property);

/** Copies the functions that FillFromProposal() has set in `proposed` to a property. */
void CopyProposal(vtkHapticProperty* proposed, vtkHapticProperty* property);

} // namespace VolumeHaptics

#endif
