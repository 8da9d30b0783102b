// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/LabelSampler.h"

namespace VolumeHaptics
{

LabelFunctions SelectBaselineLabelFunctions(ScalarType);
#ifdef VOLUME_HAPTICS_HAS_AVX2
LabelFunctions SelectAVX2LabelFunctions(ScalarType);
#endif

LabelSampler::LabelSampler(
  const VolumeView& view, const GradientKernel& kernel, InstructionSet instructions)
  : View{ view, kernel.GetView() }
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->View.Last[axis] = static_cast<double>(view.Dimensions[axis] - 1);
  }
#ifdef VOLUME_HAPTICS_HAS_AVX2
  if (instructions == InstructionSet::AVX2)
  {
    this->Functions = SelectAVX2LabelFunctions(view.Type);
    return;
  }
#else
  static_cast<void>(instructions);
#endif
  this->Functions = SelectBaselineLabelFunctions(view.Type);
}

} // namespace VolumeHaptics
