// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as a user's files for devices: the Falcon's firmware, and the file of
 * devices.
 */
#ifndef TouchUserFile_h
#define TouchUserFile_h

#include <cstddef>
#include <cstdint>

/**
 * Uses the bytes as both files. Aborts if an image differs from the file or has a wrong size; if a
 * device's scale is out of its limits, or a day is not a date; if written facts are not read back,
 * or change those of another device; or if a refusal does not name a remedy.
 */
void TouchUserFile(const std::uint8_t* bytes, std::size_t size);

#endif
