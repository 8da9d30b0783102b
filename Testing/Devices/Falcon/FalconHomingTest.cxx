// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests homing from power-on to ready, and what prevents it.
 */

#include "Devices/Falcon/FalconHoming.h"
#include "FalconWorkspace.h"

#include <gtest/gtest.h>

#include <limits>

using namespace hardwaretest;

namespace
{
class FalconHomes : public testing::Test
{
protected:
  void Update(std::uint8_t homed, double z, double elapsed = 0.001)
  {
    const FalconReport report{ CountsAt({ 0.0, 0.0, z }), 0, homed };
    this->Homing.Update(elapsed, &report);
    EXPECT_EQ(this->Homing.GetOrder().Motors, FalconCounts{}) << "no force while it is homing";
  }
  void BecomeReady()
  {
    this->Update(FalconAllHomed, 0.172);
    ASSERT_EQ(this->Homing.GetState(), FalconHomingState::Ready);
  }

  FalconHoming Homing{ 10.0 };
};
} // namespace

TEST_F(FalconHomes, StepByStep)
{
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::OutAndIn);
  EXPECT_EQ(this->Homing.GetOrder().Lights & FalconHome, FalconHome);
  // Before homing, encoder counts are not positions, so the height of 0.172 m has no effect.
  this->Update(0, 0.172);
  this->Update(0b011, 0.172);
  EXPECT_EQ(this->Homing.GetMissing(), 0b100);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::OutAndIn);
  this->Update(FalconAllHomed, 0.09);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Out);
  EXPECT_EQ(this->Homing.GetOrder().Lights & FalconHome, 0);
  this->Update(FalconAllHomed, 0.1695);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Out);
  this->Update(FalconAllHomed, 0.1705);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Ready);
  this->Update(FalconAllHomed, 0.08);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Ready) << "work is done inside";
}

TEST_F(FalconHomes, TimeIsUp)
{
  for (int i = 0; i < 9999; ++i)
  {
    this->Homing.Update(0.001, nullptr);
  }
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::OutAndIn);
  this->Update(0b011, 0.1, 0.002);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::TimedOut);
  this->Update(FalconAllHomed, 0.172);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::TimedOut) << "only Restart leads on";
  this->Homing.Restart();
  EXPECT_EQ(this->Homing.GetMissing(), FalconAllHomed);
  this->BecomeReady();
}

TEST_F(FalconHomes, EachStateHasItsTime)
{
  this->Update(0, 0.1, 9.0);
  this->Update(FalconAllHomed, 0.1, 9.0);
  this->Update(FalconAllHomed, 0.1, 9.0);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Out);
  this->Update(FalconAllHomed, 0.1, 1.5);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::TimedOut);
}

TEST_F(FalconHomes, ReadyHasNoTimeLimit)
{
  this->BecomeReady();
  this->Homing.Update(1e6, nullptr);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Ready);
}

TEST_F(FalconHomes, ATimeThatIsNoneIsTooLong)
{
  for (const double bad : { std::nan(""), -1.0, std::numeric_limits<double>::infinity() })
  {
    this->Homing.Restart();
    this->Homing.Update(bad, nullptr);
    EXPECT_EQ(this->Homing.GetState(), FalconHomingState::TimedOut);
    FalconHoming homing(std::nan(""));
    homing.Update(0.001, nullptr);
    EXPECT_EQ(homing.GetState(), FalconHomingState::TimedOut);
  }
}

TEST_F(FalconHomes, AZeroThatIsLostStaysLost)
{
  this->BecomeReady();
  this->Update(0b101, 0.172);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Lost);
  this->Update(FalconAllHomed, 0.172);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Lost) << "it never resumes by itself";
}

TEST_F(FalconHomes, CountsOutOfReachAreNotOut)
{
  // With the arms at 102 degrees, the iteration stops out of reach, far above the height at which a
  // device is ready.
  const FalconReport report{ { 1850, 1850, 1850 }, 0, FalconAllHomed };
  const FalconPose pose = FalconForward(FalconAnglesOf(report.Encoders));
  ASSERT_TRUE(pose.Reach != FalconReach::Reached && pose.Position.Z > FalconReadyHeight);
  this->Homing.Update(0.001, &report);
  EXPECT_EQ(this->Homing.GetState(), FalconHomingState::Out);
}
