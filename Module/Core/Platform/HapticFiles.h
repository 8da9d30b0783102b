// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions on files: reading without hanging, writing, names, and texts for errors. Descriptors
 * are those of Core/Platform/Files.h.
 */
#ifndef HapticFiles_h
#define HapticFiles_h

#include <cstddef>
#include <fstream>
#include <string>

namespace VolumeHaptics
{

/**
 * Makes a text fit for a message. File names may contain any bytes. Bytes that are not UTF-8 become
 * \xNN, because Python drops a message that is not UTF-8; so does a zero, which would end it.
 */
std::string Printable(const std::string& text);
/** Whether a text is UTF-8 (RFC 3629). */
bool IsUtf8(const std::string& text);

/** Returns an absolute file name, which stays valid when the program changes its working folder. */
std::string MakeAbsolute(const std::string& file);

/** Returns the folder of a file, "." if its name has none. */
std::string GetFolder(const std::string& file);

/** Explains from an errno why a file can't be written, with the cure. */
std::string ExplainWriteError(int number, const std::string& file);

/**
 * Checks whether a file can be written, as far as that is possible without writing. If not, returns
 * false, with the reason and the cure in `error`.
 */
bool CheckWritable(const std::string& file, std::string& error);

/** Describes an errno. */
std::string DescribeError(int number);

/** Opens a regular file as a stream of bytes. For a FIFO or a device, the stream has failed. */
std::ifstream OpenStream(const std::string& file);
/**
 * Writes the folder of a file, with its names, to the disk. Returns 0, or the errno of the failure.
 */
int SyncFolder(const std::string& file);

/**
 * Returns whether a path is a regular file: reading a FIFO or a terminal may block for ever. If
 * not, `error` names the kind of the file.
 */
bool CheckRegular(const std::string& file, std::string& error);

/**
 * Returns the reason why a file of more than 64 MiB must not be read: nearly all of it is holes,
 * which take no room on the disk, but gigabytes of memory. A file is accepted up to 1032 times the
 * size of its stored bytes, the factor by which deflate may shrink zeros. Returns an empty text for
 * other files, and on a file system that does not report holes.
 */
std::string DetectHoles(const std::string& file);

/**
 * Reads a regular file of at most `most` bytes. Returns false, with the reason and the cure in
 * `error`, on failure.
 */
bool ReadSmallFile(
  const std::string& file, std::size_t most, std::string& text, std::string& error);

/** Writes all bytes. Returns 0, or the errno of the failure. */
int WriteAll(int descriptor, const void* data, std::size_t size);

} // namespace VolumeHaptics

#endif
