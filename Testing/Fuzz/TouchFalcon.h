// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Any bytes as what a Novint Falcon sends.
 */
#ifndef TouchFalcon_h
#define TouchFalcon_h

#include <cstddef>
#include <cstdint>

/**
 * Bytes choose transfers of any length, whole reports among garbage, times, forces, and the answers
 * while firmware is loaded. Aborts if a position is not finite, a reached pose is none, a motor
 * gets more than the cap or a force that was not wanted, homing is ready without its conditions, or
 * the loader sends something that it should not.
 */
void TouchFalcon(const std::uint8_t* bytes, std::size_t size);

#endif
