// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which files on this computer may run with the rights of the user: a plug-in, or a guard.
 *
 * The file, its folder, all folders above and all links on the way belong to the user or to root,
 * and no one else may write them. (A folder above that others may write is accepted if it is
 * sticky, as /tmp is: others can't replace what is in it.)
 */
#ifndef OwnFile_h
#define OwnFile_h

#include <string>

#include <sys/types.h>

namespace VolumeHaptics
{

constexpr gid_t NoGroup = static_cast<gid_t>(-1);

/**
 * The group of which this user is the only member, as many systems make one for each user, who then
 * creates files that it may write. NoGroup if there is none, and for root.
 */
gid_t FindPrivateGroup();

/**
 * The real path of a file that no other user could have written; members of `trusted` may. Empty,
 * with the reason and the cure, if there is none.
 */
std::string FindOwnFile(const std::string& path, gid_t trusted, std::string& error);

/**
 * An environment variable; nullptr if it is not set, or if this program has more rights than its
 * user.
 */
const char* ReadSafeVariable(const char* name);

} // namespace VolumeHaptics

#endif
