// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Estimates the noise of a vtkDataArray (NoiseEstimate.h).
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
 * Adds the noise samples and the range of one piece of a volume. The array has a tuple for every
 * index of `extent`; these indices count as in `whole`.
 */
void CollectNoiseSamples(vtkDataArray* scalars, int component, const int extent[6],
  const int whole[6], NoiseSamples& samples);

/** Noise and range of a volume, estimated from its samples. */
struct FoundNoise
{
  double Noise = 0.0; ///< standard deviation of the noise (scalar units)
  /**
   * Range of all values (if HasRangeOfAll) or of the noise samples. If there are no values, the
   * first number is the larger one.
   */
  double Range[2] = { 1.0, 0.0 };
};

/**
 * Estimates the noise of a component. Results for the latest arrays are stored, for all filters of
 * a thread, until the image or the array is modified.
 */
FoundNoise EstimateImageNoise(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

/** Finds where the background ends. Stores the result as EstimateImageNoise() does. */
BackgroundLevel EstimateSolid(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

///@{
/**
 * Estimates the shift between stored values and Hounsfield units. The function with a view caches
 * the result, like EstimateImageNoise().
 */
StoredShift EstimateStoredShift(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);
VTKVOLUMEHAPTICS_EXPORT StoredShift EstimateStoredShift(
  vtkDataArray* scalars, const std::int64_t dimensions[3], int component);
///@}

} // namespace VolumeHaptics

#endif
