// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the parts of a data set that is not an image, and places the regular grid on which it is
 * sampled.
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

/** A regular grid. Sample i along an axis, counted from 0, is at Origin + i * Spacing. */
struct SamplingGrid
{
  int Dimensions[3] = { 0, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing = 1.0;
};

/**
 * Returns the parts that have cells: the data set itself, or the leaves of a composite data set.
 */
std::vector<vtkDataSet*> CollectParts(vtkDataObject* data);

/**
 * Returns whether a part has polyhedra without faces. VTK before 9.4 does not read the faces that
 * later versions write; its filters then read past the end of their memory.
 */
bool LackFaces(const std::vector<vtkDataSet*>& parts);

/**
 * Returns the fault in the parts' cells that would make VTK's filters read past the end of their
 * memory; empty if the cells are valid.
 */
std::string DetectFalseCells(const std::vector<vtkDataSet*>& parts);

double CountCells(const std::vector<vtkDataSet*>& parts);

/** Computes the bounding box of all parts; invalid if they have no points. */
vtkBoundingBox ComputeBox(const std::vector<vtkDataSet*>& parts);

/**
 * Returns the edge length of a cube with the average cell's volume, or less, so that the box's
 * shortest edge has 24 samples. The result is 0 or not finite if the box has no volume.
 */
double ComputeSampleSpacing(const vtkBoundingBox& box, double cells);

/**
 * Places the grid centrally in the box: where the spacing does not divide an edge, the grid has the
 * same distance from both ends. Returns false if the box has no volume, or if an edge would need
 * more than a million samples.
 */
bool PlaceGrid(const vtkBoundingBox& box, double spacing, SamplingGrid& grid);

} // namespace VolumeHaptics

#endif
