// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Reads a small file as a whole. Refuses to wait for a pipe or a device, and allocates at
 * most the memory that a file of this kind can need.
 */
#ifndef SmallFile_h
#define SmallFile_h

#include <cstddef>
#include <string>

namespace VolumeHaptics
{

/**
 * Reads a regular file of at most `most` bytes. Returns an empty text on success. On failure,
 * returns the fault, such as "does not exist", and `bytes` is empty.
 */
std::string ReadSmallFile(const std::string& file, std::size_t most, std::string& bytes);

/** Fault of a file that does not exist. */
constexpr const char* NoSuchFile = "does not exist";

} // namespace VolumeHaptics

#endif
