// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the user's device file: written facts are read back, other lines stay unchanged, and damage
 * is reported.
 */

#include "Devices/Common/DeviceMemory.h"
#include "Rigs/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#if !defined(_WIN32)
#include <sys/stat.h>
#endif

using VolumeHaptics::DeviceFacts;
using VolumeHaptics::DeviceMemory;

namespace
{
class Memory : public testing::Test
{
protected:
  Memory() { setenv("VOLUMEHAPTICS_DEVICES", this->File.c_str(), 1); }
  ~Memory() override { std::filesystem::remove(this->File); }
  void Fill(const std::string& text) { std::ofstream(this->File) << text; }
  std::string GetText() const
  {
    std::ostringstream text;
    text << std::ifstream(this->File).rdbuf();
    return text.str();
  }
  DeviceFacts Read(const std::string& identity)
  {
    return DeviceMemory::Read(identity, this->Error);
  }

  const std::string File = TemporaryPath("devices/of this user.txt");
  std::string Error;
};
} // namespace

TEST_F(Memory, KnowsNothingWithoutAFile)
{
  const DeviceFacts facts = this->Read("falcon");
  EXPECT_EQ(this->Error, "");
  EXPECT_EQ(facts.Confirmed, "");
  EXPECT_EQ(facts.Scale, 1.0);
  EXPECT_EQ(facts.DescribeScale(), "uncalibrated");
}

TEST_F(Memory, WhatIsWrittenComesBackAndOtherLinesStay)
{
  DeviceFacts falcon;
  falcon.Confirmed = "2026-11-22";
  ASSERT_TRUE(DeviceMemory::Write("falcon", falcon, this->Error)) << this->Error;
  DeviceFacts wooden = falcon;
  wooden.Scale = 0.83;
  wooden.Calibrated = "2026-11-20";
  // a serial number with unusual characters
  const std::string identity = "wooden:1234:0006:A #1% B";
  ASSERT_TRUE(DeviceMemory::Write(identity, wooden, this->Error)) << this->Error;
  falcon.Confirmed = "2026-12-01";
  ASSERT_TRUE(DeviceMemory::Write("falcon", falcon, this->Error)) << this->Error;

  EXPECT_EQ(this->Read("falcon").Confirmed, "2026-12-01");
  EXPECT_EQ(this->Read(identity).Scale, 0.83);
  EXPECT_EQ(this->Read(identity).DescribeScale(), "calibrated 0.83 on 2026-11-20");
  EXPECT_EQ(this->Read("wooden:1234:0006:A").Confirmed, "");
  EXPECT_EQ(this->Error, "");
  const std::string text = this->GetText();
  EXPECT_EQ(text.find("falcon"), text.rfind("falcon")) << text;
  EXPECT_EQ(text[0], '#') << text;
  int files = 0;
  const std::filesystem::path folder = std::filesystem::path(this->File).parent_path();
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(files, 1) << "nothing temporary stays";
}

TEST_F(Memory, ADamagedLineCountsAsNoneAndIsTold)
{
  std::filesystem::create_directories(std::filesystem::path(this->File).parent_path());
  for (const char* const damage : { "confirmed=yesterday", "scale=0.0",
         "scale=11 calibrated=2026-11-20", "scale=nan calibrated=2026-11-20", "scale=0.83",
         "confirmed", "confirmed=2026-11-2", "size=3", "scale=0,83 calibrated=2026-11-20" })
  {
    this->Fill(std::string("# mine\nfalcon ") + damage + "\nwooden confirmed=2026-11-01\n\xff\n");
    const DeviceFacts facts = this->Read("falcon");
    EXPECT_EQ(facts.Confirmed, "") << damage;
    EXPECT_EQ(facts.Scale, 1.0) << damage;
    EXPECT_NE(this->Error.find("Line 2 of the file of devices \"" + this->File), std::string::npos)
      << damage << ": " << this->Error;
    EXPECT_EQ(this->Read("wooden").Confirmed, "2026-11-01") << damage;
    EXPECT_EQ(this->Error, "") << "not of this device";
  }
  // Confirming the device again repairs its line. The rest of the file stays unchanged.
  DeviceFacts facts;
  facts.Confirmed = "2026-11-22";
  ASSERT_TRUE(DeviceMemory::Write("falcon", facts, this->Error)) << this->Error;
  EXPECT_EQ(
    this->GetText(), "# mine\nwooden confirmed=2026-11-01\n\xff\nfalcon confirmed=2026-11-22\n");
}

/// Expects that Write() does not follow a link whose name is that of an earlier version's temporary
/// file.
#if !defined(_WIN32) // users can't make such links there
TEST_F(Memory, IsWrittenThroughNoLinkThatSomebodyLaid)
{
  const std::string other = TemporaryPath("other");
  std::ofstream(other) << "mine";
  std::filesystem::create_directories(std::filesystem::path(this->File).parent_path());
  const std::string link = this->File + ".part" + std::to_string(getpid());
  std::filesystem::create_symlink(other, link);
  EXPECT_TRUE(DeviceMemory::Write("falcon", {}, this->Error)) << this->Error;
  std::ostringstream text;
  text << std::ifstream(other).rdbuf();
  EXPECT_EQ(text.str(), "mine");
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(this->File)));
  std::filesystem::remove(link);
}
#endif

TEST_F(Memory, AFileThatCannotBeWrittenIsTold)
{
  std::filesystem::create_directories(this->File);
  EXPECT_FALSE(DeviceMemory::Write("falcon", {}, this->Error));
  EXPECT_NE(this->Error.find(this->File), std::string::npos) << this->Error;
  std::filesystem::remove_all(this->File);
}

/// Expects an error for files that would block or never end: a pipe, a device, a large file.
#if !defined(_WIN32)
TEST_F(Memory, WaitsForNoPipeAndReadsNoDevice)
{
  std::filesystem::create_directories(std::filesystem::path(this->File).parent_path());
  ASSERT_EQ(mkfifo(this->File.c_str(), 0600), 0);
  const std::string large = TemporaryPath("large");
  std::ofstream(large) << "falcon confirmed=2026-11-22\n";
  std::filesystem::resize_file(large, (1 << 20) + 1);
  for (const std::string& file : { this->File, std::string("/dev/zero"), large })
  {
    setenv("VOLUMEHAPTICS_DEVICES", file.c_str(), 1);
    EXPECT_EQ(this->Read("falcon").Confirmed, "");
    EXPECT_NE(this->Error.find("\"" + file + "\""), std::string::npos) << this->Error;
    EXPECT_NE(this->Error.find("at most 1 MiB"), std::string::npos) << this->Error;
    EXPECT_FALSE(DeviceMemory::Write("falcon", {}, this->Error)) << file;
    EXPECT_NE(this->Error.find("at most 1 MiB"), std::string::npos) << this->Error;
  }
  std::filesystem::remove(large);
}
#endif

TEST_F(Memory, IsInTheFolderForSettingsOfTheUser)
{
  unsetenv("VOLUMEHAPTICS_DEVICES");
#if defined(_WIN32)
  setenv("APPDATA", "C:\\Zoë", 1);
  EXPECT_EQ(DeviceMemory::FindFile(), "C:\\Zo\xC3\xAB/volumehaptics/devices.txt");
#else
  setenv("XDG_CONFIG_HOME", "/config", 1);
  EXPECT_EQ(DeviceMemory::FindFile(), "/config/volumehaptics/devices.txt");
  unsetenv("XDG_CONFIG_HOME");
  setenv("HOME", "/home/anna", 1);
  EXPECT_EQ(DeviceMemory::FindFile(), "/home/anna/.config/volumehaptics/devices.txt");
#endif
  EXPECT_EQ(DeviceMemory::GetToday().size(), 10u);
}
