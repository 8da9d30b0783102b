// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Kernels/FieldKernels.h"
#include "Core/Field/Kernels/LabelKernels.h"

namespace VolumeHaptics
{

FieldFunctions SelectAVX2Functions(const VolumeView& view, GradientEstimator estimator, int taps)
{
  return SelectFieldFunctions(view, estimator, taps);
}

LabelFunctions SelectAVX2LabelFunctions(ScalarType type)
{
  return SelectLabelFunctions(type);
}

} // namespace VolumeHaptics
