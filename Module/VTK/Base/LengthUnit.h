// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts the units of length that files state.
 */
#ifndef LengthUnit_h
#define LengthUnit_h

#include <string>

namespace VolumeHaptics
{

/**
 * Returns the length (mm) of a unit, given its name or symbol, such as "um", "micron",
 * "micrometer", "\xc2\xb5m" or "inch". Returns 0 for an unknown unit, such as "pixel".
 */
double MillimetresPerUnit(const std::string& unit);

} // namespace VolumeHaptics

#endif
