// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/FieldSampler.h"

namespace VolumeHaptics
{
namespace
{

std::int64_t SizeOf(ScalarType type)
{
  constexpr std::int64_t sizes[] = { 1, 1, 2, 2, 4, 4, 8, 8, 4, 8 };
  return sizes[static_cast<int>(type)];
}

/**
 * The address of the whole volume's first sample. Computed as a number, since there may be no
 * memory at it.
 */
const void* WholeData(const VolumeView& view)
{
  std::int64_t elements = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    elements += view.First[axis] * view.Stride[axis];
  }
  const auto bytes = static_cast<std::uintptr_t>(elements * SizeOf(view.Type));
  return reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(view.Data) - bytes);
}

} // namespace

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

FieldSampler::FieldSampler(
  const VolumeView& view, const GradientKernel& kernel, InstructionSet instructions)
  : View{ view, kernel.GetView() }
  , Given(view)
{
  this->View.Volume.Data = WholeData(view);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->View.First[axis] = static_cast<double>(view.First[axis]);
    this->View.Last[axis] = static_cast<double>(view.Last(axis));
    this->Border[axis] = static_cast<double>(view.Border(axis));
  }
#ifdef VOLUME_HAPTICS_HAS_AVX2
  if (instructions == InstructionSet::AVX2)
  {
    this->Functions = SelectAVX2Functions(view, kernel.Estimator, kernel.Taps);
    return;
  }
#else
  static_cast<void>(instructions);
#endif
  this->Functions = SelectBaselineFunctions(view, kernel.Estimator, kernel.Taps);
}

} // namespace VolumeHaptics
