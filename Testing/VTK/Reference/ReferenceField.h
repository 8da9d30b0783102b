// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * V and grad V directly by their formulas: double loops, exp(), taps clamped to the border.
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

  /// Returns V at a world position; outside of the volume, the value of the nearest border point.
  double Value(const Vec3& world) const;

  /// Returns grad V per world unit; 0 outside of the volume, and if a tap is not finite.
  Vec3 Gradient(const Vec3& world) const;

  /// Returns the magnitude up to which a gradient is rounding of the taps, and counts as none.
  double GradientFloor(const Vec3& world) const;

  /// Returns 1 inside, 0 outside, and between 1 and 0 within one kernel radius of the border.
  double BorderFade(const Vec3& world) const;

  /// Returns KernelRadius times the largest spacing.
  double KernelLength() const;

  /// Computes the weights of one axis of the Gaussian for a position with the fraction `f` above a
  /// voxel: smoothing[i] and derivative[i] belong to the tap at offset i - radius.
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
