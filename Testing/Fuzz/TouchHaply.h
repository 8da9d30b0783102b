// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Any bytes as what Haply's Inverse service sends.
 */
#ifndef TouchHaply_h
#define TouchHaply_h

#include <cstddef>
#include <cstdint>

/**
 * Bytes are taken as a message, an event and a version, as they are and as JSON that they choose
 * from the names and values of the protocol. Aborts if a number that is told is not finite, if
 * there are more devices than the limit, or if a greeting or a force can't be written to a device
 * that was told.
 */
void TouchHaply(const std::uint8_t* bytes, std::size_t size);

#endif
