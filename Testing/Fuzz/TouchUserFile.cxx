// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchUserFile.h"

#include "Dealer.h"
#include "Devices/Common/DeviceMemory.h"
#include "Devices/Falcon/FalconFirmware.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

using namespace VolumeHaptics;

namespace
{
/** A file in memory that is removed when the process ends. */
struct File
{
  File()
  {
    const char* const shared = "/dev/shm";
    std::string name =
      (std::filesystem::exists(shared) ? shared : "/tmp") + std::string("/fuzz-XXXXXX");
    Check(mkdtemp(name.data()) != nullptr, "a folder can be made");
    this->Folder = name;
    this->Name = name + "/file";
    setenv("VOLUMEHAPTICS_DEVICES", this->Name.c_str(), 1);
  }
  ~File() { std::filesystem::remove_all(this->Folder); }

  std::string Folder, Name;
};

void TouchFirmware(const std::string& name, const std::string& bytes)
{
  std::vector<std::uint8_t> image;
  std::string error;
  const bool mayBeImage = bytes.size() >= 1024 && bytes.size() <= 131072;
  Check(ReadFalconFirmware(name, image, error) == mayBeImage, "the size decides");
  Check(mayBeImage || error.find("--firmware") != std::string::npos, "a refusal has its cure");
  Check(std::string(image.begin(), image.end()) == (mayBeImage ? bytes : ""), "no byte changes");
}

DeviceFacts Read(const std::string& identity)
{
  std::string error;
  const DeviceFacts facts = DeviceMemory::Read(identity, error);
  Check(facts.Scale >= 0.1 && facts.Scale <= 10.0, "a scale has its limits");
  Check(facts.Confirmed.empty() || facts.Confirmed.size() == 10, "a day is one");
  Check(facts.Scale == 1.0 || facts.Calibrated.size() == 10, "a scale has its day");
  Check(error.empty() || error.find("onfirm") != std::string::npos, "damage has its cure");
  return facts;
}

bool AreEqual(const DeviceFacts& first, const DeviceFacts& second)
{
  // Compare scales with a tolerance, since the file stores four digits.
  return first.Confirmed == second.Confirmed && first.Calibrated == second.Calibrated &&
    std::abs(first.Scale - second.Scale) <= 1e-3 * first.Scale;
}

void TouchMemory(const std::string& bytes)
{
  // Also read the facts of the device that the file's first word names, because random bytes rarely
  // match a known identity.
  const std::string first = bytes.substr(0, bytes.find_first_of(" \t\n\v\f\r"));
  const std::string other = "wooden:1234:0006:A #1% B";
  for (const std::string& identity : { std::string("falcon"), first })
  {
    if (identity.empty())
    {
      continue; // every device has an identity
    }
    DeviceFacts facts = Read(identity);
    const DeviceFacts before = Read(other);
    std::string error;
    Check(DeviceMemory::Write(identity, facts, error), error.c_str());
    Check(AreEqual(Read(identity), facts), "what is written comes back");
    facts.Confirmed = "2026-11-30";
    facts.Calibrated = facts.Confirmed;
    facts.Scale = 0.83;
    Check(DeviceMemory::Write(identity, facts, error), error.c_str());
    Check(AreEqual(Read(identity), facts), "what is written anew comes back");
    Check(identity == other || AreEqual(Read(other), before), "other devices keep their facts");
  }
}
} // namespace

void TouchUserFile(const std::uint8_t* bytes, std::size_t size)
{
  static const File file;
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  std::ofstream(file.Name, std::ios::binary) << text;
  TouchFirmware(file.Name, text);
  TouchMemory(text);
}
