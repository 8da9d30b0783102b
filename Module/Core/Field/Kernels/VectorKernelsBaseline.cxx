// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Kernels/VectorKernels.h"

namespace VolumeHaptics
{

VectorFunctions SelectBaselineVectorFunctions(ScalarType type, int components)
{
  return SelectVectorFunctions(type, components);
}

} // namespace VolumeHaptics
