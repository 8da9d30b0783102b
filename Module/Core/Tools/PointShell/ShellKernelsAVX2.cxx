// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/ShellKernels.h"

namespace VolumeHaptics
{

ShellFunctions SelectAVX2ShellFunctions(ScalarType type)
{
  return SelectFunctionsOfShell(type);
}

} // namespace VolumeHaptics
