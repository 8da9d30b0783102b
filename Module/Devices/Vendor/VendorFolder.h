// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The folders in which plug-ins for vendors' libraries are looked for, and which files there may be
 * loaded.
 *
 * A plug-in runs with all rights of the user. So only folders that the user names are searched, and
 * no plug-in is loaded that another user could have written (Devices/Common/OwnFile.h). The
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

  static bool IsName(const std::string& plugin);
};

} // namespace VolumeHaptics

#endif
