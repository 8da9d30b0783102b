// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the folders for plug-ins for vendors' libraries, and the files in them that may be loaded.
 *
 * A plug-in runs with all permissions of the user. Therefore only folders that the user names are
 * searched, and a plug-in that another user could have written is not loaded
 * (Core/Platform/OwnFile.h). The libraries that a plug-in needs are not checked, because the
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
  std::string Plugin; ///< name of the plug-in in ids: letters, digits, '-' and '_'
  std::string Path;
};

class VendorFolder
{
public:
  static constexpr const char* Variable = "VOLUMEHAPTICS_VENDOR_PATH";

  /**
   * Splits a search path into folders, at colons, or at semicolons on Windows. An empty path stands
   * for the folders in the environment variable, which is ignored by a program with more
   * permissions than its user.
   */
  static std::vector<std::string> Split(const std::string& path);

  /**
   * Lists all plug-ins in the folders. Of several with the same name, lists only the first. Adds a
   * text to `obstacles` for each unusable folder.
   */
  static std::vector<VendorFile> List(
    const std::vector<std::string>& folders, std::vector<std::string>& obstacles);

  static bool IsName(const std::string& plugin);
};

} // namespace VolumeHaptics

#endif
