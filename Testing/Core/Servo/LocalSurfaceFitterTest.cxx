// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the method LocalSurface in a running loop. The slow thread must reply even while models
 * change.
 */

#include "Rigs/LocalSurfaceRig.h"
#include "Rigs/PlayedDevice.h"

#include <ctime>

using namespace servotest;

namespace
{
/// Returns a model whose surface is at the value `iso`, and whose slow loop fits `rate` times a
/// second.
std::shared_ptr<const HapticModel> MakeModel(double iso, double rate = 100.0)
{
  const auto volume = std::make_shared<TestVolume>(MakeRamp());
  HapticModelDescription d = DescribeLocal(*volume, iso);
  d.Samples = volume;
  d.Settings.LocalSurfaceRate = rate;
  return std::make_shared<const HapticModel>(d);
}

/// Reads states until `holds` returns true for one of them. Returns false if this takes too long.
template <typename F>
bool WaitState(RunningLoop& loop, F&& holds)
{
  return Eventually([&] { return loop->ReadState() && holds(loop->GetState()); });
}
} // namespace

TEST(LocalSurfaceFitter, AnswersAServoThatRuns)
{
  PlayedDevice device;
  RunningLoop loop(device);
  loop->Publish(MakeModel(1200.0));
  ASSERT_TRUE(WaitState(loop, [](const ServoSnapshot& s) { return s.Record.IsRenewed; }));
  ASSERT_TRUE(WaitState(loop,
    [](const ServoSnapshot& s) {
      return s.Record.Contact != ContactState::Free && std::abs(s.Record.Proxy.Z - 0.012) < 1e-9;
    }));
  const TickRecord& record = loop->GetState().Record;
  EXPECT_LE(Norm(record.Force - Vector3{ 0.0, 0.0, 500.0 * (0.012 - record.Tip.Z) }), 1e-6);
}

TEST(LocalSurfaceFitter, IsNotNeededToStop)
{
  PlayedDevice device;
  const auto begin = std::chrono::steady_clock::now();
  {
    RunningLoop loop(device);
    loop->Publish(MakeModel(1200.0, 1.0)); // one fit per second
    EXPECT_TRUE(Eventually([&] { return loop->GetTickCount() > 10; }));
  }
  // Stopping must not wait for the slow loop, whose period is 1 s. The limit of 30 s allows for a
  // busy machine.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST(LocalSurfaceFitter, SleepsWithoutRequests)
{
  PlayedDevice device;
  ServoLoop loop(device, 1000.0);
  std::atomic<double> worked{ 1.0 };
  std::thread fitter(
    [&]
    {
      loop.RunFitter();
      timespec time;
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
      worked.store(static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec));
    });
  const auto begin = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  loop.RequestStop();
  fitter.join();
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(worked.load(), 0.1 * whole.count()) << "share of a processor";
}

TEST(LocalSurfaceFitter, FollowsModelsThatChange)
{
  PlayedDevice device;
  RunningLoop loop(device);
  for (int i = 0; i < 60; ++i)
  {
    const double iso = i % 2 ? 1200.0 : 1000.0;
    const std::uint64_t generation = loop->Publish(MakeModel(iso, 1000.0));
    ASSERT_TRUE(WaitState(loop,
      [&](const ServoSnapshot& s) { return s.Generation == generation && s.Record.IsRenewed; }))
      << i;
  }
  ASSERT_TRUE(WaitState(loop,
    [](const ServoSnapshot& s) {
      return s.Record.Contact != ContactState::Free && std::abs(s.Record.Proxy.Z - 0.012) < 1e-9;
    }));
}
