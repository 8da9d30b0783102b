// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a running loop locks the memory that it uses, but no memory of a volume that is
 * mapped from a file. The tests use numbers of the kernel: mincore(2), and VmLck in
 * /proc/self/status.
 */

#include "Core/Realtime/MemoryLock.h"
#include "Rigs/MappedFile.h"
#include "Rigs/PlayedDevice.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace servotest;

TEST(ServoMemory, AMappedVolumeStaysInItsFile)
{
  const std::size_t before = LockedBytes();
  MappedFile file(std::size_t{ 1 } << 30);
  {
    PlayedDevice device;
    RunningLoop loop(device, 1000.0);
    TestVolume volume(
      ScalarType::Int16, { 1024, 1024, 512 }, 1, static_cast<std::byte*>(file.Begin));
    auto model = std::make_shared<HapticModel>(Describe(volume));
    loop->Publish(model);
    ASSERT_TRUE(Eventually([&] { return loop->GetAcknowledged() == 1; }));
    const std::uint64_t ticks = loop->GetTickCount();
    ASSERT_TRUE(Eventually([&] { return loop->GetTickCount() > ticks + 50; }));
    EXPECT_LT(file.Resident(), file.Size / 10) << "no more than what the tip has read";
    const std::size_t locked = LockedBytes() - before;
    // Most of the locked memory is the ring of 2^14 ticks with some 1.2 kB each.
    EXPECT_LT(locked, std::size_t{ 32 } << 20);
    const bool granted = loop->GetLockedMemory() == ServoLoop::Privilege::Granted;
    EXPECT_TRUE(!granted || !CanLock || locked > sizeof(ServoLoop)) << locked << " bytes";
  }
  EXPECT_EQ(LockedBytes(), before);
  EXPECT_LT(file.Resident(), file.Size / 10);
}

TEST(ServoMemory, ALoopThatEndsLeavesTheLocksOfOthers)
{
  const std::size_t before = LockedBytes();
  PlayedDevice first;
  auto loop = std::make_unique<RunningLoop>(first, 1000.0);
  ASSERT_TRUE(Eventually([&] { return (*loop)->GetTickCount() > 0; }));
  const std::size_t alone = LockedBytes();
  {
    PlayedDevice second;
    RunningLoop other(second, 1000.0);
    ASSERT_TRUE(Eventually([&] { return other->GetTickCount() > 0; }));
    EXPECT_GE(LockedBytes(), alone);
  }
  EXPECT_EQ(LockedBytes(), alone);
  loop.reset();
  EXPECT_EQ(LockedBytes(), before);
}

TEST(ServoMemory, SharedPagesStayLockedUntilTheLastLockIsGone)
{
  const std::size_t before = LockedBytes();
  std::vector<char> memory(8 * PageSize);
  // Begin in the middle of a page, so that two neighbouring ranges share a page.
  char* const at = memory.data() + PageSize / 2;
  auto first = std::make_unique<MemoryLock>();
  if (!CanLock || !first->Add(at, 2 * PageSize))
  {
    GTEST_SKIP() << "memory can't be locked here";
  }
  const std::size_t one = LockedBytes() - before;
  EXPECT_GE(one, 2 * PageSize);
  EXPECT_LE(one, 3 * PageSize);
  auto second = std::make_unique<MemoryLock>();
  ASSERT_TRUE(second->Add(at + PageSize, 3 * PageSize));
  ASSERT_TRUE(second->Add(at, 1)); // locks the same page a second time
  const std::size_t both = LockedBytes() - before;
  EXPECT_GE(both, 4 * PageSize);
  first.reset();
  EXPECT_GE(LockedBytes() - before, 3 * PageSize) << "of the second";
  EXPECT_LE(LockedBytes(), before + both);
  second.reset();
  EXPECT_EQ(LockedBytes(), before);
}

TEST(ServoMemory, RangesOfAnArrayGoTogetherAndLeaveTheLocksOfOthers)
{
  constexpr std::size_t pages = 40;
  char* const array = static_cast<char*>(
    mmap(nullptr, pages * PageSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  const std::size_t before = LockedBytes();
  const auto lockRows = [array]
  {
    auto rows = std::make_unique<MemoryLock>(true);
    bool isLocked = CanLock;
    for (std::size_t row = 0; row < pages; row += 10)
    {
      isLocked = isLocked && rows->Add(array + row * PageSize, 2 * PageSize);
    }
    return isLocked ? std::move(rows) : nullptr;
  };
  auto rows = lockRows();
  if (!rows)
  {
    munmap(array, pages * PageSize);
    GTEST_SKIP() << "memory can't be locked here";
  }
  EXPECT_EQ(LockedBytes() - before, 8 * PageSize);
  auto others = std::make_unique<MemoryLock>();
  ASSERT_TRUE(others->Add(array + 15 * PageSize, PageSize)); // in the gap between two rows
  ASSERT_TRUE(others->Add(array + 20 * PageSize, PageSize)); // within a row
  rows.reset();
  EXPECT_EQ(LockedBytes() - before, 2 * PageSize) << "of the other lock";
  others.reset();
  EXPECT_EQ(LockedBytes(), before);
  // The program may have unmapped a part of the array before the lock ends.
  rows = lockRows();
  ASSERT_NE(rows, nullptr);
  munmap(array + 5 * PageSize, PageSize);
  rows.reset();
  EXPECT_EQ(LockedBytes(), before);
  munmap(array, pages * PageSize);
}

TEST(ServoMemory, WhatIsNotThereIsRefusedAndLeavesNothingLocked)
{
  const std::size_t before = LockedBytes();
  char* const hole = static_cast<char*>(
    mmap(nullptr, 4 * PageSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  munmap(hole + 2 * PageSize, PageSize);
  {
    MemoryLock lock;
    EXPECT_TRUE(!CanLock || !lock.Add(hole, 4 * PageSize));
    EXPECT_EQ(LockedBytes(), before);
    EXPECT_TRUE(lock.Add(hole, 0));
    EXPECT_TRUE(lock.AddStack(std::size_t{ 1 } << 16) || LockedBytes() == before);
  }
  EXPECT_EQ(LockedBytes(), before);
  munmap(hole, 4 * PageSize);
}

TEST(ServoMemory, AForkedChildHasLocksOfItsOwn)
{
  std::vector<char> memory(64 * PageSize);
  // Runs `body` in a child process. Returns the child's exit status, or minus the number of the
  // signal that ended it.
  const auto inChild = [](auto&& body)
  {
    const pid_t child = fork();
    if (child == 0)
    {
      alarm(30);
      _exit(body());
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
  };
  auto inherited = std::make_unique<MemoryLock>();
  if (!CanLock || !inherited->Add(memory.data(), memory.size()))
  {
    GTEST_SKIP() << "memory can't be locked here";
  }
  EXPECT_EQ(inChild(
              [&]
              {
                {
                  MemoryLock own;
                  own.Add(memory.data(), memory.size());
                }
                return LockedBytes() == 0 ? 0 : 1;
              }),
    0);
  EXPECT_EQ(inChild(
              [&]
              {
                auto own = std::make_unique<MemoryLock>();
                const bool isLocked = own->Add(memory.data(), memory.size()) &&
                  inherited->Add(memory.data(), PageSize) && LockedBytes() >= memory.size();
                own.reset();
                const bool isKept = LockedBytes() > 0;
                inherited.reset();
                return isLocked && isKept && LockedBytes() == 0 ? 0 : 1;
              }),
    0);
  // Another thread may be locking memory at the time of the fork. This thread does not exist in the
  // child.
  std::atomic<bool> isOver{ false };
  std::thread other(
    [&]
    {
      while (!isOver)
      {
        MemoryLock lock;
        lock.Add(memory.data(), memory.size());
      }
    });
  int result = 0;
  for (int i = 0; i < 30 && result == 0; ++i)
  {
    result = inChild(
      [&]
      {
        MemoryLock lock;
        return lock.Add(memory.data(), PageSize) ? 0 : 1;
      });
  }
  isOver = true;
  other.join();
  EXPECT_EQ(result, 0);
}
