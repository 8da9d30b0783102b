// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How smooth the surfaces of real scans feel, and what makes them rough.
 */
#ifndef Evaluation_Feel_h
#define Evaluation_Feel_h

#include "Arcs.h"
#include "Comparison.h"

#include "vtkSmartPointer.h"

namespace evaluation
{

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
  double RoughestShare = 0.0;
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

struct Feel
{
  Comparison Found;
  Figures Required; ///< of surfaces that are required to be smooth
};

/**
 * Roughness of the force on each surface, for all methods; for PRECISE also with one cause of
 * roughness taken away at a time. Then what happened to the material when the force dropped. A
 * plot for each surface.
 */
Feel MeasureFeel(const std::vector<FeltSurface>& surfaces);

/** The function, averaged over a width of its argument: no ramp is steeper. */
void Widen(vtkPiecewiseFunction* function, double width);

/** Drops of the force along strokes, and what changed within the 5 ms of each. */
struct DropCauses
{
  int Drops = 0;
  int Strength = 0;    ///< what the surface holds changed more than twofold
  int Stiffness = 0;   ///< by more than a fifth
  int Snap = 0;        ///< the proxy moved by more than 0.3 mm in a tick
  int Unexplained = 0; ///< none of these
};

/** Adds those of a trace, from a tick on. */
void AddDropCauses(const Trace& trace, std::size_t first, DropCauses& causes);

} // namespace evaluation

#endif
