// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Units of length in files.
 */
#ifndef LengthUnit_h
#define LengthUnit_h

#include <string>

namespace VolumeHaptics
{

/**
 * Returns the length (mm) of a unit by its name or symbol, such as "um", "micron", "micrometer",
 * "\xc2\xb5m" or "inch"; 0 if it is not known, as "pixel".
 */
double MillimetresPerUnit(const std::string& unit);

} // namespace VolumeHaptics

#endif
