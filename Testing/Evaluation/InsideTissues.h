// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a hand feels that moves inside one tissue of a real scan: no grains, and no drops.
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

/** Values (HU) between which a tissue is, and where to look for it. */
struct TissueBand
{
  std::string Name;
  double Low = 0.0;
  double High = 0.0;
  std::set<int> Labels; ///< of the segmentation; not read without one
  double Length = 25.0; ///< mm, of a stroke
  double Margin = 3.0;  ///< mm around it, which are of the tissue, too
};

/** A scan, and its segmentation on the same voxels, if there is one. */
struct BandedScan
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkImageData> Labels;
};

/**
 * Straight strokes at 45 mm/s, with the surroundings of each in the band, after a Gaussian of 1 mm,
 * and in the labels. Fewer if there is no room for them.
 */
std::vector<Path> FindStrokesInside(const BandedScan& scan, const TissueBand& tissue, int count);

/** A line for each scan, tissue and preset for CT. */
Table MeasureInsideTissues(const Scans& scans, const Effort& effort);

} // namespace evaluation

#endif
