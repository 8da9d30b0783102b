// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes a vtkHapticBurr to the model that is baked.
 */
#ifndef BurrDescription_h
#define BurrDescription_h

#include "Core/Model/HapticModelDescription.h"

#include <string>

class vtkHapticBurr;

namespace VolumeHaptics
{

/**
 * Adds a burr to the description of a model that already has its settings, material, frames and
 * geometry, but not the burr's function. False, with the reason and the cure in `error`, if it
 * can't be felt.
 */
bool DescribeBurr(vtkHapticBurr* burr, HapticModelDescription& d, std::string& error);

} // namespace VolumeHaptics

#endif
