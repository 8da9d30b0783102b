// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/FieldSampler.h"

#include "Core/Field/WholeData.h"
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

FieldSampler::FieldSampler(
  const VolumeView& view, const GradientKernel& kernel, InstructionSet instructions)
  : View{ view, kernel.GetView() }
  , Given(view)
{
  this->View.Volume.Data = WholeData(view);
  this->View.Number = MakeUniqueNumber();
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
