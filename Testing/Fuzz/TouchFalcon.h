// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as data from a Novint Falcon.
 */
#ifndef TouchFalcon_h
#define TouchFalcon_h

#include <cstddef>
#include <cstdint>

/**
 * Chooses from the bytes transfers of any length, whole reports among garbage, times, forces, and
 * the answers while firmware is loaded. Aborts if a position is not finite, if an unreached pose
 * counts as reached, if a motor gets more than its limit or a force that was not requested, if
 * homing completes without its conditions, or if the loader sends wrong bytes.
 */
void TouchFalcon(const std::uint8_t* bytes, std::size_t size);

#endif
