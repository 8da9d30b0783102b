// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the samples of a segmentation in a NRRD file: their geometry, and one label for each voxel.
 *
 * Overlapping segments are in layers. The layers are one more axis of the samples, which is the
 * first axis in most files. In a voxel with several segments, the one that comes last in the file
 * counts, as in 3D Slicer.
 */
#ifndef NrrdImage_h
#define NrrdImage_h

#include "VTK/Material/Labels/NrrdLabels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace VolumeHaptics
{

/** Samples as the header describes them. Positions are left-posterior-superior, as in ITK. */
struct NrrdImage
{
  std::array<std::size_t, 3> Size{};
  std::size_t Layers = 1;
  std::size_t Inner = 1; ///< number of samples between two layers of a voxel
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Origin{};
  /** Directions of the axes, as the columns of a matrix. */
  std::array<double, 9> Directions{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::size_t SampleSize = 1; ///< size of a sample (bytes)
  bool IsSigned = false;
  bool IsSwapped = false;
  bool IsCompressed = false;

  std::size_t CountVoxels() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  std::size_t CountBytes() const { return this->CountVoxels() * this->Layers * this->SampleSize; }
};

/**
 * Interprets a header. Returns false, with the reason and the cure in `error`, if it is not the
 * header of a segmentation, or if the samples can't be read.
 */
bool ReadNrrdImage(const NrrdHeader& header, NrrdImage& image, std::string& error);

/** Writes the next bytes of the samples to memory. Returns their number. */
using NrrdBytes = std::function<std::size_t(char*, std::size_t)>;

/**
 * Reads one label for each voxel into memory that is filled with zeros. Values without a segment
 * stay unchanged if labels are the values; otherwise they become 0. On failure, returns false, with
 * the reason and the cure in `error`.
 */
bool ReadNrrdSamples(const SegmentationHeader& header, const NrrdImage& image,
  const NrrdBytes& bytes, int* labels, std::string& error);

} // namespace VolumeHaptics

#endif
