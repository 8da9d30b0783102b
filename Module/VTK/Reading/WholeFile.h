// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WholeFile_h
#define Explore_WholeFile_h

#include <cstddef>
#include <string>

namespace Explore
{
/// Counts the bytes that zlib or gzip packed, from an offset of a file to its end; -1 if they are
/// cut off, or if a check sum is wrong. VTK's readers stop when they have what they need, or where
/// the file is damaged, and use whatever was in memory for the rest.
double CountUnpacked(const std::string& file, std::size_t offset);

/// Returns why a file of VTK's XML formats, or a piece that it names, is not complete; empty if it
/// is. VTK's readers use whatever was in memory for missing appended samples.
std::string DetectMissingEnd(const std::string& file);
} // namespace Explore

#endif
