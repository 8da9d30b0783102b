// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as data from an hfab controller.
 */
#ifndef TouchHfab_h
#define TouchHfab_h

#include <cstddef>
#include <cstdint>

/**
 * Chooses lines from the bytes: garbage, answers, damaged answers. Aborts if the reader's answers
 * differ from those of a slow search for brackets and commas, if a tip is not finite, or if a motor
 * gets more than its limit.
 */
void TouchHfab(const std::uint8_t* bytes, std::size_t size);

#endif
