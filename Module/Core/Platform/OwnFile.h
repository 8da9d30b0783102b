// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks whether a file may run with the user's rights. For plug-ins and for programs that the
 * library starts.
 *
 * The file, its folder, all folders above and all links in the path must belong to the user or to
 * root, and no other user may write them. (Other users may write a folder above that is sticky,
 * such as /tmp, because they can't replace files in it.) On Windows, the owner and the access list
 * of the file and the folders say this; administrators stand for root, and the real path is
 * checked.
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
 * Returns the real path of a file if only this user, root and members of the group `trusted` can
 * have written it. Otherwise returns an empty path, and writes the reason and the cure to `error`.
 */
std::string FindOwnFile(const std::string& path, FileGroup trusted, std::string& error);

/**
 * Looks for a program in the folder of a file, in all folders above, up to six, and in a folder
 * "bin" in each of them. A program that FindOwnFile() refuses is skipped. Then `obstacle` receives
 * the reason, unless it already has a text. Returns an empty path if there is no program.
 */
std::string FindProgramNear(const std::string& file, const char* program, std::string& obstacle);
/**
 * Looks for a program near the library that has a function at `code`, and near this process's own
 * program, because the path of a library that is linked into it may be only its first argument.
 */
std::string FindProgramOfLibrary(const void* code, const char* program, std::string& obstacle);

/**
 * Returns an environment variable. Returns an empty text if it is not set, or if this program has
 * more rights than its user.
 */
std::string ReadSafeVariable(const char* name);

} // namespace VolumeHaptics

#endif
