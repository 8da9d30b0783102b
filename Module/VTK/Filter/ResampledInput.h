// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Input data of a vtkVolumeHapticsFilter that are not an image.
 */
#ifndef ResampledInput_h
#define ResampledInput_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkHapticRegionSource;

namespace VolumeHaptics
{

/** Keeps the resampled regions of a data set until the data or the arrays change. */
class ResampledInput
{
public:
  /**
   * Returns the source that resamples these arrays of the data. Returns null if the data are an
   * image or have no cells.
   */
  vtkHapticRegionSource* Find(vtkDataObject* data, std::vector<std::string>&& arrays);
  /** Explains why the data of the last Find() can't be touched, with the cure. */
  std::string DescribeFault(vtkDataObject* data) const;
  /**
   * Returns the warning that only the first of these time steps is felt, with the cure. Returns an
   * empty text if the warning has been returned for these time steps before.
   */
  std::string DescribeStillSteps(vtkDataObject* data, const std::vector<double>& steps);

private:
  vtkSmartPointer<vtkHapticRegionSource> Source; ///< null if the data can't be resampled
  const void* Of = nullptr;
  vtkMTimeType Time = 0;
  std::vector<std::string> Arrays;
  std::string Error;
  std::vector<double> ToldSteps;
};

} // namespace VolumeHaptics

#endif
