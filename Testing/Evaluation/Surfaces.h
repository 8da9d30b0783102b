// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surfaces of scans for strokes, with their presets.
 */
#ifndef Evaluation_Surfaces_h
#define Evaluation_Surfaces_h

#include "Arcs.h"

#include "vtkSmartPointer.h"

#include <string>

namespace evaluation
{

/** The WideRamp for the preset "Labels", whose functions change within half a label. */
constexpr double LabelRamp = 0.25;

/** A surface of a scan, and the strokes over it. */
struct FeltSurface
{
  std::string Scan;
  std::string Name;
  std::string Preset;
  vtkSmartPointer<vtkImageData> Image;
  double Level = 0.0; ///< value of the surface
  std::vector<Arc> Arcs;
  /// width (scalar units) to which ramps between materials are widened, to measure the effect of
  /// steep ramps
  double WideRamp = 60.0;
  bool IsRequired = false; ///< must be smooth
  /// largest allowed roughness between 30 and 500 Hz, % of the mean; 0: the roughness of a mesh of
  /// smoothed data
  double RoughestFraction = 0.0;
};

/** Returns scalp (-300 HU) and skull (300 HU) of a head CT. */
std::vector<FeltSurface> FindHeadSurfaces(vtkImageData* volume, const Effort& effort);

/**
 * Returns surfaces of a chest CT with DICOM's axes: the skin of the front (-300 HU), and the dome
 * of the liver (-400 HU), stroked from the lung. `liver` is the liver's value in the label image;
 * without labels, the liver is left out.
 */
std::vector<FeltSurface> FindChestSurfaces(
  vtkImageData* volume, vtkImageData* labels, int liver, const Effort& effort);

/** Returns scalp and cortex of a T1-weighted MRI of a head with grey levels from 0 to 255. */
std::vector<FeltSurface> FindMriSurfaces(vtkImageData* volume, const Effort& effort);

/**
 * Returns the dome of the liver, stroked from the lung, on the label image itself: once with the
 * liver alone, and once among all labels. Returns nothing without the liver's label.
 */
std::vector<FeltSurface> FindLabelSurfaces(vtkImageData* labels, int liver, const Effort& effort);

} // namespace evaluation

#endif
