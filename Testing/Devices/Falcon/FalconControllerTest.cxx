// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests when the controller accepts a device's reports, and what it then sends to the device. */

#include "Devices/Falcon/FalconController.h"
#include "FalconWorkspace.h"

#include <gtest/gtest.h>

using namespace hardwaretest;

namespace
{
class FalconControllers : public testing::Test
{
protected:
  FalconControllers()
  {
    this->Exchange.Begin();
    this->Exchange.SetCondition(DeviceStage::Homing, "");
  }
  void Take(const Vector3& place, double elapsed = 0.001, std::uint8_t homed = FalconAllHomed)
  {
    const FalconReport report{ CountsAt(place), 0, homed };
    this->Controller.Receive(report, elapsed);
  }
  void BecomeReady()
  {
    this->Take(Out);
    ASSERT_FALSE(this->Controller.IsLost());
    ASSERT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Ready);
    DeviceSample sample;
    this->Exchange.Receive(sample);
    this->Exchange.Give({ 0.0, 0.0, 4.0 });
    ASSERT_LT(this->Controller.GetOrder().Motors[0], -500);
  }
  std::string GetText() { return this->Exchange.GetCondition().Text.data(); }

  const Vector3 Out{ 0.0, 0.0, 0.171 };
  HardwareExchange Exchange;
  FalconController Controller{ this->Exchange, 10.0 };
};
} // namespace

TEST_F(FalconControllers, BelievesAFastHand)
{
  this->BecomeReady();
  // Move at 4 m/s. The controller accepts any speed; limiting it is the servo's task.
  for (double z = 0.171; z > 0.09; z -= 0.004)
  {
    this->Take({ 0.0, 0.0, z });
    EXPECT_FALSE(this->Controller.IsLost()) << z;
  }
}

TEST_F(FalconControllers, DoesNotBelieveAJump)
{
  struct
  {
    double Distance;
    double Elapsed;
    bool IsBelieved;
  } const cases[] = { { 0.006, 0.001, true }, { 0.0085, 0.001, false }, { 0.006, 0.0, true },
    { 0.0085, 0.002, true }, { 0.019, 0.01, true }, { 0.021, 0.01, false }, { 0.021, 1.0, false } };
  for (const auto& c : cases)
  {
    this->Controller.Restart();
    this->Exchange.Begin();
    this->Controller.Restart();
    this->BecomeReady();
    this->Take(this->Out - Vector3{ 0.0, 0.0, c.Distance }, c.Elapsed);
    EXPECT_EQ(this->Controller.IsLost(), !c.IsBelieved) << c.Distance << " in " << c.Elapsed;
    if (!c.IsBelieved)
    {
      EXPECT_NE(this->GetText().find("jumped"), std::string::npos);
      EXPECT_EQ(this->Controller.GetOrder().Motors, FalconCounts{});
    }
  }
}

TEST_F(FalconControllers, CountsTheTimeOfPacketsThatWereMissed)
{
  this->BecomeReady();
  for (int i = 0; i < FalconController::MostMissed - 1; ++i)
  {
    this->Controller.Miss(0.01, nullptr);
    EXPECT_FALSE(this->Controller.IsLost());
  }
  this->Take(this->Out - Vector3{ 0.0, 0.0, 0.018 });
  EXPECT_FALSE(this->Controller.IsLost()) << "and begins to count anew";
  for (int i = 0; i < FalconController::MostMissed; ++i)
  {
    this->Controller.Miss(0.01, "a packet is not 16 bytes long");
  }
  EXPECT_TRUE(this->Controller.IsLost());
  EXPECT_NE(this->GetText().find("not 16 bytes"), std::string::npos) << this->GetText();
}

TEST_F(FalconControllers, TakesNothingBackBeforeARestart)
{
  this->BecomeReady();
  this->Take(this->Out, 0.001, 0b101);
  EXPECT_TRUE(this->Controller.IsLost());
  this->Take(this->Out);
  EXPECT_EQ(this->Controller.GetOrder().Motors, FalconCounts{});
  EXPECT_EQ(this->Controller.GetOrder().Lights, FalconRed);
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Lost);
  this->Exchange.RequestHome();
  ASSERT_TRUE(this->Exchange.DrainHomeRequest());
  this->Controller.Restart();
  this->Take(this->Out);
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Ready);
  EXPECT_EQ(this->Controller.GetOrder().Motors, FalconCounts{}) << "the servo has not looked yet";
}

TEST_F(FalconControllers, TellsWhereTheTipIsFromTheMiddle)
{
  this->Take({ 0.01, -0.02, 0.171 });
  DeviceSample sample;
  ASSERT_EQ(this->Exchange.Receive(sample), DeviceState::Running);
  EXPECT_LT(Norm(sample.Tip - Vector3{ 0.01, -0.02, 0.046 }), 1e-4);
  EXPECT_TRUE(sample.Begins);
}
