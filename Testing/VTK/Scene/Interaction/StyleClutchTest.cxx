// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that an order to disarm while the clutch is held takes precedence: releasing the clutch
 * must not restore the force.
 */

#include "Rigs/PlayedHardware.h"
#include "StyleRig.h"

using namespace scenetest;

namespace
{
class StyleClutch : public StyleTest
{
protected:
  void SetUp() override
  {
    PlayedHardware::Add();
    ASSERT_TRUE(this->Device->Open("played:0"));
    ASSERT_TRUE(this->Device->Start());
    this->Run(5);
    this->Device->Arm();
    this->Run(5);
    ASSERT_TRUE(this->IsArmed());
    this->Press("k");
    ASSERT_TRUE(this->Style->GetClutch());
    // At this update, the style does not know yet that the clutch has disarmed the device. It must
    // not mistake this for an order of the application.
    this->Style->UpdateHaptics();
    this->Run(5);
    ASSERT_FALSE(this->IsArmed());
  }
  void Release()
  {
    this->Press("k", vtkCommand::KeyReleaseEvent);
    EXPECT_FALSE(this->Style->GetClutch());
    this->Run(5);
  }
  bool IsArmed() { return this->Device->GetStatus() >= vtkHapticDevice::ARMED; }
};
} // namespace

TEST_F(StyleClutch, ReleasedIsArmedAgain)
{
  this->Release();
  EXPECT_TRUE(this->IsArmed());
}

TEST_F(StyleClutch, EscapeEndsItWithoutForce)
{
  this->Press("Escape");
  EXPECT_FALSE(this->Style->GetClutch()) << "a window without the focus hears of no release";
  this->Release();
  EXPECT_FALSE(this->IsArmed());
}

TEST_F(StyleClutch, TheKeyThatDisarmsHasTheLastWord)
{
  this->Press("a");
  this->Run(5);
  EXPECT_FALSE(this->IsArmed()) << "no force while it is clutched";
  this->Release();
  EXPECT_FALSE(this->IsArmed());
}

TEST_F(StyleClutch, TheApplicationHasTheLastWord)
{
  this->Device->Disarm();
  this->Release();
  EXPECT_FALSE(this->IsArmed());
}

TEST_F(StyleClutch, TheEndOfTheTouchModeHasTheLastWord)
{
  this->Style->SetTouchMode(true);
  this->Run(5);
  EXPECT_FALSE(this->IsArmed()) << "no force while it is clutched";
  this->Style->SetTouchMode(false);
  this->Release();
  EXPECT_FALSE(this->IsArmed());
}

TEST_F(StyleClutch, ADeviceThatWasStoppedMeanwhileStaysDisarmed)
{
  this->Device->Stop();
  ASSERT_TRUE(this->Device->Start());
  this->Run(5);
  this->Release();
  EXPECT_FALSE(this->IsArmed());
}

TEST_F(StyleClutch, NothingArmsWhileItIsHeld)
{
  this->Device->Arm();
  this->Run(20);
  EXPECT_FALSE(this->IsArmed());
}

TEST_F(StyleClutch, AnotherDeviceIsNotClutched)
{
  vtkNew<vtkHapticDevice> other;
  this->Style->SetDevice(other);
  EXPECT_FALSE(this->Style->GetClutch());
  this->Style->SetDevice(this->Device);
  this->Release();
  EXPECT_FALSE(this->IsArmed());
}
