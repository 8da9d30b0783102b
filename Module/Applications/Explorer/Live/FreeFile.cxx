// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/FreeFile.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace
{
std::string FindRecentList()
{
  const std::string state = Explore::FindStateFolder();
  return state.empty() ? state : state + "/volumehaptics-explore/recent.txt";
}
} // namespace

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

std::vector<std::string> ReadRecentFiles()
{
  std::vector<std::string> files;
  const std::string list = FindRecentList();
  std::ifstream in(list);
  for (std::string line; !list.empty() && std::getline(in, line);)
  {
    files.push_back(line);
  }
  return files;
}

void AddRecentFile(const std::string& path)
{
  constexpr std::size_t most = 8;
  const std::string list = FindRecentList();
  const std::string file = vtksys::SystemTools::CollapseFullPath(path);
  std::vector<std::string> files = ReadRecentFiles();
  files.erase(std::remove(files.begin(), files.end(), file), files.end());
  files.insert(files.begin(), file);
  files.resize(std::min(files.size(), most));
  const mode_t mode = 0700; // what was looked at is the user's own business
  if (list.empty() ||
    !vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(list), &mode))
  {
    return;
  }
  std::ofstream out(list);
  for (const std::string& one : files)
  {
    out << one << "\n";
  }
}
} // namespace Explore
