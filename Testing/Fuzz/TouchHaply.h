// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as data from Haply's Inverse service.
 */
#ifndef TouchHaply_h
#define TouchHaply_h

#include <cstddef>
#include <cstdint>

/**
 * Uses the bytes as a message, an event and a version: unchanged, and as JSON whose names and
 * values the bytes select from the protocol. Aborts if a reported number is not finite, if there
 * are more devices than the limit, or if a greeting or a force can't be written to a reported
 * device.
 */
void TouchHaply(const std::uint8_t* bytes, std::size_t size);

#endif
