// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The shapes of labels in one slice of a label image: the distances from their outlines, and their
 * connected pieces.
 */
#ifndef LabelShapes_h
#define LabelShapes_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** A box of pixels in a slice: from Low (included) to High (excluded) along both axes. */
struct PixelBox
{
  std::int64_t Low[2];
  std::int64_t High[2];

  std::int64_t Size(int a) const { return this->High[a] - this->Low[a]; }
  std::int64_t Area() const { return this->Size(0) * this->Size(1); }
};

/** A run of adjacent pixels of a label in a row, and the number of their connected piece. */
struct PieceRun
{
  std::int64_t Row;
  std::int64_t Begin;
  std::int64_t End;
  std::size_t Piece;
};

/**
 * The signed distances of a label in a slice. They are stored for a box; outside the box, they are
 * -Away.
 */
struct LabelShape
{
  std::int64_t Label;
  PixelBox Box;
  std::vector<std::int16_t> Distances;
  std::vector<PieceRun> Runs; ///< runs of pixels whose distances are above 0, row by row
  std::size_t Pieces = 0;

  /**
   * Returns the distances of a row in 256ths of a fine voxel, beginning with the box's first pixel.
   * Returns null if the box does not contain the row.
   */
  const std::int16_t* GetRow(std::int64_t j) const
  {
    return j >= this->Box.Low[1] && j < this->Box.High[1]
      ? &this->Distances[static_cast<std::size_t>(this->Box.Size(0) * (j - this->Box.Low[1]))]
      : nullptr;
  }
};

using SliceShapes = std::vector<LabelShape>;

/**
 * The sizes of a slice's pixels in fine voxels, and the distance assigned to a label that the slice
 * lacks.
 */
struct SliceGrid
{
  std::int64_t Size[2];
  double Pixel[2];
  double Step; ///< distance to the next slice in fine voxels
  double Away;
};

/** Returns the shape of a label in a slice, or null if the slice lacks the label. */
const LabelShape* FindShape(const SliceShapes& shapes, std::int64_t label);

/**
 * ExtractShapes() returns the shapes of all labels in a slice, without distances. MeasureShapes()
 * adds the distances.
 */
SliceShapes ExtractShapes(const SliceGrid& grid, const std::vector<std::int64_t>& labels);

void MeasureShapes(
  const SliceGrid& grid, const std::vector<std::int64_t>& labels, SliceShapes& shapes);

/** Returns the signed distance of a label at a pixel in fine voxels. */
float DistanceAt(const LabelShape* shape, const SliceGrid& grid, std::int64_t i, std::int64_t j);

/**
 * Finds the pieces of a label that end at this slice, because the next slice lacks them. Around
 * them, limits the distances of all labels in the next slice, so that each piece ends like a ball,
 * with the same slope around its end.
 */
void LimitEnds(const SliceGrid& grid, const LabelShape& shape, const LabelShape* before,
  const LabelShape* next, std::vector<float>& limits);

} // namespace VolumeHaptics

#endif
