// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions for files, their descriptors and their names, on Linux, macOS and Windows.
 *
 * Names are UTF-8 on all systems. On failure, a function sets errno. On Windows, a program can't
 * remove or rename a file that another program has open, unless the other program allows it; files
 * that are opened here allow it.
 */
#ifndef Files_h
#define Files_h

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>

namespace VolumeHaptics
{
namespace Files
{

#if defined(_WIN32)
using Status = struct _stat64;
using Mode = int;
#else
using Status = struct stat;
using Mode = mode_t;
#endif

/** The ways to open a file. */
enum class For : std::uint8_t
{
  Reading,   ///< reads without waiting for the writer of a FIFO
  Writing,   ///< replaces the contents of an existing file
  MakingNew, ///< fails with EEXIST if the name exists, even as a link; reads and writes
  ReadingFolder
};

///@{
/** Convert a UTF-8 name to a path of the standard library, and back. */
std::filesystem::path ToPath(const std::string& name);
std::string ToName(const std::filesystem::path& path);
///@}

/**
 * Opens a file. Tries again if a signal interrupts. Returns a descriptor, or a negative number on
 * failure.
 */
int Open(const std::string& name, For what, Mode mode = 0);
void Close(int descriptor) noexcept;
/** Closes a file. Returns false if bytes may be lost. */
bool CloseWritten(int descriptor) noexcept;
/** Returns a second descriptor of the same open file. */
int Duplicate(int descriptor) noexcept;

///@{
/**
 * Read or write bytes. Return their number, which may be smaller than `size`, or a negative number
 * on failure.
 */
std::int64_t Read(int descriptor, void* data, std::size_t size) noexcept;
std::int64_t ReadAt(int descriptor, void* data, std::size_t size, std::int64_t from) noexcept;
std::int64_t Write(int descriptor, const void* data, std::size_t size) noexcept;
///@}
bool Seek(int descriptor, std::int64_t position) noexcept;
bool SeekEnd(int descriptor) noexcept;
/** Writes the bytes to the disk. Returns 0, or the errno of the failure. */
int Sync(int descriptor) noexcept;

///@{
/**
 * Lock an open file without waiting. If the file is locked already, they set errno to EWOULDBLOCK.
 */
bool LockAlone(int descriptor) noexcept;
bool LockShared(int descriptor) noexcept;
void Unlock(int descriptor) noexcept;
///@}

///@{
bool GetStatus(const std::string& name, Status& status);
bool GetStatus(int descriptor, Status& status) noexcept;
///@}
bool IsRegular(const Status& status) noexcept;
bool IsFolder(const Status& status) noexcept;
bool IsPipe(const Status& status) noexcept;
/** Returns whether a name exists, even as a link without a target. */
bool Exists(const std::string& name);
/** Returns whether a name belongs to the open file. */
bool IsSame(int descriptor, const std::string& name);

/** Renames a file. Replaces an existing file with the new name. */
bool Rename(const std::string& from, const std::string& to);
bool Remove(const std::string& name);
/**
 * Creates a file with a random name in the folder of `file`. Returns a descriptor, like Open() for
 * MakingNew.
 */
int CreateBeside(const std::string& file, Mode mode, std::string& name);

///@{
/** Return whether the user may write a file, or create files in a folder. */
bool MayWrite(const std::string& name);
bool MayWriteFolder(const std::string& name);
///@}
/**
 * Copies the owner, the group and the permissions of an existing file to a new one, as far as the
 * system allows. Returns false if the groups differ; the new file's group then gets no permissions.
 */
bool CopyPermissions(int descriptor, const Status& other) noexcept;

/**
 * Counts the bytes of a file that are stored on the disk, and stops after `enough`. Returns more
 * than `enough` if the file system does not report holes.
 */
std::int64_t CountStored(int descriptor, std::int64_t enough) noexcept;

/** Returns the folder of a file, or "." if its name contains none. */
std::string GetFolder(const std::string& name);
bool IsAbsolute(const std::string& name) noexcept;
/** Returns the current working folder, or an empty name. */
std::string GetWorkingFolder();
/** Follows symbolic links. Returns the file to which they lead, even if it does not exist yet. */
std::string ResolveLinks(const std::string& name);

/** Returns the value of an environment variable, or an empty text. */
std::string GetVariable(const char* name);
/**
 * Returns the folder for the user's settings: $XDG_CONFIG_HOME or ~/.config, or %APPDATA% on
 * Windows. Returns an empty name if these variables are not set.
 */
std::string GetSettingsFolder();

} // namespace Files
} // namespace VolumeHaptics

#endif
