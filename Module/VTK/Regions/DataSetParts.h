// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the parts of a data set that is not an image, and the regular grid on which it is sampled.
 */
#ifndef DataSetParts_h
#define DataSetParts_h

#include "vtkBoundingBox.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace VolumeHaptics
{

/**
 * The regular grid: a sample's position is Origin + Spacing times its index, which counts from 0.
 */
struct SamplingGrid
{
  int Dimensions[3] = { 0, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing = 1.0;
};

/** Finds the parts with cells: the data set, or the leaves of a composite one. */
std::vector<vtkDataSet*> CollectParts(vtkDataObject* data);

double CountCells(const std::vector<vtkDataSet*>& parts);

/** Computes the box around all parts; not valid if they have no points. */
vtkBoundingBox ComputeBox(const std::vector<vtkDataSet*>& parts);

/**
 * Returns the edge of a cube as large as the average cell of the box, but small enough for 24
 * samples along the shortest edge. 0 or not finite if the box has no volume.
 */
double ComputeSampleSpacing(const vtkBoundingBox& box, double cells);

/**
 * Places the grid in the middle of the box, so that the rest of its edges lies outside on both
 * sides. Returns false if the box has no volume, or an edge would need more than a million samples.
 */
bool PlaceGrid(const vtkBoundingBox& box, double spacing, SamplingGrid& grid);

} // namespace VolumeHaptics

#endif
