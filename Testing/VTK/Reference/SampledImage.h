// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Samples analytic fields to images of any geometry and scalar type.
 */
#ifndef SampledImage_h
#define SampledImage_h

#include "Vec3.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <functional>

namespace reference
{
struct Geometry
{
  int extent[6] = { 0, 0, 0, 0, 0, 0 };
  Vec3 spacing = { { 1.0, 1.0, 1.0 } };
  Vec3 origin;
  Mat3 direction;

  Vec3 World(const Vec3& index) const;
  Vec3 Centre() const;
};

using Field = std::function<double(const Vec3& world)>;

/// Returns the geometry of a cube with a side of 2 x `half` around the origin.
Geometry Cube(double half, double spacing);

/// Returns the geometry of the same volume at another place: world coordinates become rotation *
/// world + translation.
Geometry Moved(const Geometry& geometry, const Mat3& rotation, const Vec3& translation);

/// Makes an image of this geometry, without scalars.
vtkSmartPointer<vtkImageData> MakeImage(const Geometry& geometry);

/// Samples the field into component 0 of the active scalars. Integer types receive the nearest
/// value within their range.
vtkSmartPointer<vtkImageData> Sample(
  const Geometry& geometry, const Field& field, int scalarType = VTK_DOUBLE);

/// Fills one component of an array with a value for each voxel, clamped to the range of the array's
/// type.
void Fill(vtkDataArray* array, int component, const Geometry& geometry, const Field& field);
} // namespace reference

#endif
