// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads files without hanging, writes them, and makes file names and error messages. Descriptors
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
 * Makes a text suitable for a message. File names may contain any bytes. Bytes that are not UTF-8
 * become \xNN, because Python drops messages that are not UTF-8. Zero bytes do, too, because they
 * would end the message.
 */
std::string Printable(const std::string& text);
/** Returns whether a text is UTF-8 (RFC 3629). */
bool IsUtf8(const std::string& text);

/** Returns an absolute file name, which stays valid when the program changes its working folder. */
std::string MakeAbsolute(const std::string& file);

/** Returns the folder of a file, or "." if its name contains none. */
std::string GetFolder(const std::string& file);

/** Explains why a file can't be written, given an errno, and names the remedy. */
std::string ExplainWriteError(int number, const std::string& file);

/**
 * Checks whether a file can be written, as far as possible without writing. If it can't, returns
 * false, with the reason and the remedy in `error`.
 */
bool CheckWritable(const std::string& file, std::string& error);

/** Describes an errno. */
std::string DescribeError(int number);

/**
 * Opens a regular file as a stream of bytes. If the file is a FIFO or a device, the stream is in a
 * failed state.
 */
std::ifstream OpenStream(const std::string& file);
/**
 * Flushes the folder of a file, with its names, to the disk. Returns 0, or the errno of the
 * failure.
 */
int SyncFolder(const std::string& file);

/**
 * Returns whether a path is a regular file. Other files, such as FIFOs and terminals, may block a
 * reader for ever; `error` then names the kind of file.
 */
bool CheckRegular(const std::string& file, std::string& error);

/**
 * Checks a file of more than 64 MiB for holes, which need no room on the disk, but gigabytes of
 * memory. Returns the reason why the file must not be read if it is more than 1032 times as large
 * as its stored bytes. 1032 is the largest factor by which deflate can shrink zeros. Returns an
 * empty text for other files, and if the file system does not report holes.
 */
std::string DetectHoles(const std::string& file);

/**
 * Reads a regular file of at most `most` bytes. On failure, returns false, with the reason and the
 * remedy in `error`.
 */
bool ReadSmallFile(
  const std::string& file, std::size_t most, std::string& text, std::string& error);

/** Writes all bytes. Returns 0, or the errno of the failure. */
int WriteAll(int descriptor, const void* data, std::size_t size);

} // namespace VolumeHaptics

#endif
