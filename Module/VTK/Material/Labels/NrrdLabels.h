// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the segments that 3D Slicer and VolView store in the header of a NRRD file (.seg.nrrd).
 *
 * A segment has a name, a colour, a layer, and the value that its voxels have in this layer:
 * SegmentN_Name, _Color, _Layer and _LabelValue. Overlapping segments are in separate layers, and a
 * value may occur in several layers. Old files have neither layers nor values: segment N is layer
 * N, with the value 1.
 *
 * In the table, a segment's label is its value. If two segments of different layers have the same
 * value, the label of every segment is N + 1 instead.
 */
#ifndef NrrdLabels_h
#define NrrdLabels_h

#include "VTK/Base/NrrdHeader.h"
#include "VTK/Material/Labels/LabelEntry.h"

#include <string>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{

struct NrrdSegment
{
  int Layer = 0;
  int Value = 1; ///< value in its layer
  int Label = 1; ///< label in the table
  LabelEntry Entry;
};

/** A header and its segments, in ascending order of N. */
struct SegmentationHeader : NrrdHeader
{
  std::vector<NrrdSegment> Segments;
};

/**
 * Reads the header at the beginning of a file. On failure, returns false, with the reason and the
 * cure in `error`. A header without segments is valid.
 */
bool ReadSegmentationHeader(std::string_view bytes, SegmentationHeader& header, std::string& error);

/**
 * Reads the segments. If there are none, returns false, with the reason and the cure in `error`,
 * and leaves the entries unchanged.
 */
bool ReadNrrdLabels(std::string_view bytes, LabelEntries& entries, std::string& error);

} // namespace VolumeHaptics

#endif
