// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a vtkHapticBurr to what a model is baked from.
 */
#ifndef BurrDescription_h
#define BurrDescription_h

#include "Core/Model/HapticModelDescription.h"

#include <string>

class vtkHapticBurr;

namespace VolumeHaptics
{

/**
 * Describes a burr to a model that has its settings, material, frames and geometry already, but for
 * the function of the burr. False, with the reason and the cure in `error`, if it can't be felt.
 */
bool DescribeBurr(vtkHapticBurr* burr, HapticModelDescription& d, std::string& error);

} // namespace VolumeHaptics

#endif
