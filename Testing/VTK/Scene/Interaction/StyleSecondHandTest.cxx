// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A second device in a scene: keys and the window are for both hands, a fault and the force are
 * one hand's, and the head-up display and a widget show both.
 */

#include "Rigs/PlayedHardware.h"
#include "StyleRig.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticRepresentation.h>
#include <vtkHapticWidget.h>

using namespace scenetest;

namespace
{
class StyleSecondHand : public StyleTest
{
protected:
  void SetUp() override
  {
    this->Second->SetVolumeHaptics(this->Filter);
    this->Display->SetDevice(this->Device);
    this->Display->SetSecondDevice(this->Second);
    this->Style->SetHeadUpDisplay(this->Display);
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Second->Open("virtual"));
    this->Second->GetVirtualHand()->SetPosition(10.0, 0.0, 40.0);
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->Second->Start());
    this->Style->SetSecondDevice(this->Second);
    this->Run(5);
  }
  template <typename F>
  bool Wait(F&& holds)
  {
    return Eventually(
      [&]
      {
        this->Style->UpdateHaptics();
        return holds();
      });
  }
  static bool IsArmed(vtkHapticDevice* device)
  {
    return device->GetStatus() == vtkHapticDevice::ARMED ||
      device->GetStatus() == vtkHapticDevice::ACTIVE;
  }
  bool AreArmed(bool first, bool second)
  {
    return this->Wait(
      [&] { return IsArmed(this->Device) == first && IsArmed(this->Second) == second; });
  }
  /// Presses into the ball's top, 30 mm from its middle.
  bool PressSecond()
  {
    return this->Wait([this] { return IsFullyArmed(this->Second); }) &&
      (this->Second->GetVirtualHand()->SetPosition(10.0, 0.0, 26.0), true) &&
      this->Wait([this] { return Length(this->Second->GetState()->GetForce()) > 0.3; });
  }

  vtkNew<vtkHapticDevice> Second;
  vtkNew<vtkHapticHeadUpDisplay> Display;
};
} // namespace

TEST_F(StyleSecondHand, TheKeyArmsWhatIsNotArmedAndThenDisarmsBoth)
{
  EXPECT_EQ(this->Style->GetSecondDevice(), this->Second);
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  ASSERT_TRUE(this->PressSecond());
  EXPECT_NE(this->Display->GetText().find("Second hand: "), std::string::npos);
  EXPECT_NE(this->Display->GetText().find(" N of at most"), std::string::npos);
  this->Second->Disarm();
  ASSERT_TRUE(this->AreArmed(true, false));
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(false, false));
}

TEST_F(StyleSecondHand, EscapeAndTheWindowLetBothGo)
{
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  this->Press("Escape");
  ASSERT_TRUE(this->AreArmed(false, false));
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  this->Interactor->SetInteractorStyle(nullptr);
  EXPECT_FALSE(this->Second->IsArmOrdered());
}

TEST_F(StyleSecondHand, WhatIsUnpluggedIsOneHandsAndTheKeyBringsItBack)
{
  PlayedHardware::Add();
  ASSERT_TRUE(this->Second->Open("played:0"));
  ASSERT_TRUE(this->Second->Start());
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  PlayedHardware::Get().Stage = VolumeHaptics::DeviceStage::Lost;
  ASSERT_TRUE(this->Wait([this] { return this->Second->GetStatus() == vtkHapticDevice::FAULT; }));
  const vtkIdType seen = this->Second->GetState()->GetTick() + 3;
  ASSERT_TRUE(this->Wait([this, seen] { return this->Second->GetState()->GetTick() >= seen; }));
  EXPECT_EQ(PlayedHardware::Get().Force, 0.0);
  EXPECT_TRUE(IsArmed(this->Device)) << "the other hand goes on";
  EXPECT_NE(this->Display->GetText().find("Second hand: Force cut off"), std::string::npos)
    << this->Display->GetText();
  PlayedHardware::Get().Stage = VolumeHaptics::DeviceStage::Ready;
  this->Run(20);
  ASSERT_TRUE(this->AreArmed(true, false)) << "not by itself";
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
}

TEST_F(StyleSecondHand, ChangesOfTheFilterReachBoth)
{
  this->Filter->SetMethodToForceField();
  this->Style->UpdateHaptics();
  EXPECT_EQ(this->Second->GetMethodText(), this->Filter->GetMethodText());
  EXPECT_EQ(this->Device->GetMethodText(), this->Filter->GetMethodText());
}

TEST_F(StyleSecondHand, AVolumeThatMovesIsTheFirstHands)
{
  vtkNew<vtkImageData> beats;
  beats->CopyStructure(this->Ball);
  beats->AllocateScalars(VTK_FLOAT, 2);
  vtkDataArray* const values = this->Ball->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < beats->GetNumberOfPoints(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    beats->GetPointData()->GetScalars()->SetTuple2(i, value, value - 200.0);
  }
  this->Filter->SetFramesToComponents();
  this->Filter->SetInputData(0, beats);
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->HasTimeSteps(); }));
  this->Second->Arm();
  ASSERT_TRUE(this->Wait([this] { return !this->Second->IsArmOrdered(); }));
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find("Touch a moving volume with one device"), std::string::npos);
  this->Log.Warnings.clear();
}

TEST_F(StyleSecondHand, TheFirstDeviceIsNotTheSecondOneToo)
{
  this->Style->SetSecondDevice(this->Device);
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("Open() another vtkHapticDevice"), std::string::npos);
  EXPECT_EQ(this->Style->GetSecondDevice(), this->Second);
  this->Log.Errors.clear();
  this->Style->SetSecondDevice(nullptr);
  EXPECT_EQ(this->Style->GetSecondDevice(), nullptr);
}

TEST_F(StyleSecondHand, ARealOneHasItsOwnWorkspaceClutchAndHoming)
{
  PlayedHardware::Add();
  this->Style->SetSecondDevice(nullptr);
  ASSERT_TRUE(this->Second->Open("played:0"));
  ASSERT_TRUE(this->Second->Start());
  this->Style->SetSecondDevice(this->Second);
  this->Run(5);
  ASSERT_NE(this->Second->GetDeviceToWorld(), nullptr) << "it follows the camera";
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  this->Press("k");
  EXPECT_TRUE(this->Second->GetClutch());
  EXPECT_FALSE(this->Device->GetClutch()) << "the mouse has none";
  ASSERT_TRUE(this->AreArmed(true, false));
  this->Press("k", vtkCommand::KeyReleaseEvent);
  ASSERT_TRUE(this->AreArmed(true, true));
  const int before = PlayedHardware::Get().Homings;
  this->Press("Home");
  EXPECT_EQ(PlayedHardware::Get().Homings, before + 1);
}

TEST_F(StyleSecondHand, AWidgetShowsStartsAndStopsIt)
{
  this->Interactor->SetInteractorStyle(nullptr);
  this->Style->SetSecondDevice(nullptr);
  this->Second->Stop();
  this->Second->SetVolumeHaptics(nullptr);
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(this->Ball);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  ShowBall(volume);
  this->Renderer->AddVolume(volume);
  vtkNew<vtkHapticWidget> widget;
  widget->SetInteractor(this->Interactor);
  widget->SetSecondDevice(this->Second);
  widget->On();
  EXPECT_TRUE(this->Second->IsRunning());
  EXPECT_EQ(this->Second->GetVolumeHaptics(), widget->GetVolumeHaptics());
  EXPECT_TRUE(this->Renderer->HasViewProp(widget->GetSecondRepresentation()));
  EXPECT_EQ(
    widget->GetSecondRepresentation()->GetRadius(), widget->GetRepresentation()->GetRadius());
  EXPECT_EQ(widget->GetHeadUpDisplay()->GetSecondDevice(), this->Second);
  widget->Off();
  EXPECT_FALSE(this->Second->IsRunning());
  EXPECT_FALSE(this->Renderer->HasViewProp(widget->GetSecondRepresentation()));
  EXPECT_TRUE(this->Second->IsOpen());
}
