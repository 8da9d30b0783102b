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
 * Parses a text. Returns false, with "it is not JSON", the line and the reason in `error`, if the
 * text is not JSON. Also refuses a text that is nested more than 64 deep, because jsoncpp reads,
 * copies and frees by recursion, on threads whose stacks may be small. NaN and Infinity are numbers
 * here, so that an error can name their key. All JSON from outside goes through this function;
 * ReadSmallFile() limits its size.
 */
bool ParseJson(const std::string& text, Json::Value& root, std::string& error);

/** Writes JSON with every double exact to the bit, and each short list on one line. */
std::string WriteJson(const Json::Value& root);

} // namespace VolumeHaptics

#endif
