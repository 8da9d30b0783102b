// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tables of labels from files of any known format, which the bytes tell.
 */
#ifndef LabelFiles_h
#define LabelFiles_h

#include "VTK/Material/Labels/LabelEntry.h"

#include <string>
#include <string_view>

namespace VolumeHaptics
{

/**
 * The part of a file that can have a table of labels, uncompressed: the head of an image file, or
 * all of a text. False, with the reason and the cure, if the file can't be read.
 */
bool ReadLabelBytes(const std::string& file, std::string& bytes, std::string& error);

/** Whether bytes begin as a VTK XML file does, whose field data LabelFieldData.h reads. */
bool IsVtkFile(std::string_view bytes);

/**
 * Reads a table of labels from the bytes of any other format. False, with the reason and the cure,
 * and entries unchanged, if that fails.
 */
bool ReadLabels(std::string_view bytes, LabelEntries& entries, std::string& error);

} // namespace VolumeHaptics

#endif
