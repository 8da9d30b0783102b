// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples the vectors or tensors of a volume and their derivatives at continuous positions.
 *
 *   VectorSampler sampler(view);
 *   VectorSample sample;
 *   if (sampler.IsInside(index) && sampler.Sample(index, sample)) { ... sample.Value[0] ... }
 *
 * All components are cubic B-splines with the conventions of GradientEstimator::CubicBSpline. They
 * share one set of weights, so that three components with their gradients take only twice as long
 * as one. Derivatives are exact derivatives of the values, to rounding. There is no prefilter: a
 * linear field is reproduced exactly, and a quadratic one is raised by a sixth of its second
 * derivative (per index step).
 *
 * Like those of FieldSampler, results are equal on every processor, to the bit.
 */
#ifndef VectorSampler_h
#define VectorSampler_h

#include "Core/Field/FieldSampler.h"
#include "Core/Field/VectorView.h"

namespace VolumeHaptics
{

/** The components at a position. Only the view's components are set. */
struct VectorSample
{
  double Value[VectorView::MostComponents] = {};
  Vector3 Gradient[VectorView::MostComponents]; ///< gradient of each component, per index step
};

/**
 * The samples in the form that the kernels read. View.Volume.Data points to the whole volume's
 * first sample.
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

/** Samples a volume of vectors or tensors. Does not own the samples. */
class VectorSampler
{
public:
  VectorSampler() = default;
  /** A number of components other than 3, 6 or 9 makes a sampler that is not valid. */
  explicit VectorSampler(
    const VectorView& view, InstructionSet instructions = DetectInstructionSet());

  bool IsValid() const noexcept { return this->Functions.Value != nullptr; }

  ///@{
  /**
   * Read the components at a continuous index, which is clamped to the resident samples. Sample()
   * reads their gradients, too. Both return false if a sample with a weight is not finite; the
   * result must then be ignored.
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
   * The same as FieldSampler's functions. If the index is NaN, IsInside() returns false, and
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
