// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WholeFile_h
#define Explore_WholeFile_h

#include <cstddef>
#include <string>

namespace Explore
{
/// How many bytes zlib or gzip packed from an offset of a file on to its end; -1 if they are cut
/// off, or their check sums are wrong. VTK's readers stop where they have what they need, or where
/// the file is damaged, and take whatever was in memory for the rest.
double CountUnpacked(const std::string& file, std::size_t offset);

/// Why a file of VTK's XML formats, or a piece that it names, is not all there; empty if it is.
/// VTK's readers take whatever was in memory for what is missing of appended samples.
std::string FindMissingEnd(const std::string& file);
} // namespace Explore

#endif
