// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks whether a file may run with the user's rights. For plug-ins and guards.
 *
 * The file, its folder, all folders above and all links in the path must belong to the user or to
 * root, and nobody else may be able to write them. (A folder above may be writable for others if it
 * is sticky, as /tmp is: others can't replace files in it.)
 */
#ifndef OwnFile_h
#define OwnFile_h

#include <string>

#include <sys/types.h>

namespace VolumeHaptics
{

constexpr gid_t NoGroup = static_cast<gid_t>(-1);

/**
 * Returns the group whose only member is this user. Many systems make such a group for each user,
 * and let it write the files that the user creates. Returns NoGroup if there is no such group, and
 * for root.
 */
gid_t FindPrivateGroup();

/**
 * Returns the real path of a file if only this user, root and members of the group `trusted` can
 * have written it. Otherwise returns an empty path, and writes the reason and the cure to `error`.
 */
std::string FindOwnFile(const std::string& path, gid_t trusted, std::string& error);

/**
 * Returns an environment variable. Returns nullptr if it is not set, or if this program has more
 * rights than its user.
 */
const char* ReadSafeVariable(const char* name);

} // namespace VolumeHaptics

#endif
