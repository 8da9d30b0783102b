// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The edges of a volume, found at a bounded number of voxels.
 */
#ifndef EdgeSearch_h
#define EdgeSearch_h

#include "Core/Proposal/EdgeLine.h"
#include "VTK/Material/SearchPart.h"

#include <vector>

namespace VolumeHaptics
{

/**
 * One voxel in each of at most about a million equal blocks, at a place in it that looks random but
 * is always the same.
 *
 * Of a large volume (IsLargeVolume), which may be mapped from a file: the voxels of up to 512 rows
 * along the first axis, of up to 2048 voxels each, at such places. All voxels are still as likely
 * as each other, but a row's samples lie side by side, so that few pages of the file are read, and
 * no more of a larger volume.
 */
std::vector<Vector3> ScatterVoxels(const VolumeView& view);

/**
 * The lines through those of the voxels that stand on an edge; some ten thousand at most. Not all
 * of them if the search is cancelled.
 */
std::vector<EdgeLine> FindEdges(const VolumeView& view, const EdgeTracer& tracer,
  const EdgeThresholds& thresholds, const SearchPart& part);

} // namespace VolumeHaptics

#endif
