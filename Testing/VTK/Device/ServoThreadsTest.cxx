// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that another thread sends zero force to the device of a hanging loop, and that a loop whose
 * processor is busy is woken on another processor.
 */

#include "VTK/Device/ServoThreads.h"
#include "Rigs/BusyThreads.h"
#include "Rigs/Eventually.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#if defined(__linux__)
#include "Rigs/Processors.h"

#include <pthread.h>
#endif

using namespace VolumeHaptics;
using devicetest::Eventually;

namespace
{
class HangingDevice;
/// Devices that this thread has quenched, in order. Keepers quench in their own threads, so their
/// devices are not in this list.
thread_local std::vector<const HangingDevice*> Quenched;

/// A device whose Read() hangs while `Hangs` is true.
class HangingDevice : public DeviceBackend
{
public:
  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "hanging"; }
  DeviceLimits GetLimits() const override { return {}; }
  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    while (this->Hangs.load())
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    this->Reads.fetch_add(1);
    sample.Fresh = true;
    return DeviceState::Running;
  }
  DeviceState Write(const Vector3&) noexcept override { return DeviceState::Running; }
  void Quench() noexcept override
  {
    this->Quenches.fetch_add(1);
    Quenched.push_back(this);
  }

  std::atomic<bool> Hangs{ false };
  std::atomic<int> Reads{ 0 };
  std::atomic<int> Quenches{ 0 };
};

#if defined(__linux__)
/// A device whose thread has the lowest priority, so that it waits for all other threads on its
/// processor.
class LowlyDevice : public HangingDevice
{
public:
  DeviceState Read(double time, DeviceSample& sample) noexcept override
  {
    // Set the priority in each tick, because RealtimeKit may have raised it after the last tick.
    const sched_param none{};
    EXPECT_EQ(pthread_setschedparam(pthread_self(), SCHED_IDLE, &none), 0);
    return HangingDevice::Read(time, sample);
  }
};
#endif

} // namespace

TEST(ServoThreads, QuenchesALoopThatIsSilentAndGoesOnAfterIt)
{
  HangingDevice device;
  ServoThreads servo(device, 1000.0, SafetyLimits{}, nullptr);
  ASSERT_TRUE(Eventually([&] { return device.Reads.load() > 20; }));
  device.Hangs.store(true);
  const int before = device.Quenches.load();
  EXPECT_TRUE(Eventually([&] { return device.Quenches.load() > before + 5; }));
  device.Hangs.store(false);
  const int reads = device.Reads.load();
  EXPECT_TRUE(Eventually([&] { return device.Reads.load() > reads + 20; }));
}

TEST(ServoThreads, QuenchOfAHangingLoopReturns)
{
  HangingDevice device;
  ServoThreads servo(device, 1000.0, SafetyLimits{}, nullptr);
  ASSERT_TRUE(Eventually([&] { return device.Reads.load() > 20; }));
  servo.GetLoop().Arm();
  device.Hangs.store(true);
  ServoThreads::Quench({ &servo });
  EXPECT_GE(device.Quenches.load(), 2) << "before and after the wait for the loop";
  device.Hangs.store(false);
  EXPECT_TRUE(Eventually(
    [&] { return servo.GetLoop().ReadState() && !servo.GetLoop().GetState().IsArmed(); }));
}

TEST(ServoThreads, QuenchTellsAllBeforeItWaitsForOne)
{
  HangingDevice devices[3];
  std::vector<std::unique_ptr<ServoThreads>> servos;
  std::vector<ServoThreads*> all;
  for (HangingDevice& device : devices)
  {
    device.Hangs.store(&device != &devices[2]); // all devices but the last one hang
    servos.push_back(std::make_unique<ServoThreads>(device, 1000.0, SafetyLimits{}, nullptr));
    all.push_back(servos.back().get());
  }
  ASSERT_TRUE(Eventually([&] { return devices[2].Reads.load() > 20; }));
  Quenched.clear();
  ServoThreads::Quench(all);
  ASSERT_GE(Quenched.size(), 6U) << "each before and after the wait";
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(Quenched[i], &devices[i]);
    devices[i].Hangs.store(false);
  }
}

#if defined(__linux__)
TEST(ServoThreads, WakeALoopThatWaitsForItsProcessor)
{
  cpu_set_t processors;
  if (!devicetest::MayChooseProcessor(processors))
  {
    GTEST_SKIP() << "This process can't choose among processors.";
  }
  LowlyDevice device;
  ServoThreads servo(device, 1000.0, SafetyLimits{}, nullptr);
  ASSERT_TRUE(Eventually([&] { return device.Reads.load() > 0; }));
  const devicetest::BusyThreads busy(static_cast<unsigned>(CPU_COUNT(&processors)) + 1);
  EXPECT_TRUE(Eventually([&] { return servo.GetLoop().GetRescues() > 5; }));
}
#endif
