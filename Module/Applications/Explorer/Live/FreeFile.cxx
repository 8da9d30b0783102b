// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/FreeFile.h"

#include <vtksys/SystemTools.hxx>

#include <iomanip>
#include <sstream>

namespace Explore
{
std::string NumberFile(const std::string& name, int number, const std::string& ending)
{
  std::ostringstream file;
  file << name << "-" << std::setw(3) << std::setfill('0') << number << ending;
  return file.str();
}

std::string FindFreeFile(const std::string& name, const std::string& ending)
{
  for (int number = 1;; ++number)
  {
    std::string file = NumberFile(name, number, ending);
    if (!vtksys::SystemTools::FileExists(file))
    {
      return file;
    }
  }
}

std::string FindFreePath(const std::string& name, const std::string& ending)
{
  return vtksys::SystemTools::CollapseFullPath(FindFreeFile(name, ending));
}

std::string FindStateFolder()
{
  std::string home;
  std::string state;
  vtksys::SystemTools::GetEnv("HOME", home);
  vtksys::SystemTools::GetEnv("XDG_STATE_HOME", state);
  return !state.empty() || home.empty() ? state : home + "/.local/state";
}
} // namespace Explore
