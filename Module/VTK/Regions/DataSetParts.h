// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the parts of a data set that is not an image, and the regular grid on which it is sampled.
 */
#ifndef DataSetParts_h
#define DataSetParts_h

#include "vtkBoundingBox.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace VolumeHaptics
{

/**
 * The regular grid. The position of a sample is Origin + Spacing times its index, which begins at
 * 0.
 */
struct SamplingGrid
{
  int Dimensions[3] = { 0, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing = 1.0;
};

/** Returns the parts that have cells: the data set itself, or the leaves of a composite one. */
std::vector<vtkDataSet*> CollectParts(vtkDataObject* data);

/**
 * Returns whether a part has polyhedra without faces. VTK before 9.4 does not read the faces that
 * later versions write, and its filters then read past the end of memory.
 */
bool LackFaces(const std::vector<vtkDataSet*>& parts);

/**
 * Returns the reason why the cells of the parts make no sense, so that VTK's filters would read
 * past the end of memory; empty if they do.
 */
std::string DetectFalseCells(const std::vector<vtkDataSet*>& parts);

double CountCells(const std::vector<vtkDataSet*>& parts);

/** Computes the box around all parts. It is not valid if they have no points. */
vtkBoundingBox ComputeBox(const std::vector<vtkDataSet*>& parts);

/**
 * Returns the edge of a cube that is as large as the average cell of the box, or a smaller edge
 * that gives 24 samples along the box's shortest edge. The result is 0 or not finite if the box has
 * no volume.
 */
double ComputeSampleSpacing(const vtkBoundingBox& box, double cells);

/**
 * Places the grid in the middle of the box. Where a spacing does not divide an edge, the grid ends
 * the same distance from both sides. Returns false if the box has no volume, or if an edge would
 * need more than a million samples.
 */
bool PlaceGrid(const vtkBoundingBox& box, double spacing, SamplingGrid& grid);

} // namespace VolumeHaptics

#endif
