// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens a file through zlib, whether it is compressed or not.
 */
#ifndef GzipFile_h
#define GzipFile_h

#include <cstddef>
#include <memory>
#include <string>
#include <zlib.h>

namespace VolumeHaptics
{

using GzipFile = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

/**
 * Opens a file for reading from an offset (bytes), where a compressed part may begin. Returns null,
 * with the reason and the cure in `error`, if it can't be opened.
 */
GzipFile OpenGzipFile(const std::string& name, std::size_t offset, std::string& error);

} // namespace VolumeHaptics

#endif
