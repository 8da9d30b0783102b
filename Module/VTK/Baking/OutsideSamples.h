// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples that mean "outside": NaN around what was measured, as masked maps of SPM and FSL have it,
 * and numbers that stand for a missing value.
 */
#ifndef OutsideSamples_h
#define OutsideSamples_h

#include "vtkVolumeHapticsModule.h" // for export macro

#include "vtkSmartPointer.h"

#include <optional>
#include <string>

class vtkDataArray;
class vtkImageData;

namespace VolumeHaptics
{

/** A component whose samples outside have a value. */
struct FilledSamples
{
  vtkSmartPointer<vtkDataArray> Array; ///< a copy of one component; null if nothing is outside
  std::string Missing;                 ///< tells of a number that stands for a missing value
};

/**
 * Gives all samples outside one value: `value`, or by default the least finite one that is inside.
 * Outside are
 *
 * - NaN in one piece with NaN at a face of the image. What lies deeper is a hole in the data;
 * - a number that a corner has, if it is one of those that programs write for missing values
 *   (-9999, -99999, the least number of 16 or 32 bits and the one above it, and beyond 1e19), and
 *   lies apart from all others by a tenth of their range.
 *
 * The image may be of any type and memory layout that a volume may be of.
 */
VTKVOLUMEHAPTICS_EXPORT FilledSamples FillOutside(
  vtkImageData* image, vtkDataArray* scalars, int component, std::optional<double> value = {});

} // namespace VolumeHaptics

#endif
