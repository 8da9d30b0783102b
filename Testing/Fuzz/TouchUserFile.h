// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Any bytes as the files that a user has for devices: the Falcon's firmware, and the file of
 * devices.
 */
#ifndef TouchUserFile_h
#define TouchUserFile_h

#include <cstddef>
#include <cstdint>

/**
 * The bytes are both files. Aborts if an image is not the file byte for byte, or has a wrong size;
 * if a device's scale is out of its limits, or its days are none; if facts that are written do not
 * come back, or change those of another device; or if a refusal names no cure.
 */
void TouchUserFile(const std::uint8_t* bytes, std::size_t size);

#endif
