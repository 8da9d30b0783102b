// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads label tables from files of any known format, compressed or not. The contents determine the
 * format.
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
 * Opens a file for reading from an offset (bytes); a compressed part may begin there. Returns null,
 * with the reason and the cure in `error`, if the file can't be opened.
 */
GzipFile OpenGzipFile(const std::string& name, std::size_t offset, std::string& error);

/**
 * Reads and decompresses the part of a file that can contain a label table: the header of an image
 * file, or a whole text file. Returns false, with the reason and the cure in `error`, if the file
 * can't be read.
 */
bool ReadLabelBytes(const std::string& file, std::string& bytes, std::string& error);

/**
 * Returns whether the bytes start like a VTK XML file. LabelFieldData.h reads the field data of
 * such a file.
 */
bool IsVtkFile(std::string_view bytes);

/**
 * Reads a label table from the bytes of any other format. On failure, returns false, with the
 * reason and the cure in `error`, and leaves the entries unchanged.
 */
bool ReadLabels(std::string_view bytes, LabelEntries& entries, std::string& error);

} // namespace VolumeHaptics

#endif
