// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Straight paths of a needle from the skin to the liver of a chest CT with labels, and how much
 * two ways to feel them differ.
 *
 * The protocol is that of Mastmeyer, Fortmeier and Handels, "Evaluation of Direct Haptic 4D Volume
 * Rendering of Partially Segmented Data for Liver Puncture Simulation", Scientific Reports 7:671,
 * 2017: planned paths that avoid bone; force by partly segmented data against force by fully
 * segmented data. They had 31 222 paths in 10 patients, and a needle that stays in its track; here
 * it is the proxy of this project in one patient.
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

/** The labels of a scan by name, as in the table of a segmentation. */
using LabelNames = std::map<int, std::string>;

/** The values of the label image that matter for a path. */
struct NeedleLabels
{
  std::set<int> Liver;
  std::set<int> Bone;   ///< ribs, vertebrae and the rest of the skeleton
  std::set<int> Others; ///< lungs and heart, which a path avoids, too
};

/** By names as TotalSegmentator gives them. */
NeedleLabels SortLabels(const LabelNames& names);

/**
 * Paths from 5 mm outside of the skin to random points of the liver, at most 150 mm long, with
 * nothing but air before the skin. Nothing within 6 mm of a path is bone by its label or above
 * 200 HU, and no lung or heart lies in it. The same ones for the same seed; fewer than wanted after
 * 1000 attempts for each.
 */
std::vector<Path> PlanNeedlePaths(vtkImageData* image, vtkImageData* labels,
  const NeedleLabels& sorted, std::size_t count, unsigned seed = 17);

/** How much two forces a tick differ. */
struct ForceError
{
  double RootMeanSquare = 0.0; ///< N, of a path; then the mean of all paths
  double Largest = 0.0;        ///< N
  double Typical = 0.0;        ///< N, the largest of a path, median of all paths
  double Affected = 0.0;       ///< %, of ticks at which they differ by more than 0.01 N
};

/** Of traces of the same paths, tick by tick. */
ForceError CompareForces(const std::vector<Trace>& some, const std::vector<Trace>& others);

/**
 * The value (HU) at which the preset "CT contrast" has the material of a structure, by its name as
 * TotalSegmentator gives it; none for what has contents of its own (stomach, bowel).
 */
std::optional<double> TissueValueOf(const std::string& structure);

/** The materials that the functions of a property have at the values of the structures. */
vtkSmartPointer<vtkHapticLabelTable> MakeLabelTable(
  const LabelNames& names, vtkHapticProperty* feel);

/**
 * The protocol with "CT contrast": by functions of the value alone (partly segmented) against
 * materials by label (fully segmented). Adds the mean and worst errors beside those of the paper,
 * and a plot of the forces along a path.
 */
ForceError RunNeedleProtocol(vtkImageData* image, vtkImageData* labels, const LabelNames& names,
  std::size_t count, Comparison& found);

} // namespace evaluation

#endif
