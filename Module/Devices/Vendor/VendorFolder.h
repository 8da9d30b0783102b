// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The folders in which plug-ins for vendors' libraries are looked for, and which files there may be
 * loaded.
 *
 * A plug-in runs with all rights of the user. So only folders that the user names are searched, and
 * no plug-in is loaded that another user could have written: the folder that is searched, the file,
 * its folder, all folders above and all links on the way belong to the user or to root, and no one
 * else may write them. (A folder above that others may write is accepted if it is sticky, as /tmp
 * is: others can't replace what is in it.) The libraries that a plug-in needs are not checked: the
 * system's loader finds them.
 */
#ifndef VendorFolder_h
#define VendorFolder_h

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A file that may be a plug-in. */
struct VendorFile
{
  std::string Plugin; ///< its name in ids: letters, digits, '-' and '_'
  std::string Path;
};

class VendorFolder
{
public:
  static constexpr const char* Variable = "VOLUMEHAPTICS_VENDOR_PATH";

  /**
   * The folders of a search path, which are separated by colons; of the environment variable if the
   * path is empty. A program that has more rights than its user ignores the variable.
   */
  static std::vector<std::string> Split(const std::string& path);

  /** All plug-ins in the folders; of two with a name, the first. Folders that fail add a text. */
  static std::vector<VendorFile> Find(
    const std::vector<std::string>& folders, std::vector<std::string>& obstacles);

  /**
   * The real path of a file that may be loaded. Empty, with the reason and the cure, if there is
   * none or another user could have written it.
   */
  static std::string Check(const std::string& path, std::string& error);

  static bool IsName(const std::string& plugin);
};

} // namespace VolumeHaptics

#endif
