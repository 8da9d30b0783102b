// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Estimates the noise and the value range of a vtkDataArray (NoiseEstimate.h).
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
 * Adds the samples of one piece of a volume to the noise and range estimates. The array has a tuple
 * for every index of `extent`, whose indices are those of the whole volume, as in `whole`.
 */
void CollectNoiseSamples(vtkDataArray* scalars, int component, const int extent[6],
  const int whole[6], NoiseSamples& samples);

/** Noise and value range of a volume, estimated from its samples. */
struct FoundNoise
{
  double Noise = 0.0; ///< standard deviation of the noise (scalar units)
  /**
   * Range of all values if HasRangeOfAll, otherwise of the noise samples. Without values, the
   * minimum is above the maximum.
   */
  double Range[2] = { 1.0, 0.0 };
};

/**
 * Estimates the noise of a component. Caches the results for the latest arrays, for all filters of
 * a thread, until the image or the array is modified.
 */
FoundNoise EstimateImageNoise(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

/**
 * Finds the value where the background ends and solid matter begins. Caches it as
 * EstimateImageNoise() does.
 */
BackgroundLevel EstimateSolid(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

///@{
/**
 * Estimates the shift between stored values and Hounsfield units. The overload with a view caches
 * the result as EstimateImageNoise() does.
 */
StoredShift EstimateStoredShift(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);
VTKVOLUMEHAPTICS_EXPORT StoredShift EstimateStoredShift(
  vtkDataArray* scalars, const std::int64_t dimensions[3], int component);
///@}

} // namespace VolumeHaptics

#endif
