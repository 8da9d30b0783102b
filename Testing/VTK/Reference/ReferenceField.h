// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Computes V and grad V directly from their formulas: double loops, exp(), and taps clamped to the
 * border.
 */
#ifndef ReferenceField_h
#define ReferenceField_h

#include "Scene.h"

#include <vtkDataArray.h>

namespace reference
{
class ReferenceField
{
public:
  ReferenceField(vtkImageData* image, vtkDataArray* scalars, int component, Estimator estimator,
    int kernelRadius);

  /// Returns V at a world position. Outside the volume, this is the value of the nearest border
  /// point.
  double Value(const Vec3& world) const;

  /// Returns grad V per world unit; 0 outside of the volume, and if a tap is not finite.
  Vec3 Gradient(const Vec3& world) const;

  /// Returns the largest magnitude of a gradient that may result from rounding of the taps, and
  /// counts as 0.
  double GradientFloor(const Vec3& world) const;

  /// Returns 1 inside the volume and 0 outside. Within one kernel radius of the border, it falls
  /// from 1 to 0.
  double BorderFade(const Vec3& world) const;

  /// Returns KernelRadius times the largest spacing.
  double KernelLength() const;

  /// Computes the Gaussian's weights along one axis, for a position at the fraction `f` above a
  /// voxel. smoothing[i] and derivative[i] are for the tap at the offset i - radius.
  static void GaussianWeights(
    int radius, double f, std::vector<double>& smoothing, std::vector<double>& derivative);

private:
  Vec3 Index(const Vec3& world) const;
  Vec3 Clamped(Vec3 index) const;
  bool Inside(const Vec3& index) const;
  double Voxel(int i, int j, int k) const;
  double Trilinear(const Vec3& index) const;
  double Spline(const Vec3& index, int derivativeAxis) const;
  double GaussianDerivative(const Vec3& index, int axis) const;

  vtkDataArray* Scalars;
  int Component;
  Estimator Kind;
  int Radius;
  int Extent[6];
  double LargestSpacing;
  Vec3 Origin;
  Mat3 WorldFromIndexTransposedInverse;
};
} // namespace reference

#endif
