// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as reports of a gamepad from Linux and a DualSense, and as forces that the
 * gamepad renders.
 */
#ifndef TouchPad_h
#define TouchPad_h

#include <cstddef>
#include <cstdint>

/**
 * Chooses from the bytes texts of sysfs, axes, events, reports and forces. Aborts if a bit differs
 * from a slow reading of the text, if a stick leaves its range, if a damaged report counts, or if a
 * motor's level leaves the range from 0 to 1 or exceeds its rate limits.
 */
void TouchPad(const std::uint8_t* bytes, std::size_t size);

#endif
