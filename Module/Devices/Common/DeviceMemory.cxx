// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/DeviceMemory.h"

#include "Core/Math/NumberText.h"
#include "Core/Platform/Files.h"
#include "Core/Platform/SmallFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <locale>
#include <optional>
#include <sstream>
#include <vector>

namespace VolumeHaptics
{
namespace
{

constexpr const char* Header =
  "# Devices of VTK Volume Haptics: volumehaptics-device confirm and calibrate write this file.";

bool ReadNumber(const std::string& text, double& number)
{
  const std::optional<double> read = ParseNumber(text);
  number = read.value_or(number);
  return read && std::isfinite(number);
}

std::string WriteNumber(double number)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(4);
  out << number;
  return out.str();
}

/** Returns an identity with its spaces replaced, because spaces separate the words of a line. */
std::string MakeWord(const std::string& identity)
{
  std::string word;
  for (const char c : identity)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > ' ' && byte < 0x7f && c != '%' && c != '#')
    {
      word += c;
    }
    else
    {
      char code[4];
      std::snprintf(code, sizeof(code), "%%%02X", byte);
      word += code;
    }
  }
  return word;
}

bool IsDay(const std::string& text)
{
  if (text.size() != 10)
  {
    return false;
  }
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isDash = i == 4 || i == 7;
    if (isDash ? text[i] != '-' : !std::isdigit(static_cast<unsigned char>(text[i])))
    {
      return false;
    }
  }
  return true;
}

/** Parses the facts in a line. Returns false if the line contains anything else. */
bool ReadFacts(std::istringstream& words, DeviceFacts& facts)
{
  std::string word;
  while (words >> word)
  {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (name == "confirmed" && IsDay(value))
    {
      facts.Confirmed = value;
    }
    else if (name == "calibrated" && IsDay(value))
    {
      facts.Calibrated = value;
    }
    else if (name != "scale" || !ReadNumber(value, facts.Scale) ||
      !(facts.Scale >= DeviceFacts::LeastScale && facts.Scale <= DeviceFacts::MostScale))
    {
      return false;
    }
  }
  // false if the line is incomplete: a scale without the day of calibration
  return !facts.Calibrated.empty() || facts.Scale == 1.0;
}

std::string MakeLine(const std::string& word, const DeviceFacts& facts)
{
  std::string line = word;
  line += facts.Confirmed.empty() ? "" : " confirmed=" + facts.Confirmed;
  if (!facts.Calibrated.empty())
  {
    line += " scale=" + WriteNumber(facts.Scale) + " calibrated=" + facts.Calibrated;
  }
  return line;
}

/**
 * Reads the lines of a file; a missing file has no lines. Returns false and writes the reason to
 * `error` if the file can't be read.
 */
bool ReadLines(const std::string& file, std::vector<std::string>& lines, std::string& error)
{
  constexpr std::size_t most = 1 << 20; // bytes: thousands of devices
  std::string text;
  const std::string fault = file.empty() ? NoSuchFile : ReadSmallFile(file, most, text);
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line))
  {
    lines.push_back(line);
  }
  if (!fault.empty() && fault != NoSuchFile)
  {
    error = "The file of devices \"" + file + "\" " + fault +
      ". Check that it is a text file of at most 1 MiB that you may read, or set "
      "VOLUMEHAPTICS_DEVICES to the name of another file.";
    return false;
  }
  return true;
}

std::string FirstWord(const std::string& line)
{
  std::istringstream words(line);
  std::string word;
  words >> word;
  return word;
}

} // namespace

std::string DeviceFacts::DescribeScale() const
{
  return this->Calibrated.empty()
    ? "uncalibrated"
    : "calibrated " + WriteNumber(this->Scale) + " on " + this->Calibrated;
}

std::string DeviceMemory::FindFile()
{
  const std::string own = Files::GetVariable("VOLUMEHAPTICS_DEVICES");
  if (!own.empty())
  {
    return own;
  }
  const std::string folder = Files::GetSettingsFolder();
  return folder.empty() ? folder : folder + "/volumehaptics/devices.txt";
}

std::string DeviceMemory::GetToday()
{
  const std::time_t now = std::time(nullptr);
  std::tm day{};
#if defined(_WIN32)
  localtime_s(&day, &now);
#else
  localtime_r(&now, &day);
#endif
  char text[16];
  const std::size_t size = std::strftime(text, sizeof(text), "%Y-%m-%d", &day);
  return std::string(text, size);
}

DeviceFacts DeviceMemory::Read(const std::string& identity, std::string& error)
{
  error.clear();
  const std::string file = FindFile();
  std::vector<std::string> lines;
  if (!ReadLines(file, lines, error))
  {
    return {};
  }
  const std::string wanted = MakeWord(identity);
  DeviceFacts found;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    std::istringstream words(lines[i]);
    std::string word;
    if (!(words >> word) || word != wanted)
    {
      continue;
    }
    DeviceFacts facts;
    if (ReadFacts(words, facts))
    {
      found = facts; // the last line of a device is the valid one
    }
    else
    {
      found = {};
      error = "Line " + std::to_string(i + 1) + " of the file of devices \"" + file +
        "\" is damaged: the device counts as unconfirmed and uncalibrated. Remove the line, then "
        "confirm and calibrate the device again (volumehaptics-device).";
    }
  }
  return found;
}

bool DeviceMemory::Write(const std::string& identity, const DeviceFacts& facts, std::string& error)
{
  const std::string file = FindFile();
  if (file.empty())
  {
    error = "There is no folder for the file of devices: set HOME, or VOLUMEHAPTICS_DEVICES to the "
            "name of a file.";
    return false;
  }
  std::vector<std::string> lines;
  if (!ReadLines(file, lines, error))
  {
    return false;
  }
  const std::string word = MakeWord(identity);
  if (lines.empty())
  {
    lines.push_back(Header);
  }
  std::error_code trouble;
  const std::filesystem::path folder = Files::ToPath(file).parent_path();
  if (!folder.empty())
  {
    std::filesystem::create_directories(folder, trouble);
  }
  std::ostringstream text;
  for (const std::string& line : lines)
  {
    if (FirstWord(line) != word)
    {
      text << line << "\n";
    }
  }
  text << MakeLine(word, facts) << "\n";
  // Create a new file, so that an attacker's link with the name of the file is not followed.
  std::string temporary;
  constexpr Files::Mode onlyThisUser = 0600;
  const int descriptor = Files::CreateBeside(file, onlyThisUser, temporary);
  if (descriptor >= 0)
  {
    const std::string all = text.str();
    std::size_t done = 0;
    for (std::int64_t size = 1; size > 0 && done < all.size();)
    {
      size = Files::Write(descriptor, all.data() + done, all.size() - done);
      done += static_cast<std::size_t>(std::max<std::int64_t>(size, 0));
    }
    if (Files::CloseWritten(descriptor) && done == all.size() && Files::Rename(temporary, file))
    {
      return true;
    }
    Files::Remove(temporary);
  }
  error = "The file of devices \"" + file +
    "\" can't be written, so that this is forgotten. Check the permissions of its folder and the "
    "space on its disk, or set VOLUMEHAPTICS_DEVICES to the name of another file.";
  return false;
}

} // namespace VolumeHaptics
