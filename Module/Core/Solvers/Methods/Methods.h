// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the methods with which a tick feels a volume.
 */
#ifndef Methods_h
#define Methods_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{
struct HapticSettings;

/** Returns the method of the settings; for PROXY, the row of its solver. */
const Method& GetMethod(const HapticSettings& settings) noexcept;

} // namespace VolumeHaptics

#endif
