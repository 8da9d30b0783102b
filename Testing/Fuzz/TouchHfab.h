// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Any bytes as what an hfab controller sends.
 */
#ifndef TouchHfab_h
#define TouchHfab_h

#include <cstddef>
#include <cstdint>

/**
 * Bytes choose lines: garbage, answers, spoilt answers. Aborts if the reader finds other answers
 * than a slow search for brackets and commas, a tip is not finite, or a motor gets more than its
 * cap.
 */
void TouchHfab(const std::uint8_t* bytes, std::size_t size);

#endif
