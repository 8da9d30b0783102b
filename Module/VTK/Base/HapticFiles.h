// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions on files: reading without hanging, writing, names, and texts for errors.
 */
#ifndef HapticFiles_h
#define HapticFiles_h

#include <cstddef>
#include <string>

#include <sys/stat.h>

namespace VolumeHaptics
{

/**
 * A text for a message. File names may hold any bytes; those that are not UTF-8 become \xNN,
 * because Python drops a message that is not UTF-8.
 */
std::string Printable(const std::string& text);

/** The name of a file that stays valid when the program changes its folder. */
std::string MakeAbsolute(const std::string& file);

/** The folder of a file, "." if its name has none. */
std::string GetFolder(const std::string& file);

/** The reason why a file can't be written, and the cure, from an errno. */
std::string ExplainWriteError(int number, const std::string& file);

/**
 * False, with the reason and the cure, if a file can't be written, as far as that can be found out
 * without writing.
 */
bool CheckWritable(const std::string& file, std::string& error);

/** Text of an errno. */
std::string DescribeError(int number);

///@{
/**
 * open(2) and fsync(2), repeated if a signal interrupts them. A file system without fsync is no
 * error.
 */
int OpenFile(const std::string& file, int flags, mode_t mode = 0);
int SyncFile(int descriptor);
///@}
/** Opens a file to read; opening a FIFO does not wait. Below zero, with errno, if that fails. */
int OpenToRead(const std::string& file);
/** Writes the names in the folder of a file to the disk. Returns 0, or the errno. */
int SyncFolder(const std::string& file);

/** The file that links lead to, even if it does not exist yet. */
std::string FollowLinks(const std::string& file);

/** Whether a name is that of the open file. */
bool IsSameFile(int descriptor, const std::string& file);

/**
 * Gives a new file the owner, the group and the permissions of another one, as far as the system
 * allows. False if the group differs; the file's own group then gets no permissions.
 */
bool TakePermissions(int descriptor, const struct stat& other);

/**
 * False, with what it is instead, for everything but regular files: reading a FIFO or a terminal
 * may take forever.
 */
bool CheckRegular(const std::string& file, std::string& error);

/**
 * Reads a regular file of limited size (bytes). False, with the reason and the cure, if that fails.
 */
bool ReadSmallFile(
  const std::string& file, std::size_t most, std::string& text, std::string& error);

/** Writes all bytes. Returns 0, or the errno of the failure. */
int WriteAll(int descriptor, const void* data, std::size_t size);

} // namespace VolumeHaptics

#endif
