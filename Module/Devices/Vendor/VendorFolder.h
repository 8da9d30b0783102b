// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The search folders of plug-ins for vendors' libraries, and the files there that may be loaded.
 *
 * A plug-in runs with all rights of the user. So only folders that the user names are searched, and
 * a plug-in that another user could have written is not loaded (Devices/Common/OwnFile.h). The
 * libraries that a plug-in needs are not checked: the system's loader finds them.
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
  std::string Plugin; ///< the plug-in's name in ids: letters, digits, '-' and '_'
  std::string Path;
};

class VendorFolder
{
public:
  static constexpr const char* Variable = "VOLUMEHAPTICS_VENDOR_PATH";

  /**
   * Returns the folders of a search path, separated by colons; if the path is empty, the folders of
   * the environment variable. A program that has more rights than its user ignores the variable.
   */
  static std::vector<std::string> Split(const std::string& path);

  /**
   * Lists all plug-ins in the folders; if several have the same name, lists the first. For each
   * folder that can't be used, adds a text to `obstacles`.
   */
  static std::vector<VendorFile> List(
    const std::vector<std::string>& folders, std::vector<std::string>& obstacles);

  static bool IsName(const std::string& plugin);
};

} // namespace VolumeHaptics

#endif
