// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Texts, numbers and colours in files of labels.
 */
#ifndef LabelText_h
#define LabelText_h

#include <string>

namespace VolumeHaptics
{

/**
 * A text as UTF-8 without control characters. If it is not UTF-8, it is taken for ISO 8859-1, which
 * old programs write; control characters become spaces.
 */
std::string MakeLabelName(const std::string& text);

} // namespace VolumeHaptics

#endif
