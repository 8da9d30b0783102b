// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads the materials of a vtkHapticProperty in setups and presets.
 */
#ifndef HapticSetupMaterials_h
#define HapticSetupMaterials_h

#include "VTK/Base/HapticSetupNode.h"

#include <functional>

class vtkHapticProperty;

namespace VolumeHaptics
{

/**
 * Passes functions, settings and tissues. The getter is called again for each change of functions
 * and tissues.
 */
void PassMaterials(SetupNode node, const std::function<vtkHapticProperty*()>& get);

} // namespace VolumeHaptics

#endif
