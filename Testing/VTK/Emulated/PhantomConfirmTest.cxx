// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the first arming of an emulated Falcon whose motors are wired correctly or reversed. */

#include "DevicesFile.h"
#include "PhantomFalconRig.h"

#include <fstream>
#include <sstream>

using namespace emulated;

namespace
{
struct OwnDevices
{
  const DevicesFile Memory;
};

class PhantomConfirm
  : public OwnDevices
  , public PhantomFalcon
{
protected:
  PhantomConfirm()
    : PhantomFalcon(true)
  {
    this->Memory.Clear();
  }
  /// Homes the device, moves it in front of the face, and arms it.
  void ArmInTheHand()
  {
    ASSERT_TRUE(this->Device->Open("falcon"));
    ASSERT_TRUE(this->Device->Start());
    ASSERT_NO_FATAL_FAILURE(this->Home());
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, SkinHeight - 0.005)) << "in the skin, which is not felt";
    this->Falcon.DrainLargestCommand();
    this->Device->Arm();
  }
  std::string ReadMemory() const
  {
    std::ostringstream text;
    text << std::ifstream(this->Memory.Path).rdbuf();
    return text.str();
  }
};
} // namespace

TEST_F(PhantomConfirm, ItIsFeltAndRememberedOnceItMovedWithTheForce)
{
  ASSERT_NO_FATAL_FAILURE(this->ArmInTheHand());
  EXPECT_FALSE(this->Device->GetSignsConfirmed());
  EXPECT_TRUE(this->Hand.Wait([&] { return this->Hand.Says("Confirming the signs of falcon"); }))
    << this->Device->GetStatusText();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::ACTIVE)) << this->Device->GetStatusText();
  EXPECT_TRUE(this->Device->GetSignsConfirmed());
  EXPECT_NE(this->ReadMemory().find("falcon:port:1-2 confirmed=20"), std::string::npos)
    << this->ReadMemory();
  ASSERT_NO_FATAL_FAILURE(this->Press(0.0, 0.0, 0.006));

  ASSERT_TRUE(this->Device->Open("falcon"));
  EXPECT_TRUE(this->Device->GetSignsConfirmed()) << "for good";
  this->Device->ForgetConfirmation();
  EXPECT_FALSE(this->Device->GetSignsConfirmed());
  EXPECT_EQ(this->ReadMemory().find("confirmed="), std::string::npos) << this->ReadMemory();
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(PhantomConfirm, ACalibratedDeviceIsAskedForWhatItReallyGives)
{
  std::ofstream(this->Memory.Path) << "falcon:port:1-2 confirmed=2026-11-01\n";
  EXPECT_FALSE(this->Device->CalibrateForce(2.0));
  ASSERT_EQ(this->Log.Errors.size(), 1u);
  EXPECT_NE(this->Log.Errors[0].find("Open() it and Stop() it first"), std::string::npos);
  this->Log.Errors.clear();
  ASSERT_TRUE(this->Device->Open("falcon"));
  EXPECT_EQ(this->Device->GetCalibrationText(), "uncalibrated");
  EXPECT_DOUBLE_EQ(this->Device->GetMaximumForce(), 4.0);
  EXPECT_FALSE(this->Device->CalibrateForce(0.05));
  EXPECT_FALSE(this->Device->CalibrateForce(11.0));
  ASSERT_EQ(this->Log.Errors.size(), 2u);
  EXPECT_NE(this->Log.Errors[0].find("0.1 to 10"), std::string::npos) << this->Log.Errors[0];
  this->Log.Errors.clear();
  // A factor of 2 means that the device is twice as strong as nominal. The limit remains 4 N.
  ASSERT_TRUE(this->Device->CalibrateForce(2.0));
  EXPECT_DOUBLE_EQ(this->Device->GetMaximumForce(), 4.0);
  ASSERT_TRUE(this->Device->CalibrateForce(0.5));
  EXPECT_DOUBLE_EQ(this->Device->GetMaximumForce(), 2.0);
  EXPECT_EQ(this->Device->GetForceScale(), 0.5);
  EXPECT_NE(this->ReadMemory().find("falcon:port:1-2 confirmed=2026-11-01 scale=0.5 calibrated=20"),
    std::string::npos)
    << this->ReadMemory();

  ASSERT_TRUE(this->Device->Open("falcon"));
  EXPECT_EQ(this->Device->GetForceScale(), 0.5) << "remembered";
  ASSERT_TRUE(this->Device->Start());
  ASSERT_NO_FATAL_FAILURE(this->Home());
  this->Device->Arm();
  ASSERT_TRUE(this->LeadTo(0.0, 0.0, SkinHeight + 0.01));
  ASSERT_TRUE(this->LeadTo(0.0, 0.0, SkinHeight - 0.006));
  // The force scale is 0.5, so the model receives twice the reported force, which it exerts.
  EXPECT_TRUE(this->Hand.Wait(
    [&]
    {
      const double told = -this->Device->GetState()->GetForce()[1];
      return told > 0.1 && std::abs(this->Falcon.GetForce()[2] - 2.0 * told) < 0.05;
    }));
}

TEST_F(PhantomConfirm, MotorsTheOtherWayRoundAreAFaultBeforeAnythingIsFelt)
{
  this->Falcon.SetMotorSign(-1.0);
  ASSERT_NO_FATAL_FAILURE(this->ArmInTheHand());
  ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT)) << this->Device->GetStatusText();
  EXPECT_TRUE(this->Hand.Says("the device moves against the force on axis "))
    << this->Device->GetStatusText();
  EXPECT_TRUE(this->Hand.Says("wrong sign")) << this->Device->GetStatusText();
  EXPECT_FALSE(this->Device->GetSignsConfirmed());
  EXPECT_EQ(this->ReadMemory(), "");
  EXPECT_LE(this->Falcon.DrainLargestCommand(), 1000.0) << "a tenth of 8 N, no wall";
  this->ExpectNoForce(50);
}
