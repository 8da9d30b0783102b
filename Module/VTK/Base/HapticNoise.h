// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The noise of a vtkDataArray (NoiseEstimate.h).
 */
#ifndef HapticNoise_h
#define HapticNoise_h

#include "Core/Field/Estimates/BackgroundLevel.h"
#include "Core/Field/Estimates/NoiseEstimate.h"
#include "Core/Field/Estimates/StoredShift.h"
#include "Core/Field/VolumeView.h"

#include "vtkVolumeHapticsModule.h" // for export macro

class vtkDataArray;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * Adds the noise samples of one piece of a volume, and the range. The array has a tuple for every
 * index of `extent`; the indices count as those of `whole`.
 */
void CollectNoiseSamples(vtkDataArray* scalars, int component, const int extent[6],
  const int whole[6], NoiseSamples& samples);

/** Noise and range of a volume, estimated from its samples. */
struct FoundNoise
{
  double Noise = 0.0; ///< its standard deviation (scalar units)
  /** Of all values, or of the noise samples (HasRangeOfAll). The first is larger without any. */
  double Range[2] = { 1.0, 0.0 };
};

/**
 * The noise of a component. Those of the latest arrays are remembered, for all filters of a thread,
 * until the image or the array is modified.
 */
FoundNoise FindNoise(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

/** Where its background ends, remembered as the noise is. */
BackgroundLevel FindSolid(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

///@{
/** How its Hounsfield units are stored; with a view, remembered as the noise is. */
StoredShift FindStoredShift(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);
VTKVOLUMEHAPTICS_EXPORT StoredShift FindStoredShift(
  vtkDataArray* scalars, const std::int64_t dimensions[3], int component);
///@}

} // namespace VolumeHaptics

#endif
