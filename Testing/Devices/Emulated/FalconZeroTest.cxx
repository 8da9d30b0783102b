// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests all ways to zero force: the servo stops, hangs or is quenched; the device is closed,
 * destroyed or unplugged.
 */

#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
class FalconZero : public FalconTest
{
protected:
  void BeginForce()
  {
    this->MakeReady();
    ASSERT_TRUE(this->Feels({ 0.5, -1.0, 2.0 }));
  }
  bool IsZero()
  {
    return Eventually([&] { return this->Falcon.GetCommands() == Numbers{}; });
  }
};
} // namespace

TEST_F(FalconZero, WhenTheServoStandsStill)
{
  this->BeginForce();
  // The servo hangs here: it neither writes a force nor quenches.
  EXPECT_TRUE(this->IsZero());
  const long packets = this->Falcon.GetPackets();
  EXPECT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > packets + 20; }))
    << "zero is renewed";
  EXPECT_TRUE(this->Feels({ 0.5, -1.0, 2.0 }));
}

TEST_F(FalconZero, WhenQuenched)
{
  this->BeginForce();
  this->Device->Quench();
  EXPECT_TRUE(this->IsZero());
  EXPECT_TRUE(this->Feels({ 0.5, -1.0, 2.0 })) << "until the next force";
}

TEST_F(FalconZero, WhenTheForceIsNoNumber)
{
  this->BeginForce();
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(
    this->Push({ none, 0.0, 1.0 }, [&] { return this->Falcon.GetCommands() == Numbers{}; }));
}

TEST_F(FalconZero, WhenClosed)
{
  this->BeginForce();
  this->Device->Close();
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{});
  EXPECT_FALSE(this->Usb.IsClaimed());
  this->Device->Close();
}

TEST_F(FalconZero, WhenDestroyed)
{
  this->BeginForce();
  this->Device.reset();
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{});
  EXPECT_FALSE(this->Usb.IsClaimed());
}

TEST_F(FalconZero, WhenTheServoLoopStops)
{
  this->MakeReady();
  {
    servotest::RunningLoop loop(*this->Device, 1000.0);
    ASSERT_TRUE(Eventually([&] { return loop->GetTickCount() > 20; }));
  }
  EXPECT_TRUE(this->IsZero());
}

TEST_F(FalconZero, OpenedAndClosedManyTimes)
{
  this->MakeReady();
  for (int i = 0; i < 30; ++i)
  {
    ASSERT_TRUE(this->Device->Open(this->Error)) << this->Error;
    if (i % 3 == 0)
    {
      ASSERT_TRUE(this->IsAt(DeviceStage::Homing));
    }
    this->Device->Close();
    EXPECT_FALSE(this->Usb.IsClaimed());
  }
}

TEST_F(FalconZero, UnpluggedWhenItIsClosed)
{
  this->BeginForce();
  this->Usb.Unplug();
  this->Device->Close();
  EXPECT_FALSE(this->Open());
  EXPECT_TRUE(Has(this->Error, "Plug it in")) << this->Error;
}
