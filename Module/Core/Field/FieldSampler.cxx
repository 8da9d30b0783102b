// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/FieldSampler.h"

#include "Core/Field/WholeData.h"
#include "Core/Math/KernelInline.h"
#include "Core/Math/UniqueNumber.h"

namespace VolumeHaptics
{

FieldFunctions SelectBaselineFunctions(const VolumeView&, GradientEstimator, int taps);
#ifdef VOLUME_HAPTICS_HAS_AVX2
FieldFunctions SelectAVX2Functions(const VolumeView&, GradientEstimator, int taps);
#endif

InstructionSet DetectInstructionSet()
{
#ifdef VOLUME_HAPTICS_HAS_AVX2
  static const bool hasAVX2 = __builtin_cpu_supports("avx2");
  return hasAVX2 ? InstructionSet::AVX2 : InstructionSet::Baseline;
#else
  return InstructionSet::Baseline;
#endif
}

namespace
{

FieldFunctions SelectFunctions(
  const VolumeView& view, const GradientKernel& kernel, InstructionSet instructions)
{
#ifdef VOLUME_HAPTICS_HAS_AVX2
  if (instructions == InstructionSet::AVX2)
  {
    return SelectAVX2Functions(view, kernel.Estimator, kernel.Taps);
  }
#else
  static_cast<void>(instructions);
#endif
  return SelectBaselineFunctions(view, kernel.Estimator, kernel.Taps);
}

/** Computes the gradient from a copy of a box with at most N samples along each axis. */
template <int N>
VOLUME_HAPTICS_OUTLINE FieldSample GradientOfCopy(const FieldView& view, const CarvedView& carved,
  const CarvedBox& box, GradientFunction gradient, const Vector3& index) noexcept
{
  double samples[N * N * N];
  FieldView copy = view;
  CopyCarved(view.Volume, carved, box, samples, copy.Volume);
  return gradient(copy, index.X, index.Y, index.Z);
}

} // namespace

FieldSampler::FieldSampler(
  const VolumeView& view, const GradientKernel& kernel, InstructionSet instructions)
  : FieldSampler(view, kernel, CarvedView{}, instructions)
{
}

FieldSampler::FieldSampler(const VolumeView& view, const GradientKernel& kernel,
  const CarvedView& carved, InstructionSet instructions)
  : View{ view, kernel.GetView() }
  , Given(view)
  , Carved(carved)
  , Functions(SelectFunctions(view, kernel, instructions))
  , ValueReach(kernel.Estimator == GradientEstimator::CubicBSpline ? 1 : 0)
{
  this->View.Volume.Data = WholeData(view);
  this->View.Number = MakeUniqueNumber();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->View.First[axis] = static_cast<double>(view.First[axis]);
    this->View.Last[axis] = static_cast<double>(view.Last(axis));
    this->Border[axis] = static_cast<double>(view.Border(axis));
  }
  VolumeView copies = view;
  copies.Type = ScalarType::Float64;
  this->OfCopies = SelectFunctions(copies, kernel, instructions);
}

double FieldSampler::CarvedValue(const Vector3& index) const noexcept
{
  const double position[3] = { index.X, index.Y, index.Z };
  const CarvedBox box = ComputeBox(this->Given, position, this->ValueReach, this->ValueReach);
  double samples[4 * 4 * 4];
  FieldView copy = this->View;
  const bool isCarved = CopyCarved(this->View.Volume, this->Carved, box, samples, copy.Volume);
  return isCarved ? this->OfCopies.Value(copy, index.X, index.Y, index.Z)
                  : this->Functions.Value(this->View, index.X, index.Y, index.Z);
}

bool FieldSampler::ReadCarved(const Vector3& index, FieldSample& sample) const noexcept
{
  const double position[3] = { index.X, index.Y, index.Z };
  const int reach = this->View.Kernel.Radius;
  // Read one sample more, because rounding may move the position into the next cell.
  const CarvedBox box = ComputeBox(this->Given, position, reach, reach + 1);
  if (!this->Carved.Bricks->HasBricks(box.Low, box.High))
  {
    return false;
  }
  // Only wide kernels make a large copy, because it uses much of the stack.
  constexpr int fewest = 9;
  const auto read = 2 * reach + 3 <= fewest ? GradientOfCopy<fewest>
                                            : GradientOfCopy<GradientKernel::MaximumTaps + 1>;
  sample = read(this->View, this->Carved, box, this->OfCopies.Gradient, index);
  return true;
}

} // namespace VolumeHaptics
