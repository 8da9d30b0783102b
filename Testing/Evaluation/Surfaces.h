// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surfaces of scans that are stroked, with the presets that are for them.
 */
#ifndef Evaluation_Surfaces_h
#define Evaluation_Surfaces_h

#include "Arcs.h"

#include "vtkSmartPointer.h"

#include <string>

namespace evaluation
{

/** The ramp of FeltSurface for the preset "Labels", whose functions go over within half a label. */
constexpr double LabelRamp = 0.25;

/** A surface of a scan and the strokes over it. */
struct FeltSurface
{
  std::string Scan;
  std::string Name;
  std::string Preset;
  vtkSmartPointer<vtkImageData> Image;
  double Level = 0.0; ///< value of the surface
  std::vector<Arc> Arcs;
  /// scalar units, to which ramps between materials are widened to see what steep ones do
  double WideRamp = 60.0;
  bool IsRequired = false; ///< to be smooth
  /// % of the mean between 30 and 500 Hz; 0 stands for what a mesh of smoothed data has
  double RoughestFraction = 0.0;
};

/** Scalp (-300 HU) and skull (300 HU) of a head CT. */
std::vector<FeltSurface> FindHeadSurfaces(vtkImageData* volume, const Effort& effort);

/**
 * The skin of the front (-300 HU) and, from the lung, the dome of the liver (-400 HU) of a chest
 * CT in DICOM's axes. The liver has a value in the label image; without labels it is left out.
 */
std::vector<FeltSurface> FindChestSurfaces(
  vtkImageData* volume, vtkImageData* labels, int liver, const Effort& effort);

/** Scalp and cortex of a T1-weighted MRI of a head, of 0 to 255 grey levels. */
std::vector<FeltSurface> FindMriSurfaces(vtkImageData* volume, const Effort& effort);

/**
 * The dome of the liver, stroked from the lung, in a label image that is touched itself: in one
 * that has the liver alone, and among all labels. None without the liver's label.
 */
std::vector<FeltSurface> FindLabelSurfaces(vtkImageData* labels, int liver, const Effort& effort);

} // namespace evaluation

#endif
