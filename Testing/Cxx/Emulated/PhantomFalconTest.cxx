// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * An application in which a hand presses an emulated Falcon onto the face of the phantom.
 */

#include "EmulatedUsb.h"
#include "FalconModel.h"
#include "PhantomRig.h"

#include <fstream>

using namespace emulated;

namespace
{
constexpr double Middle = 0.125; // m, where the skin is in the Falcon's own frame

class PhantomFalcon : public testing::Test
{
protected:
  bool LeadTo(double x, double y, double z)
  {
    this->Falcon.SetAim({ x, y, z });
    return Eventually(
      [&]
      {
        const Numbers hand = this->Falcon.GetHand();
        return std::hypot(hand[0] - x, hand[1] - y, hand[2] - z) < 1e-6;
      });
  }
  void Home()
  {
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::HOMING)) << this->Device->GetStatusText();
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.1735));
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.08));
    this->Device->Arm();
    EXPECT_EQ(this->Log.Errors.size(), 1u) << "not before it is homed";
    this->Log.Errors.clear();
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.172));
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << this->Device->GetStatusText();
  }
  /** The hand goes on until it is so far (m) beyond the skin, and feels it. */
  void Press(double beyond)
  {
    this->Device->Arm();
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, Middle - beyond));
    // In balance with the hand's spring, where the grip has come to rest.
    EXPECT_TRUE(this->Hand.Wait(
      [&]
      {
        const double spring =
          FalconGrip::HandStiffness * (this->Falcon.GetGrip()[2] - (Middle - beyond));
        const double* const force = this->Device->GetForce();
        return force[1] < -0.3 && std::abs(-force[1] - spring) < 0.05 &&
          std::abs(this->Falcon.GetForce()[2] + force[1]) < 0.05;
      }))
      << this->Falcon.GetForce()[2] << " N, told " << this->Device->GetForce()[1] << " N";
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
    EXPECT_NE(this->Device->GetContact(), 0);
    EXPECT_GT(Phantom.DepthOf(this->Device->GetTipPosition()),
      Phantom.DepthOf(this->Device->GetProxyPosition()));
  }

  /** The servo has felt nothing but zero for so many ticks. */
  void ExpectNoForce(vtkIdType ticks)
  {
    const vtkIdType end = this->Device->GetTick() + ticks;
    EXPECT_TRUE(this->Hand.Wait(
      [&]
      {
        EXPECT_EQ(Length(this->Device->GetForce()), 0.0);
        return this->Device->GetTick() >= end;
      }));
  }

  emulated::Phantom Phantom;
  FalconModel Falcon{ false };
  EmulatedUsb Usb{ this->Falcon, "1-2" };
  PhantomHand Hand{ this->Phantom, 2, 1.0 };
  vtkHapticDevice* const Device = this->Hand.Device;
  apitest::MessageLog Log{ this->Device };
};
} // namespace

TEST_F(PhantomFalcon, IsFeltLostAndFeltAgain)
{
  EXPECT_FALSE(this->Device->Open("falcon"));
  ASSERT_EQ(this->Log.Errors.size(), 1u);
  EXPECT_NE(this->Log.Errors[0].find("SetFirmwareFile"), std::string::npos) << this->Log.Errors[0];
  const std::string firmware = testing::TempDir() + "PhantomFalcon.bin";
  std::ofstream(firmware, std::ios::binary) << std::string(4000, 'F');
  this->Device->SetFirmwareFile(firmware);

  ASSERT_TRUE(this->Device->Open("falcon"));
  ASSERT_TRUE(this->Device->Start());
  EXPECT_TRUE(this->Hand.Says("irmware")) << this->Device->GetStatusText();
  ASSERT_NO_FATAL_FAILURE(this->Home());
  EXPECT_EQ(this->Falcon.GetImage(), std::vector<std::uint8_t>(4000, 'F'));
  const vtkIdType from = this->Device->GetTick();
  ASSERT_NO_FATAL_FAILURE(this->Press(0.006));
  // Along the face and back, pressed all the while.
  for (const double x : { 0.015, -0.015, 0.0 })
  {
    ASSERT_TRUE(this->LeadTo(x, 0.5 * x, Middle - 0.006));
    EXPECT_TRUE(this->Hand.WaitTicks(1500));
    EXPECT_LT(this->Device->GetForce()[1], -0.1) << "out of the face, at " << x;
  }
  EXPECT_TRUE(this->Hand.Wait([&] { return this->Device->GetTick() >= from + 5000; }));
  EXPECT_GT(Length(this->Device->GetForce()), 0.3);

  this->Usb.Unplug();
  EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(this->Hand.Says("unplugged")) << this->Device->GetStatusText();
  EXPECT_TRUE(this->Hand.WaitTicks(5));
  this->ExpectNoForce(20);
  this->Falcon.SwitchOff();
  this->Usb.PlugIn();
  this->ExpectNoForce(200);
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::FAULT) << "nothing comes back by itself";

  ASSERT_TRUE(this->Device->Open("falcon"));
  ASSERT_TRUE(this->Device->Start());
  ASSERT_NO_FATAL_FAILURE(this->Home());
  this->ExpectNoForce(100);
  ASSERT_NO_FATAL_FAILURE(this->Press(0.006));
  this->Device->Close();
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{});
}
