// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * When a device is believed, and what it is sent then and otherwise.
 */

#include "Devices/Falcon/FalconPilot.h"
#include "FalconWorkspace.h"

#include <gtest/gtest.h>

using namespace hardwaretest;

namespace
{
class FalconPilots : public testing::Test
{
protected:
  FalconPilots()
  {
    this->Exchange.Begin();
    this->Exchange.SetCondition(DeviceStage::Homing, "");
  }
  void Take(const Vector3& place, double elapsed = 0.001, std::uint8_t homed = FalconAllHomed)
  {
    const FalconReport report{ CountsAt(place), 0, homed };
    this->Pilot.Take(report, elapsed);
  }
  void BecomeReady()
  {
    this->Take(Out);
    ASSERT_FALSE(this->Pilot.IsLost());
    ASSERT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Ready);
    DeviceSample sample;
    this->Exchange.Take(sample);
    this->Exchange.Give({ 0.0, 0.0, 4.0 });
    ASSERT_LT(this->Pilot.GetOrder().Motors[0], -500);
  }
  std::string GetText() { return this->Exchange.GetCondition().Text.data(); }

  const Vector3 Out{ 0.0, 0.0, 0.171 };
  HardwareExchange Exchange;
  FalconPilot Pilot{ this->Exchange, 10.0 };
};
} // namespace

TEST_F(FalconPilots, BelievesAFastHand)
{
  this->BecomeReady();
  // 4 m/s, which the servo stops for other reasons.
  for (double z = 0.171; z > 0.09; z -= 0.004)
  {
    this->Take({ 0.0, 0.0, z });
    EXPECT_FALSE(this->Pilot.IsLost()) << z;
  }
}

TEST_F(FalconPilots, DoesNotBelieveAJump)
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
    this->Pilot.Restart();
    this->Exchange.Begin();
    this->Pilot.Restart();
    this->BecomeReady();
    this->Take(this->Out - Vector3{ 0.0, 0.0, c.Distance }, c.Elapsed);
    EXPECT_EQ(this->Pilot.IsLost(), !c.IsBelieved) << c.Distance << " in " << c.Elapsed;
    if (!c.IsBelieved)
    {
      EXPECT_NE(this->GetText().find("jumped"), std::string::npos);
      EXPECT_EQ(this->Pilot.GetOrder().Motors, FalconCounts{});
    }
  }
}

TEST_F(FalconPilots, CountsTheTimeOfPacketsThatWereMissed)
{
  this->BecomeReady();
  for (int i = 0; i < FalconPilot::MostMissed - 1; ++i)
  {
    this->Pilot.Miss(0.01, nullptr);
    EXPECT_FALSE(this->Pilot.IsLost());
  }
  this->Take(this->Out - Vector3{ 0.0, 0.0, 0.018 });
  EXPECT_FALSE(this->Pilot.IsLost()) << "and begins to count anew";
  for (int i = 0; i < FalconPilot::MostMissed; ++i)
  {
    this->Pilot.Miss(0.01, "a packet is not 16 bytes long");
  }
  EXPECT_TRUE(this->Pilot.IsLost());
  EXPECT_NE(this->GetText().find("not 16 bytes"), std::string::npos) << this->GetText();
}

TEST_F(FalconPilots, TakesNothingBackBeforeARestart)
{
  this->BecomeReady();
  this->Take(this->Out, 0.001, 0b101);
  EXPECT_TRUE(this->Pilot.IsLost());
  this->Take(this->Out);
  EXPECT_EQ(this->Pilot.GetOrder().Motors, FalconCounts{});
  EXPECT_EQ(this->Pilot.GetOrder().Lights, FalconRed);
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Lost);
  this->Exchange.RequestHome();
  ASSERT_TRUE(this->Exchange.TakeHomeRequest());
  this->Pilot.Restart();
  this->Take(this->Out);
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Ready);
  EXPECT_EQ(this->Pilot.GetOrder().Motors, FalconCounts{}) << "the servo has not looked yet";
}

TEST_F(FalconPilots, TellsWhereTheTipIsFromTheMiddle)
{
  this->Take({ 0.01, -0.02, 0.171 });
  DeviceSample sample;
  ASSERT_EQ(this->Exchange.Take(sample), DeviceState::Running);
  EXPECT_LT(Norm(sample.Tip - Vector3{ 0.01, -0.02, 0.046 }), 1e-4);
  EXPECT_TRUE(sample.Begins);
}
