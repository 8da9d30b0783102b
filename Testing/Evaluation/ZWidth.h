// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures how stiff a wall can be for a device. The range from air to this stiffness is the
 * device's Z-width.
 */
#ifndef Evaluation_ZWidth_h
#define Evaluation_ZWidth_h

#include "Figure.h"

namespace evaluation
{

/**
 * Makes a model of a wall with a given stiffness (N/m) that begins at or slightly above z = 0 of
 * the device.
 */
using WallMaker = std::function<std::shared_ptr<const VolumeHaptics::HapticModel>(double)>;

/**
 * Returns the stiffest wall (N/m) on which a device of 0.1 kg with a damping (N s/m) comes to rest,
 * with a delay of the force in ticks. Theory (Gil et al. 2004; T16): 2 b / T without delay.
 */
double FindStiffestWall(const WallMaker& makeWall, double damping, int delay);

} // namespace evaluation

#endif
