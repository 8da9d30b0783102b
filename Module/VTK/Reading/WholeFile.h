// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WholeFile_h
#define Explore_WholeFile_h

#include <cstddef>
#include <string>

namespace Explore
{
/// Returns the number of unpacked bytes that zlib or gzip packed, from an offset of a file to its
/// end; -1 if the packed bytes are cut off, or if a checksum is wrong. VTK's readers stop when they
/// have what they need, or where the file is damaged, and fill the rest with whatever was in
/// memory.
double CountUnpacked(const std::string& file, std::size_t offset);

/// Returns the reason why the header of a NIfTI or Analyze file, perhaps packed, can't be true;
/// empty if it can. VTK's readers look for an unknown type in memory beyond their list of types.
std::string DetectFalseNiftiHeader(const std::string& header);

/// Returns the reason why a path must not be read as a file: it is a pipe, for which a reader would
/// wait, or a device, which it would read without end. Returns an empty text for a file, and for a
/// path that does not exist, because the reader reports this.
std::string DetectDevice(const std::string& path);

/// Calls DetectDevice() for all paths in a folder and its subfolders, and returns the first reason.
/// It is for formats whose files name other files in ways that only VTK's reader knows.
std::string DetectDeviceIn(const std::string& folder);

/// Returns the reason why a file of VTK's XML formats, or a piece that it names, is not complete,
/// or gives sizes that can't be true; empty if there is no such fault. VTK's readers fill missing
/// appended samples with whatever was in memory.
std::string DetectMissingEnd(const std::string& file);
} // namespace Explore

#endif
