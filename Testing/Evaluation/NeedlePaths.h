// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Plans straight paths of a needle from the skin to the liver of a chest CT with labels, and
 * compares two ways to compute their force.
 *
 * The protocol is that of Mastmeyer, Fortmeier and Handels, "Evaluation of Direct Haptic 4D Volume
 * Rendering of Partially Segmented Data for Liver Puncture Simulation", Scientific Reports 7:671,
 * 2017: planned paths that avoid bone; force by partly segmented data against force by fully
 * segmented data. The paper has 31 222 paths in 10 patients, and a needle that stays in its track.
 * This file uses one patient, and this project's proxy.
 */
#ifndef Evaluation_NeedlePaths_h
#define Evaluation_NeedlePaths_h

#include "Comparison.h"

#include <map>
#include <optional>
#include <set>

class vtkHapticLabelTable;
class vtkHapticProperty;

namespace evaluation
{

/** The names of a scan's labels, as in the table of a segmentation. */
using LabelNames = std::map<int, std::string>;

/** The labels that matter for a path, by kind. */
struct NeedleLabels
{
  std::set<int> Liver;
  std::set<int> Bone;   ///< ribs, vertebrae and the rest of the skeleton
  std::set<int> Others; ///< lungs and heart, which a path must avoid
};

/** Sorts the labels by the names that TotalSegmentator uses. */
NeedleLabels SortLabels(const LabelNames& names);

/**
 * Returns paths from 5 mm outside of the skin to random points of the liver, at most 150 mm long,
 * with only air in front of the skin. Within 6 mm of a path there is no bone, by label or above 200
 * HU, and no path crosses the lungs or the heart. The same seed gives the same paths. Returns fewer
 * paths than wanted if 1000 attempts for a path fail.
 */
std::vector<Path> PlanNeedlePaths(vtkImageData* image, vtkImageData* labels,
  const NeedleLabels& sorted, std::size_t count, unsigned seed = 17);

/** Measures of the difference between two forces, tick by tick. */
struct ForceError
{
  double RootMeanSquare = 0.0; ///< N, for one path; for several paths, their mean
  double Largest = 0.0;        ///< N, maximum over all paths
  double Typical = 0.0;        ///< N, median over the paths of their largest difference
  double Affected = 0.0;       ///< %, ticks in which the forces differ by more than 0.01 N
};

/** Compares the forces of the same paths tick by tick. */
ForceError CompareForces(const std::vector<Trace>& some, const std::vector<Trace>& others);

/**
 * Returns the value (HU) at which the preset "CT contrast" has the material of a structure with
 * this TotalSegmentator name. Returns nothing for structures with contents of their own (stomach,
 * bowel).
 */
std::optional<double> TissueValueOf(const std::string& structure);

/** Returns a table with a property's materials at the values of the structures. */
vtkSmartPointer<vtkHapticLabelTable> MakeLabelTable(
  const LabelNames& names, vtkHapticProperty* feel);

/**
 * Runs the paper's needle protocol with "CT contrast": functions of the value alone (partly
 * segmented) against materials by label (fully segmented). Adds the mean and the largest errors
 * beside those of the paper, and a plot of the forces along one path.
 */
ForceError RunNeedleProtocol(vtkImageData* image, vtkImageData* labels, const LabelNames& names,
  std::size_t count, Comparison& found);

} // namespace evaluation

#endif
