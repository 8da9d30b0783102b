// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the XML of labels in a NIfTI file: see NiftiLabels.h.
 */
#ifndef XmlLabels_h
#define XmlLabels_h

#include "VTK/Material/Labels/LabelEntry.h"

#include <string>
#include <string_view>

namespace VolumeHaptics
{

/**
 * Reads the labels. False, with the reason and the cure, and entries unchanged, if the text can't
 * be read.
 */
bool ReadXmlLabels(std::string_view xml, LabelEntries& entries, std::string& error);

} // namespace VolumeHaptics

#endif
