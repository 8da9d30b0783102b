// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads tables of labels from files of any known format, compressed or not. The format follows from
 * the bytes.
 */
#ifndef LabelFiles_h
#define LabelFiles_h

#include "VTK/Material/Labels/LabelEntry.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <zlib.h>

namespace VolumeHaptics
{

using GzipFile = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

/**
 * Opens a file for reading from an offset (bytes), where a compressed part may begin. Returns null,
 * with the reason and the cure in `error`, if it can't be opened.
 */
GzipFile OpenGzipFile(const std::string& name, std::size_t offset, std::string& error);

/**
 * Reads, uncompressed, the part of a file that can contain a table of labels: the head of an image
 * file, or all of a text. Returns false, with the reason and the cure in `error`, if the file can't
 * be read.
 */
bool ReadLabelBytes(const std::string& file, std::string& bytes, std::string& error);

/** Returns whether bytes begin like a VTK XML file, whose field data LabelFieldData.h reads. */
bool IsVtkFile(std::string_view bytes);

/**
 * Reads a table of labels from the bytes of any other format. On failure, returns false, with the
 * reason and the cure in `error`, and leaves the entries unchanged.
 */
bool ReadLabels(std::string_view bytes, LabelEntries& entries, std::string& error);

} // namespace VolumeHaptics

#endif
