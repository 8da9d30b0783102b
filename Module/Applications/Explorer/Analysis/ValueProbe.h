// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ValueProbe_h
#define Explore_ValueProbe_h

#include "vtkDataArray.h"
#include "vtkImageData.h"

namespace Explore
{
/// Reads trilinear values of an image at world positions. Uses the direction matrix.
class ValueProbe
{
public:
  /// `outside` is returned for positions outside the volume, and replaces voxels that are not
  /// finite.
  ValueProbe(vtkImageData* image, double outside);

  double Value(const double position[3], bool& inside) const;

private:
  vtkImageData* Image;
  vtkDataArray* Scalars;
  double Outside;
};
} // namespace Explore

#endif
