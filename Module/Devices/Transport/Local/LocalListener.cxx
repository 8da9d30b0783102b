// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Local/LocalListener.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#if defined(__linux__)
#include <unistd.h>
#endif

namespace VolumeHaptics
{

std::optional<unsigned> FindOtherListener(std::istream& table, std::uint16_t port, unsigned own)
{
  constexpr unsigned firstPerson = 1000; // first number of a human user on Debian and Fedora
  constexpr unsigned hidden = 65534;
  std::string line;
  while (std::getline(table, line))
  {
    std::istringstream words(line);
    std::string number, local, remote, state, queues, timer, tries;
    unsigned user = 0;
    const bool isRow = static_cast<bool>(
      words >> number >> local >> remote >> state >> queues >> timer >> tries >> user);
    const std::size_t colon = local.rfind(':');
    const bool isListener = isRow && state == "0A" && colon != std::string::npos &&
      std::strtoul(local.c_str() + colon + 1, nullptr, 16) == port;
    if (isListener && user >= firstPerson && user != hidden && user != own)
    {
      return user;
    }
  }
  return {};
}

bool IsOwnListener([[maybe_unused]] std::uint16_t port, [[maybe_unused]] std::string& error)
{
#if defined(__linux__)
  for (const char* const name : { "/proc/net/tcp", "/proc/net/tcp6" })
  {
    std::ifstream table(name);
    if (const std::optional<unsigned> user = FindOtherListener(table, port, geteuid()))
    {
      error = "The program at port " + std::to_string(port) + " belongs to another user (number " +
        std::to_string(*user) + "), so it was not contacted. ";
      return false;
    }
  }
#endif
  return true;
}

bool ReadPort(const std::string& text, std::uint16_t& port)
{
  const bool isNumber = !text.empty() && text.size() < 6 &&
    std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int number = isNumber ? std::atoi(text.c_str()) : 0;
  port = static_cast<std::uint16_t>(number);
  return number > 0 && number < 65536;
}

} // namespace VolumeHaptics
