// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A plug-in folder for vendors' libraries that no other user can write to. It becomes the search
 * path.
 */
#ifndef PluginFolder_h
#define PluginFolder_h

#include "Core/Platform/Libraries.h"
#include "Rigs/Portable.h"

#include <filesystem>
#include <string>

namespace devicetest
{

/**
 * A temporary folder. The system's temporary folder is sticky, whereas other users may be able to
 * write to the folders above the build tree.
 */
class PluginFolder
{
public:
  PluginFolder()
  {
    this->Path = std::filesystem::canonical(
      MakeNewFolder(std::filesystem::temp_directory_path() / "VolumeHapticsVendor"));
    setenv("VOLUMEHAPTICS_VENDOR_PATH", this->Path.string().c_str(), 1);
  }
  ~PluginFolder()
  {
    unsetenv("VOLUMEHAPTICS_VENDOR_PATH");
    std::error_code ignored;
    std::filesystem::permissions(this->Path, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(this->Path, ignored);
  }
  /** Copies a plug-in from the build tree. Only the owner can write to the copy. */
  std::filesystem::path Add(const std::string& plugin, const std::string& name = "") const
  {
    const std::filesystem::path file = this->Path /
      ("libvolumehaptics-" + (name.empty() ? plugin : name) + VolumeHaptics::Libraries::Ending);
    std::filesystem::copy_file(std::string(VOLUME_HAPTICS_PLUGINS) + "/libvolumehaptics-" + plugin +
        VolumeHaptics::Libraries::Ending,
      file, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }
  std::filesystem::path Path;
};

} // namespace devicetest

#endif
