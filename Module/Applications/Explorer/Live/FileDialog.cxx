// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/FileDialog.h"

#include <vtksys/Process.h>
#include <vtksys/SystemTools.hxx>

#include <vector>

namespace
{
std::string FindProgram(const char* name)
{
  return vtksys::SystemTools::FindProgram(name);
}
} // namespace

namespace Explore
{
bool FileDialog::Open(const std::string& folder)
{
  const std::string zenity = FindProgram("zenity");
  const std::string kdialog = zenity.empty() ? FindProgram("kdialog") : std::string();
  const std::string place = "--filename=" + folder + "/";
  std::vector<const char*> command;
  if (!zenity.empty())
  {
    command = { zenity.c_str(), "--file-selection", "--title=Open a volume", place.c_str() };
  }
  else if (!kdialog.empty())
  {
    command = { kdialog.c_str(), "--title", "Open a volume", "--getopenfilename", folder.c_str() };
  }
  else
  {
    return false;
  }
  command.push_back(nullptr);
  this->Close();
  this->Process = vtksysProcess_New();
  vtksysProcess_SetCommand(this->Process, command.data());
  vtksysProcess_Execute(this->Process);
  return true;
}

std::string FileDialog::Poll()
{
  while (this->Process)
  {
    char* data = nullptr;
    int length = 0;
    double patience = 1e-6; // s
    const int from = vtksysProcess_WaitForData(this->Process, &data, &length, &patience);
    if (from == vtksysProcess_Pipe_Timeout)
    {
      return {};
    }
    if (from == vtksysProcess_Pipe_STDOUT)
    {
      this->Output.append(data, static_cast<std::size_t>(length));
    }
    if (from == vtksysProcess_Pipe_None)
    {
      const std::string path = this->Output.substr(0, this->Output.find_first_of("\r\n"));
      this->Close();
      return path;
    }
  }
  return {};
}

void FileDialog::Close()
{
  if (this->Process)
  {
    vtksysProcess_Delete(this->Process); // ends the process, too
  }
  this->Process = nullptr;
  this->Output.clear();
}
} // namespace Explore
