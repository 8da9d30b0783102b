// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks whether it is safe to run a file with the user's rights. Used for plug-ins, and for
 * programs that the library starts.
 *
 * The file, its folder, all folders above and all links in the path must belong to the user or to
 * root, and no other user may write them. (Sticky folders above, such as /tmp, may be writable,
 * because other users can't replace files in them.) On Windows, the owner and the access list of
 * the file and the folders are checked in the real path, and administrators count as root.
 */
#ifndef OwnFile_h
#define OwnFile_h

#include <string>

#include <sys/types.h>

namespace VolumeHaptics
{

#if defined(_WIN32)
using FileGroup = unsigned;
#else
using FileGroup = gid_t;
#endif
constexpr FileGroup NoGroup = static_cast<FileGroup>(-1);

/**
 * Returns the group whose only member is this user. Many systems make such a group for each user,
 * and let it write the files that the user creates. Returns NoGroup if there is no such group, and
 * for root.
 */
FileGroup FindPrivateGroup();

/**
 * Returns the real path of a file that only this user, root and members of the group `trusted` can
 * have written. If others can, returns an empty path, and writes the reason and the remedy to
 * `error`.
 */
std::string FindOwnFile(const std::string& path, FileGroup trusted, std::string& error);

/**
 * Looks for a program in the folder of a file, in up to six folders above it, and in the subfolder
 * "bin" of each of them. Skips a program that FindOwnFile() refuses; `obstacle` then receives the
 * reason, unless it already contains a text. Returns an empty path if there is no program.
 */
std::string FindProgramNear(const std::string& file, const char* program, std::string& obstacle);
/**
 * Looks for a program near the library that contains the function at `code`, and near the running
 * program. The second search is needed if the library is linked into the program, because its path
 * may then be only the program's first argument.
 */
std::string FindProgramOfLibrary(const void* code, const char* program, std::string& obstacle);

/**
 * Returns the value of an environment variable. Returns an empty text if it is not set, or if this
 * program has more rights than its user.
 */
std::string ReadSafeVariable(const char* name);

} // namespace VolumeHaptics

#endif
