// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads lists of labels that other programs write, with one label per line: its name and, in most
 * formats, its colour.
 *
 *   ITK-SNAP (label descriptions)   1   255   0   0   1  1  1   "Left ventricle"
 *   FreeSurfer (colour tables)      17  Left-Hippocampus  220 216 20 0
 *   MRIcron (names)                 17  Hippocampus_L     4101
 *
 * ITK-SNAP: label; red, green, blue, 0 to 255; opacity and two flags of its display, which are
 * ignored; a name in quotes. FreeSurfer: label; name; red, green, blue and transparency, which is
 * ignored. MRIcron: label; name; sometimes a number, which is ignored. Empty lines and lines that
 * begin with # are ignored. If a label has several lines, the last one counts.
 *
 * MRIcron stores colours in a file of 768 bytes: red for the labels 0 to 255, then green, then
 * blue.
 */
#ifndef ColorTables_h
#define ColorTables_h

#include "VTK/Material/Labels/LabelEntry.h"

#include <string>
#include <string_view>

namespace VolumeHaptics
{

///@{
/**
 * Returns whether the first line that is neither empty nor a comment has the format of such a list.
 */
bool IsItkSnapTable(std::string_view text);
bool IsFreeSurferTable(std::string_view text);
bool IsNameList(std::string_view text);
///@}

///@{
/**
 * Read a list. On failure, return false, with the reason and the cure in `error`, and leave the
 * entries unchanged.
 */
bool ReadItkSnapTable(std::string_view text, LabelEntries& entries, std::string& error);
bool ReadFreeSurferTable(std::string_view text, LabelEntries& entries, std::string& error);
bool ReadNameList(std::string_view text, LabelEntries& entries, std::string& error);
///@}

/** Returns whether a file may be a palette of MRIcron, which is true if it has 768 bytes. */
bool IsPalette(std::string_view bytes);
/** Reads the colours of the labels 0 to 255 from a palette. */
void ReadPalette(std::string_view bytes, LabelEntries& entries);

} // namespace VolumeHaptics

#endif
