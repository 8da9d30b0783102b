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
/// The point arrays of an image that modes can be about: vectors of 3 components, and tensors of 6
/// or 9. They go with the image, whatever becomes of its scalars.
class VolumeFields
{
public:
  /// An image that has no active scalars, but a field, gets the magnitude of its first field as
  /// scalars, so that there is something to be seen. Returns whether it did.
  bool Take(vtkImageData* image);
  /// The same, with the values of a point array, or the magnitude of a field, as scalars. Returns
  /// whether it is a field. Throws InputError, with the arrays that there are, if it is not there.
  bool TakeWith(const std::string& name, const std::string& path, vtkImageData* image);
  /// The first vectors, or those of a name if there is one; empty if there are none.
  static std::string FindFlow(vtkImageData* image, const std::string& name);
  /// Gives the fields to the image that was made of the other one, along the axes of the world.
  /// Vectors stay as they are: their components are along the axes of the world.
  void GiveTo(vtkImageData* aligned) const;

private:
  void Collect(vtkImageData* image);

  vtkSmartPointer<vtkImageData> Source; // the geometry
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
};
} // namespace Explore

#endif
