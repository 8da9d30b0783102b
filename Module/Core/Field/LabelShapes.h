// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The shapes of labels in one slice of a label image: distances from their outlines, and connected
 * pieces.
 */
#ifndef LabelShapes_h
#define LabelShapes_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** Pixels of a slice: from Low (included) to High (excluded) along the two axes. */
struct PixelBox
{
  std::int64_t Low[2];
  std::int64_t High[2];

  std::int64_t Size(int a) const { return this->High[a] - this->Low[a]; }
  std::int64_t Area() const { return this->Size(0) * this->Size(1); }
};

/** Pixels of a row within a label, with the number of their connected piece. */
struct PieceRun
{
  std::int64_t Row;
  std::int64_t Begin;
  std::int64_t End;
  std::size_t Piece;
};

/** The signed distances of a label in a slice, in a box beyond which they are -Away. */
struct LabelShape
{
  std::int64_t Label;
  PixelBox Box;
  std::vector<std::int16_t> Distances;
  std::vector<PieceRun> Runs; ///< the runs where distances are above 0, row by row
  std::size_t Pieces = 0;

  /**
   * Returns the distances in 256ths of a fine voxel, from the box's first pixel of a row on; null
   * if the box does not contain the row.
   */
  const std::int16_t* GetRow(std::int64_t j) const
  {
    return j >= this->Box.Low[1] && j < this->Box.High[1]
      ? &this->Distances[static_cast<std::size_t>(this->Box.Size(0) * (j - this->Box.Low[1]))]
      : nullptr;
  }
};

using SliceShapes = std::vector<LabelShape>;

/** The pixels of a slice in fine voxels, and the distance of a label that the slice lacks. */
struct SliceGrid
{
  std::int64_t Size[2];
  double Pixel[2];
  double Step; ///< distance to the next slice
  double Away;
};

/** Returns the shape of a label in a slice; null if the slice lacks the label. */
const LabelShape* FindShape(const SliceShapes& shapes, std::int64_t label);

/**
 * Returns the shapes of a slice's labels, one after another; MeasureShapes() computes their
 * distances.
 */
SliceShapes ExtractShapes(const SliceGrid& grid, const std::vector<std::int64_t>& labels);

void MeasureShapes(
  const SliceGrid& grid, const std::vector<std::int64_t>& labels, SliceShapes& shapes);

/** Returns the signed distance of a label at a pixel, in fine voxels. */
float DistanceAt(const LabelShape* shape, const SliceGrid& grid, std::int64_t i, std::int64_t j);

/**
 * Limits the distances of all labels in the next slice around pieces of a label that the next slice
 * lacks, so that the piece ends as a ball would, with the same slope around its end.
 */
void LimitEnds(const SliceGrid& grid, const LabelShape& shape, const LabelShape* before,
  const LabelShape* next, std::vector<float>& limits);

} // namespace VolumeHaptics

#endif
