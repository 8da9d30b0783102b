// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/FieldKernels.h"

namespace VolumeHaptics
{

FieldFunctions SelectAVX2Functions(const VolumeView& view, GradientEstimator estimator, int taps)
{
  return SelectFieldFunctions(view, estimator, taps);
}

} // namespace VolumeHaptics
