// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts JSON to text and back, in any locale.
 */
#ifndef JsonText_h
#define JsonText_h

#include "vtk_jsoncpp.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Parses a text. If it is not JSON, returns false, with "it is not JSON", the line and the reason
 * in `error`. Also refuses nesting of more than 64 levels, because jsoncpp reads, copies and frees
 * recursively, on threads whose stacks may be small. Accepts NaN and Infinity as numbers, so that
 * an error can name their key. All JSON from files goes through this function; ReadSmallFile()
 * limits its size.
 */
bool ParseJson(const std::string& text, Json::Value& root, std::string& error);

/** Writes JSON with all digits of every double, and each short list on one line. */
std::string WriteJson(const Json::Value& root);

} // namespace VolumeHaptics

#endif
