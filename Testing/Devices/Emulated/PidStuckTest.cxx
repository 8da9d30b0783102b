// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a stick that accepts no more reports, so that the kernel waits with each report. Only the
 * device's thread may wait.
 */

#include "DeviceBench.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"

#include <cerrno>

using namespace emulated;

namespace
{
class StuckStick : public OpenFfboardModel
{
public:
  int Output(const std::uint8_t* report, int size) override
  {
    if (!this->IsStuck)
    {
      return OpenFfboardModel::Output(report, size);
    }
    ++this->Refused;
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    return -ETIMEDOUT;
  }
  std::atomic<bool> IsStuck{ false };
  std::atomic<int> Refused{ 0 };
};
} // namespace

TEST(PidStuck, IsWaitedForOnceWhereItIsLostAndOnceWhereItIsClosed)
{
  StuckStick model;
  model.Streams = true;
  const EmulatedHid hid(model);
  const ModelClock clock([&] { model.Step(); });
  DeviceBench bench;
  ASSERT_TRUE(bench.Open("pid")) << bench.Error;
  ASSERT_TRUE(bench.WaitFor(DeviceStage::Ready)) << bench.Text();
  model.IsStuck = true;
  EXPECT_TRUE(bench.WaitForText("does not accept what is sent to it")) << bench.Text();
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_EQ(model.Refused, 1);
  EXPECT_EQ(Size(model.GetForce()), 0.0);
  bench.Device->Close();
  EXPECT_EQ(model.Refused, 2) << "it may have come to itself";

  model.IsStuck = false;
  ASSERT_TRUE(bench.Reopen()) << bench.Error;
  EXPECT_TRUE(bench.WaitFor(DeviceStage::Ready)) << bench.Text();
  model.IsStuck = true;
  EXPECT_TRUE(bench.WaitFor(DeviceStage::Lost));
  model.IsStuck = false;
  bench.Device->Home();
  EXPECT_TRUE(bench.WaitFor(DeviceStage::Ready)) << bench.Text();
}
