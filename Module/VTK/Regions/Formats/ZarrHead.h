// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads Zarr's JSON files.
 */
#ifndef ZarrHead_h
#define ZarrHead_h

#include "vtk_jsoncpp_fwd.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Reads a file. Returns false if it does not exist.
 * @throws std::runtime_error if the file contains no JSON object
 */
bool ReadZarrHead(const std::string& file, Json::Value& head);

} // namespace VolumeHaptics

#endif
