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
/// The point arrays of an image that modes can use: vectors of 3 components, and tensors of 6 or 9.
/// They stay with the image, whatever happens to its scalars.
class VolumeFields
{
public:
  /// Sets the scalars of an image without active scalars to the magnitude of its first array, if
  /// that is a field, so that something is visible. Returns whether it did.
  bool Use(vtkImageData* image);
  /// Makes a named point array the scalars of an image: its values, or the magnitude of a field.
  /// Returns whether the array is a field. Throws InputError, with the existing arrays, if it is
  /// missing.
  bool UseWith(const std::string& name, const std::string& path, vtkImageData* image);
  /// Returns the first vectors, or those with this name if it is given; empty if there are none.
  static std::string FindFlow(vtkImageData* image, const std::string& name);
  /// Copies the fields to `aligned`, the same image with its axes along those of the world
  /// (AlignToAxes). Vectors do not change, because their components are along the axes of the
  /// world.
  void GiveTo(vtkImageData* aligned) const;

private:
  void Collect(vtkImageData* image);

  vtkSmartPointer<vtkImageData> Source; // the image with the geometry
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
};
} // namespace Explore

#endif
