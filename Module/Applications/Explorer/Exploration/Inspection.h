// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Inspection_h
#define Explore_Inspection_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"
#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

class vtkVolumeHapticsFilter;

namespace Explore
{
/// Describes the contents of a file, and which of them can be felt. Lengths are in world units of
/// the volume, which are millimetres if its file says so.
class Inspection
{
public:
  /// Inspects a volume. `materials` is the name of the materials that were applied to `filter`. For
  /// a volume that is read around the hand, the values are those of its coarse level.
  Inspection(const Volume& volume, const Analysis& values, const std::string& materials,
    vtkVolumeHapticsFilter* filter);

  /// Returns plain sentences, one on each line.
  std::string Describe() const;
  /// Returns a JSON object for programs.
  std::string ToJson() const;
  /// Returns the facts for the list of keys: titles, and lines with a word, a tab and a value.
  std::string ListFacts() const;
  /// Returns notes for the window, one on each line, about everything that was guessed, left out,
  /// filled, resampled or rotated.
  std::string ListTold() const;

private:
  void MeasureNoise(vtkImageData* image);
  void ComputeSmallestStep(vtkImageData* image, vtkVolumeHapticsFilter* filter);
  std::string DescribeNoise() const;
  std::string DescribeFeature() const;

  std::string Name;
  std::string Format;
  std::string Type;
  std::string Axes;
  std::string Modality;
  std::string ModalityReason;
  std::string Padding; // values that were treated as outside; empty if there are none
  std::string Preset;
  std::string PresetReason;
  std::string Unit; // unit of the values after a space; empty if unknown
  std::vector<std::string> Notes;
  int Size[3] = { 0, 0, 0 };
  double Spacing[3] = { 1, 1, 1 };
  double Origin[3] = { 0, 0, 0 };
  double Direction[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  double MetersPerUnit = 0.001; // metres of hand motion for one unit
  double Range[2] = { 0, 1 };
  double Usual[2] = { 0, 1 }; // quantiles of the values at 0.5 and 99.5 %
  double Noise = 0.0;         // standard deviation of the noise
  // smallest and largest noise of parts of the volume; zeros: unknown
  double LocalNoise[2] = { 0, 0 };
  // smallest step of the values that is felt at a flat surface; 0: any step
  double SmallestStep = 0.0;
  // smallest step of the values that is felt at a sheet one voxel thick
  double SmallestSheetStep = 0.0;
};
} // namespace Explore

#endif
