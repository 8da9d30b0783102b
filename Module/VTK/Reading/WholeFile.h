// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WholeFile_h
#define Explore_WholeFile_h

#include <cstddef>
#include <string>

namespace Explore
{
/// Decompresses zlib or gzip data from an offset to the end of a file, and returns the number of
/// bytes. Returns -1 if the data are cut off or a checksum is wrong. VTK's readers do not detect
/// this: they stop when they have enough bytes or where the file is damaged, and leave the rest of
/// their memory uninitialised.
double CountUnpacked(const std::string& file, std::size_t offset);

/// Returns the reason why the header of a NIfTI or Analyze file, perhaps compressed, can't be true;
/// empty if it can. VTK's readers look up an unknown type beyond the end of their list of types.
std::string DetectFalseNiftiHeader(const std::string& header);

/// Returns the reason why a path must not be read as a file: a reader would wait for a pipe, and
/// read a device without end. Returns an empty text for a regular file, and for a missing one,
/// which the reader reports.
std::string DetectDevice(const std::string& path);

/// Calls DetectDevice() for all paths in a folder and its subfolders, and returns the first reason.
/// Needed for formats that refer to other files in ways that only VTK's reader knows.
std::string DetectDeviceIn(const std::string& folder);

/// Returns the reason why a file of VTK's XML formats, or a piece that it refers to, is incomplete
/// or states sizes that can't be true; empty if there is none. VTK's readers leave missing appended
/// samples uninitialised.
std::string DetectMissingEnd(const std::string& file);
} // namespace Explore

#endif
