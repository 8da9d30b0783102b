// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ValueProbe_h
#define Explore_ValueProbe_h

#include "vtkDataArray.h"
#include "vtkImageData.h"

namespace Explore
{
/// Reads trilinearly interpolated values of an image at world positions. Respects the direction
/// matrix.
class ValueProbe
{
public:
  /// @param outside value returned outside the volume, and used in place of voxels that are not
  ///   finite
  ValueProbe(vtkImageData* image, double outside);

  double Value(const double position[3], bool& inside) const;

private:
  vtkImageData* Image;
  vtkDataArray* Scalars;
  double Outside;
};
} // namespace Explore

#endif
