// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Expects that functions for the servo neither allocate nor lock, whatever the device sends. */

#include "Devices/Falcon/FalconHoming.h"
#include "Devices/Falcon/FalconStream.h"
#include "FalconWorkspace.h"
#include "Rigs/ThreadWatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace hardwaretest;

TEST(FalconQuiet, NoTickAllocatesOrLocks)
{
  const FalconReport good{ CountsAt({ 0.01, 0.0, 0.172 }), 0, FalconAllHomed };
  const FalconReport unreachable{ { 32767, -32768, 0 }, 0, FalconAllHomed };
  FalconStream stream;
  FalconHoming homing(1e9);
  FalconReport report;
  int reports = 0;
  std::int64_t sum = 0;
  servotest::WatchThisThread(true);
  for (int tick = 0; tick < 1000; ++tick)
  {
    const FalconPacket packet = FalconEncode(tick % 5 == 4 ? unreachable : good);
    std::array<std::uint8_t, 18> transfer{ 0x01, 0x60 };
    std::copy(packet.begin(), packet.end(), transfer.begin() + 2);
    transfer[2 + tick % 16] = tick % 7 == 0 ? '<' : transfer[2 + tick % 16];
    reports += stream.Receive(transfer.data(), transfer.size(), report);
    homing.Update(0.001, &report);
    const FalconPose pose = FalconForward(FalconAnglesOf(report.Encoders));
    const FalconOrder order{ FalconCommandsOf(pose.Jacobian, { 1.0, 2.0, 3.0 }), FalconGreen };
    sum += FalconEncode(order)[1];
  }
  servotest::WatchThisThread(false);
  EXPECT_EQ(servotest::GetWatched().Allocations, 0u);
  EXPECT_EQ(servotest::GetWatched().Locks, 0u);
  EXPECT_EQ(homing.GetState(), FalconHomingState::Ready);
  EXPECT_GT(reports, 800);
  EXPECT_GT(stream.GetDropped(), 0u);
  EXPECT_GT(sum, 0);
}
