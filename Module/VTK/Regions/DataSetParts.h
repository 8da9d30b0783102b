// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The parts of a data set that is no image, and the regular grid on which it is sampled.
 */
#ifndef DataSetParts_h
#define DataSetParts_h

#include "vtkBoundingBox.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace VolumeHaptics
{

/** The regular grid: samples stand at Origin + Spacing times their index, which counts from 0. */
struct SamplingGrid
{
  int Dimensions[3] = { 0, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing = 1.0;
};

/** The parts with cells: the data set, or the leaves of a composite one. */
std::vector<vtkDataSet*> FindParts(vtkDataObject* data);

double CountCells(const std::vector<vtkDataSet*>& parts);

/** Around all parts; not valid if they have no points. */
vtkBoundingBox FindBox(const std::vector<vtkDataSet*>& parts);

/**
 * The edge of a cube as large as a cell of the box is on average, but small enough that 24 samples
 * go along the shortest edge. 0 or not finite if the box has no volume.
 */
double FindSampleSpacing(const vtkBoundingBox& box, double cells);

/**
 * The grid in the middle of the box, so that what is left of its edges is outside on both sides.
 * False if the box has no volume, or more than a million samples would go along an edge.
 */
bool PlaceGrid(const vtkBoundingBox& box, double spacing, SamplingGrid& grid);

} // namespace VolumeHaptics

#endif
