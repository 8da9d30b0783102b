// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that ticks neither allocate nor lock, whatever happens around them.
 */

#include "Rigs/PlayedDevice.h"
#include "Rigs/ThreadWatch.h"

using namespace servotest;

namespace
{
struct WatchedDevice : PlayedDevice
{
  // From the tenth tick on, monitors all calls of the servo's thread, including those around
  // Read().
  void InTick() noexcept override { WatchThisThread(this->Reads.load() > 10); }
};
} // namespace

TEST(ServoQuiet, NoTickAllocatesOrLocks)
{
  WatchedDevice device;
  TestVolume volume = MakeRamp();
  HapticModelDescription d = Describe(volume);
  d.Material.Friction = ConstantPolyline(0.3);
  d.Material.Viscosity = ConstantPolyline(0.2);
  RunningLoop loop(device);
  const auto wait = [&](std::uint64_t ticks)
  {
    const std::uint64_t end = loop->GetTickCount() + ticks;
    EXPECT_TRUE(Eventually([&] { return loop->GetTickCount() > end; }));
  };
  ServoSnapshot s;
  for (int i = 0; i < 40; ++i)
  {
    d.Settings.Method = i % 3 == 2 ? HapticMethod::ForceField : HapticMethod::Proxy;
    loop->Publish(i % 8 == 7 ? nullptr : std::make_shared<const HapticModel>(d));
    i % 5 == 4 ? loop->Disarm() : loop->Arm();
    loop->SetRecording(i % 2 == 0);
    loop->SetLimits(QuickLimits());
    i % 6 == 5 ? loop->ResetStatistics() : void();
    device.Frozen.store(i % 9 == 8);
    device.ReadLost.store(i % 10 == 9);
    wait(100);
    while (loop->Drain(s))
    {
    }
    loop->ReadState();
  }
  device.ReadLost.store(false);
  loop->Arm();
  wait(4000);
  EXPECT_GT(device.LargestForce.load(), 0.5);
  const Watched watched = GetWatched();
  EXPECT_EQ(watched.Allocations, 0U);
  EXPECT_EQ(watched.Locks, 0U);
}

// Tests the monitor itself: if it counted nothing, the test above would pass.
TEST(ThreadWatch, SeesAllocationsAndLocksOfItsThreadOnly)
{
  const auto work = []
  {
    std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    void* const memory = ::operator new(100);
    ::operator delete(memory);
  };
  const Watched before = GetWatched();
  std::thread other(work);
  other.join();
  EXPECT_EQ(GetWatched().Allocations, before.Allocations);
  std::thread watched(
    [&]
    {
      WatchThisThread(true);
      work();
      WatchThisThread(false);
      work();
    });
  watched.join();
  EXPECT_EQ(GetWatched().Allocations, before.Allocations + 1);
  EXPECT_EQ(GetWatched().Locks, before.Locks + (CanSeeLocks() ? 1 : 0));
}
