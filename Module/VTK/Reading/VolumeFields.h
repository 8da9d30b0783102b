// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeFields_h
#define Explore_VolumeFields_h

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// Point arrays of an image that modes can read: vectors of 3 components, and tensors of 6 or 9.
/// Preserves them when the image's scalars are replaced.
class VolumeFields
{
public:
  /// If an image has no active scalars and its first array is a field, uses the magnitude of this
  /// field as scalars, so that something is visible. Returns whether it did.
  bool Use(vtkImageData* image);
  /// Uses a named point array as the scalars of an image, or its magnitude if it is a field.
  /// Returns whether the array is a field. If the array is missing, throws InputError, which lists
  /// the existing arrays.
  bool UseWith(const std::string& name, const std::string& path, vtkImageData* image);
  /// Returns the name of the first vector array, or `name` if it is one; empty if there is none.
  static std::string FindFlow(vtkImageData* image, const std::string& name);
  /// Copies the fields to `aligned`, the same image after AlignToAxes(). Vectors stay unchanged,
  /// because their components refer to the axes of the world.
  void GiveTo(vtkImageData* aligned) const;

private:
  void Collect(vtkImageData* image);

  vtkSmartPointer<vtkImageData> Source; // image with the geometry of the fields
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
};

/// Returns whether the values of a volume look like labels: a few integers of at least 0, where
/// most voxels equal their neighbours and the steps between others are of any size. In a scan,
/// noise makes neighbours differ, and blurred edges make most steps small.
bool LooksLikeLabels(vtkImageData* image);

} // namespace Explore

#endif
