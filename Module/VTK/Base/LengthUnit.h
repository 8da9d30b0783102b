// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts units of length in files.
 */
#ifndef LengthUnit_h
#define LengthUnit_h

#include <string>

namespace VolumeHaptics
{

/**
 * Returns the length (mm) of a unit from its name or symbol, such as "um", "micron", "micrometer",
 * "\xc2\xb5m" or "inch". Returns 0 if it is not known, for example for "pixel".
 */
double MillimetresPerUnit(const std::string& unit);

} // namespace VolumeHaptics

#endif
