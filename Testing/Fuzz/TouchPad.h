// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Any bytes as what Linux and a DualSense tell of a gamepad, and any force as what it is to feel.
 */
#ifndef TouchPad_h
#define TouchPad_h

#include <cstddef>
#include <cstdint>

/**
 * Bytes choose texts of sysfs, axes, events, reports and forces. Aborts if a bit is found that a
 * slow reading of the text does not find, a stick leaves its range, a spoilt report counts, or a
 * motor's level leaves 0 to 1 or its limits of the rate.
 */
void TouchPad(const std::uint8_t* bytes, std::size_t size);

#endif
