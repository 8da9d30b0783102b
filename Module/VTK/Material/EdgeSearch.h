// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the edges of a volume at a bounded number of voxels.
 */
#ifndef EdgeSearch_h
#define EdgeSearch_h

#include "Core/Proposal/EdgeLine.h"
#include "VTK/Material/SearchPart.h"

#include <vector>

namespace VolumeHaptics
{

/**
 * Picks one voxel in each of at most about a million equal blocks, at a position in it that looks
 * random but is always the same.
 *
 * In a large volume (IsLargeVolume), which may be mapped from a file, picks the voxels of up to 512
 * rows along the first axis, of up to 2048 voxels each, at such positions. All voxels are still
 * equally likely, but a row's samples lie side by side, so that only few pages of the file are
 * read, however large the volume is.
 */
std::vector<Vector3> ScatterVoxels(const VolumeView& view);

/**
 * Finds the lines through those voxels that are on an edge; some ten thousand at most. Incomplete
 * if the search is cancelled.
 */
std::vector<EdgeLine> FindEdges(const VolumeView& view, const EdgeTracer& tracer,
  const EdgeThresholds& thresholds, const SearchPart& part);

} // namespace VolumeHaptics

#endif
