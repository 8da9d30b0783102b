// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time steps of a volume that moves.
 */
#ifndef HapticFrames_h
#define HapticFrames_h

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
class vtkInformation;

namespace VolumeHaptics
{

/** The volume at a time step. */
struct HapticFrame
{
  double Time;                         ///< in the source's units
  vtkSmartPointer<vtkImageData> Image; ///< its geometry and field data
  vtkSmartPointer<vtkDataArray> Array; ///< null if there is none at this time
};

/** The time steps of an input, ascending; empty if it has less than two. */
std::vector<double> ReadTimeSteps(vtkInformation* input);

/** The point array of an image that is touched; null if there is none. */
using TouchedArrayOf = std::function<vtkDataArray*(vtkImageData*)>;

/**
 * Requests the time steps from the first one to that at or after `last` from the source of a
 * filter's input port 0, and copies the array that is touched: a source may write each step to the
 * same memory. The source stays at the first step. Empty if the source fails.
 */
std::vector<HapticFrame> CollectFrames(vtkAlgorithm* filter, const std::vector<double>& steps,
  double last, const TouchedArrayOf& getArray);

} // namespace VolumeHaptics

#endif
