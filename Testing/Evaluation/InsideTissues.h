// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures strokes of a hand inside one tissue of a real scan. The hand should feel no grains
 * and no drops.
 */
#ifndef Evaluation_InsideTissues_h
#define Evaluation_InsideTissues_h

#include "Figure.h"
#include "Scans.h"
#include "Table.h"

#include <set>
#include <string>
#include <vector>

namespace evaluation
{

/** The range of values (HU) of a tissue, and where to search for it. */
struct TissueBand
{
  std::string Name;
  double Low = 0.0;
  double High = 0.0;
  std::set<int> Labels; ///< labels in the segmentation; unused without a segmentation
  double Length = 25.0; ///< mm, of a stroke
  double Margin = 3.0;  ///< mm around a stroke that must also belong to the tissue
};

/** A scan, with a segmentation of the same voxels if available. */
struct BandedScan
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkImageData> Labels;
};

/**
 * Returns straight strokes at 45 mm/s. Within the margin of each, all values smoothed with a
 * Gaussian of 1 mm are in the tissue's range, and the labels match. Returns fewer strokes if there
 * is no room.
 */
std::vector<Path> FindStrokesInside(const BandedScan& scan, const TissueBand& tissue, int count);

/** Returns a table with a line for each scan, tissue and CT preset. */
Table MeasureInsideTissues(const Scans& scans, const Effort& effort);

} // namespace evaluation

#endif
