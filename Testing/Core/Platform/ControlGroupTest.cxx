// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the computation of the memory that a control group leaves. The test writes folders with the
 * layouts of both kernel interfaces (Documentation/admin-guide/cgroup-v1/memory.rst and
 * cgroup-v2.rst of Linux).
 */

#include "Core/Platform/ControlGroup.h"
#include "Rigs/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using VolumeHaptics::ReadGroupMemory;

namespace
{
class ControlGroup : public testing::Test
{
protected:
  ~ControlGroup() override { std::filesystem::remove_all(this->Root); }
  void Write(const std::string& file, const std::string& text) const
  {
    const std::filesystem::path path = this->Root + "/" + file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text << "\n";
  }
  double Read() const { return ReadGroupMemory(this->Root + "/groups", this->Root); }

  const std::string Root = TemporaryPath("groups");
};
} // namespace

TEST_F(ControlGroup, WithoutALimitLeavesAll)
{
  EXPECT_TRUE(std::isinf(this->Read())) << "no control groups";
  this->Write("groups", "0::/user/app");
  EXPECT_TRUE(std::isinf(this->Read())) << "none that is seen here";
  this->Write("user/app/memory.max", "max");
  this->Write("user/app/memory.current", "1000");
  EXPECT_TRUE(std::isinf(this->Read()));
}

TEST_F(ControlGroup, LeavesWhatIsNotUsedButForCachedFiles)
{
  this->Write("groups", "0::/user/app");
  this->Write("user/app/memory.max", "1000000");
  this->Write("user/app/memory.current", "700000");
  this->Write("user/app/memory.stat", "anon 500000\ninactive_file 50000\nactive_file 100000");
  EXPECT_EQ(this->Read(), 350000.0);
  this->Write("user/app/memory.current", "1200000");
  EXPECT_EQ(this->Read(), 0.0);
}

TEST_F(ControlGroup, IsLimitedByThoseAboveIt)
{
  this->Write("groups", "0::/user/app/inner");
  this->Write("user/app/inner/memory.max", "max");
  this->Write("user/app/inner/memory.current", "100");
  this->Write("user/memory.max", "3000");
  this->Write("user/memory.current", "2000");
  EXPECT_EQ(this->Read(), 1000.0);
  // A container sees its own group as the root, whatever path its processes report.
  this->Write("memory.max", "900");
  this->Write("memory.current", "100");
  EXPECT_EQ(this->Read(), 800.0);
}

TEST_F(ControlGroup, OfTheFirstVersionIsRead)
{
  this->Write("groups", "5:cpu,cpuacct:/a\n4:memory:/box/app\n0::/");
  this->Write("memory/box/app/memory.limit_in_bytes", "5000");
  this->Write("memory/box/app/memory.usage_in_bytes", "1500");
  this->Write("memory/box/app/memory.stat", "cache 1\ninactive_file 2\ntotal_inactive_file 300");
  this->Write("memory/memory.limit_in_bytes", "9223372036854771712"); // means no limit
  this->Write("memory/memory.usage_in_bytes", "8000");
  EXPECT_EQ(this->Read(), 3800.0);
}
