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
/// They are kept for the image, whatever happens to its scalars.
class VolumeFields
{
public:
  /// If an image has no active scalars and its first array is a field, makes the magnitude of this
  /// field the scalars, so that something is visible. Returns whether it did.
  bool Use(vtkImageData* image);
  /// Makes a named point array the scalars of an image: its values, or the magnitude if it is a
  /// field. Returns whether the array is a field. If it is missing, throws InputError, which lists
  /// the existing arrays.
  bool UseWith(const std::string& name, const std::string& path, vtkImageData* image);
  /// Returns the name of the first vectors, or of those with the given name; empty if there are
  /// none.
  static std::string FindFlow(vtkImageData* image, const std::string& name);
  /// Copies the fields to `aligned`, the same image with its axes along those of the world
  /// (AlignToAxes). Vectors do not change, because their components refer to the axes of the world.
  void GiveTo(vtkImageData* aligned) const;

private:
  void Collect(vtkImageData* image);

  vtkSmartPointer<vtkImageData> Source; // image that has the geometry
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
};

/// Returns whether the values of a volume look like label numbers: they are few whole numbers of 0
/// or more, most voxels equal their neighbours, and the other steps are of any size. In a scan,
/// noise makes neighbours differ, and blurred edges make most steps small.
bool LooksLikeLabels(vtkImageData* image);

} // namespace Explore

#endif
