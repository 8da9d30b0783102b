// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the methods for feeling a volume.
 */
#ifndef Methods_h
#define Methods_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{
struct HapticSettings;

/** Returns the method that the settings select. For Proxy, the result depends on the solver. */
const Method& GetMethod(const HapticSettings& settings) noexcept;

} // namespace VolumeHaptics

#endif
