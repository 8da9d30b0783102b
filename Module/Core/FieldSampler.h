// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Values and gradients of a volume at continuous positions.
 *
 * The kernels are compiled once per instruction set, each in a translation unit of its own, and
 * chosen at run time: code around them (and VTK) stays baseline. All variants carry out the same
 * operations in the same order, without fused multiply-add, so that a trace does not depend on the
 * processor.
 */
#ifndef FieldSampler_h
#define FieldSampler_h

#include "GradientKernel.h"
#include "Vector3.h"
#include "VolumeView.h"

namespace VolumeHaptics
{

struct FieldSample
{
  /** The estimator's own (smoothed) value: a measure of scale for the gradient's rounding error. */
  double Value = 0.0;
  /** Per step of the index, along the index axes. */
  Vector3 Gradient;
};

using ValueFunction = double (*)(
  const VolumeView&, const KernelView&, const Vector3& index) noexcept;
using GradientFunction = FieldSample (*)(
  const VolumeView&, const KernelView&, const Vector3& index) noexcept;

/** The kernels for one scalar type, one memory layout and one estimator. */
struct FieldFunctions
{
  ValueFunction Value = nullptr;
  GradientFunction Gradient = nullptr;
};

enum class InstructionSet : std::uint8_t
{
  Baseline,
  AVX2
};

/** The best instruction set that was compiled in and that this processor has. */
InstructionSet DetectInstructionSet();

/** A volume and an estimator, ready to be sampled. Borrows the samples and the kernel's table. */
class FieldSampler
{
public:
  FieldSampler() = default;
  FieldSampler(const VolumeView& view, const GradientKernel& kernel,
    InstructionSet instructions = DetectInstructionSet());

  /** V at a continuous index, clamped to the border; BorderValue where a sample is not finite. */
  double Value(const Vector3& index) const noexcept
  {
    const double value = this->Functions.Value(this->View, this->Kernel, index);
    return std::isfinite(value) ? value : this->View.BorderValue;
  }

  /** Value and gradient at a continuous index, which must lie inside; may be NaN. */
  FieldSample Gradient(const Vector3& index) const noexcept
  {
    return this->Functions.Gradient(this->View, this->Kernel, index);
  }

  /** Whether a continuous index lies within the samples' bounding box. */
  bool IsInside(const Vector3& index) const noexcept
  {
    return index.X >= 0.0 && index.Y >= 0.0 && index.Z >= 0.0 &&
      index.X <= static_cast<double>(this->View.Dimensions[0] - 1) &&
      index.Y <= static_cast<double>(this->View.Dimensions[1] - 1) &&
      index.Z <= static_cast<double>(this->View.Dimensions[2] - 1);
  }

  const VolumeView& GetView() const noexcept { return this->View; }

private:
  VolumeView View;
  KernelView Kernel;
  FieldFunctions Functions;
};

} // namespace VolumeHaptics

#endif
