// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeAnalysis_h
#define Explore_VolumeAnalysis_h

#include "vtkImageData.h"

#include <string>

namespace Explore
{
enum class VolumeKind
{
  CT,       // Hounsfield units
  EightBit, // 0..255, most often MRI
  Field,    // values of a simulation, without tissues
  Labels,   // label numbers
  Other
};

/// Properties of the values, for the planner, the materials and the rendering.
struct Analysis
{
  VolumeKind Kind = VolumeKind::Other;
  double Range[2] = { 0, 1 };
  double Low = 0; // 0.5 % and 99.5 % quantiles, which exclude outliers
  double High = 1;
  double OuterThreshold = 0;      // value between outside and body
  double DeepThreshold = 0;       // value between the body and the denser structure inside it
  bool IsDark = false;            // whether the touched body has values below the outer threshold
  double Centre[3] = { 0, 0, 0 }; // centre of the voxels above the outer threshold, world units
  double BodyBounds[6] = { 0, 1, 0, 1, 0, 1 }; // bounds of these voxels, world units
  double MetersPerWorldUnit = 0.001;
  double Voxel = 1.0;     // shortest edge of a voxel, world units
  std::string KindReason; // why this kind was chosen, for the summary
};

/// Analyses everything except the position of the body. Samples large volumes sparsely. The values
/// of a field or of labels are not interpreted, whatever their range. If mayBeHounsfield is false,
/// the volume is not treated as a CT.
Analysis AnalyseVolume(
  vtkImageData* image, bool isField = false, bool areLabels = false, bool mayBeHounsfield = true);

/// Adds the position of the voxels above the outer threshold: Centre and BodyBounds.
void MeasureBody(Analysis& analysis, vtkImageData* image);
} // namespace Explore

#endif
