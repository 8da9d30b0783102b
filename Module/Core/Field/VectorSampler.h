// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Vectors and tensors of a volume at continuous positions, with their derivatives.
 *
 *   VectorSampler sampler(view);
 *   VectorSample sample;
 *   if (sampler.IsInside(index) && sampler.Sample(index, sample)) { ... sample.Value[0] ... }
 *
 * All components are cubic B-splines with the conventions of GradientEstimator::CubicBSpline, and
 * share one set of weights: three components with their gradients take twice as long as one.
 * Derivatives are those of the values, to rounding. There is no prefilter: a linear field is
 * reproduced exactly, and a quadratic one lies higher by a sixth of its second derivative (per
 * index step).
 *
 * Like FieldSampler, it gives the same bits on every processor.
 */
#ifndef VectorSampler_h
#define VectorSampler_h

#include "Core/Field/FieldSampler.h"
#include "Core/Field/VectorView.h"

namespace VolumeHaptics
{

/** The components at a position. Only as many are set as the view has. */
struct VectorSample
{
  double Value[VectorView::MostComponents] = {};
  Vector3 Gradient[VectorView::MostComponents]; ///< gradient of each component, per index step
};

/**
 * The samples as the kernels read them. Data of View.Volume points to the volume's first sample.
 */
struct VectorFieldView
{
  FieldView View;
  std::int64_t ComponentStride = 1;
};

/** Reads a sample. Returns false if it is not finite. */
using VectorFunction = bool (*)(
  const VectorFieldView&, double x, double y, double z, VectorSample&) noexcept;

/** The kernels for one scalar type and one number of components. */
struct VectorFunctions
{
  VectorFunction Value = nullptr;
  VectorFunction Gradient = nullptr;
};

/** Samples a volume of vectors or tensors. Stores only a view of the samples. */
class VectorSampler
{
public:
  VectorSampler() = default;
  /** Makes a sampler for 3, 6 or 9 components. For any other number, the sampler is not valid. */
  explicit VectorSampler(
    const VectorView& view, InstructionSet instructions = DetectInstructionSet());

  bool IsValid() const noexcept { return this->Functions.Value != nullptr; }

  ///@{
  /**
   * Read the components at a continuous index, which is clamped to the resident samples. Sample()
   * reads their gradients, too. Both return false if a sample with a weight is not finite; then the
   * result must not be used.
   */
  bool Sample(const Vector3& index, VectorSample& sample) const noexcept
  {
    return this->Functions.Gradient(this->View, index.X, index.Y, index.Z, sample);
  }
  bool SampleValue(const Vector3& index, VectorSample& sample) const noexcept
  {
    return this->Functions.Value(this->View, index.X, index.Y, index.Z, sample);
  }
  ///@}

  ///@{
  /**
   * Do the same as FieldSampler's functions. For an index that is NaN, IsInside() returns false and
   * DistanceToBorder() a negative number.
   */
  bool IsInside(const Vector3& index) const noexcept
  {
    return this->DistanceToBorder(index) >= 0.0;
  }
  double DistanceToBorder(const Vector3& index) const noexcept;
  ///@}

  int GetComponents() const noexcept { return this->Components; }

private:
  VectorFieldView View;
  double Border[3] = { 0.0, 0.0, 0.0 }; ///< largest index of the volume along each axis
  int Components = 0;
  VectorFunctions Functions;
};

} // namespace VolumeHaptics

#endif
