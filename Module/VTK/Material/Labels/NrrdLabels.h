// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a segmentation in a NRRD file (.seg.nrrd): the segments that 3D Slicer and VolView store in
 * its header, the geometry of its samples, and one label per voxel.
 *
 * A segment has a name, a colour, a layer, and the value that its voxels have in this layer:
 * SegmentN_Name, _Color, _Layer and _LabelValue. Overlapping segments are in separate layers, and a
 * value may occur in several layers. Old files have neither layers nor values: segment N is layer
 * N, with the value 1.
 *
 * In the table, a segment's label is its value. If two segments of different layers have the same
 * value, the label of every segment is N + 1 instead.
 *
 * The samples have an additional axis for the layers, which is the first axis in most files. In a
 * voxel with several segments, the last one in the file counts, as in 3D Slicer.
 */
#ifndef NrrdLabels_h
#define NrrdLabels_h

#include "VTK/Base/NrrdHeader.h"
#include "VTK/Material/Labels/LabelEntry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{

struct NrrdSegment
{
  int Layer = 0;
  int Value = 1; ///< value of its voxels in its layer
  int Label = 1; ///< label in the label table
  LabelEntry Entry;
};

/** A header with its segments, in ascending order of N. */
struct SegmentationHeader : NrrdHeader
{
  std::vector<NrrdSegment> Segments;
};

/**
 * Parses the header at the beginning of a file. On failure, returns false, with the reason and the
 * cure in `error`. A header without segments is valid.
 */
bool ReadSegmentationHeader(std::string_view bytes, SegmentationHeader& header, std::string& error);

/**
 * Reads the segments as label entries. If there are none, returns false, with the reason and the
 * cure in `error`, and leaves the entries unchanged.
 */
bool ReadNrrdLabels(std::string_view bytes, LabelEntries& entries, std::string& error);

/**
 * Layout and geometry of the samples, from the header. Positions are left-posterior-superior, as in
 * ITK.
 */
struct NrrdImage
{
  std::array<std::size_t, 3> Size{};
  std::size_t Layers = 1;
  std::size_t Inner = 1; ///< number of samples between the layers of one voxel
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Origin{};
  /** Directions of the axes, as the columns of a 3 x 3 matrix. */
  std::array<double, 9> Directions{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::size_t SampleSize = 1; ///< size of a sample (bytes)
  bool IsSigned = false;
  bool IsSwapped = false;
  bool IsCompressed = false;

  std::size_t CountVoxels() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  std::size_t CountBytes() const { return this->CountVoxels() * this->Layers * this->SampleSize; }
};

/**
 * Derives the layout and geometry from a header. Returns false, with the reason and the cure in
 * `error`, if the header does not describe a segmentation, or if the samples can't be read.
 */
bool ReadNrrdImage(const NrrdHeader& header, NrrdImage& image, std::string& error);

/** Function that copies the next bytes of the samples to memory and returns their number. */
using NrrdBytes = std::function<std::size_t(char*, std::size_t)>;

/**
 * Reads one label per voxel into memory that is filled with zeros. A value without a segment is
 * kept if labels are the values; otherwise it becomes 0. On failure, returns false, with the reason
 * and the cure in `error`.
 */
bool ReadNrrdSamples(const SegmentationHeader& header, const NrrdImage& image,
  const NrrdBytes& bytes, int* labels, std::string& error);

} // namespace VolumeHaptics

#endif
