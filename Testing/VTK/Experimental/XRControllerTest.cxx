// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a headset's controller on a ramp. VTK's controller events move the tip, and frames make the
 * controller vibrate, through a stand-in for VTK's interactor that records the calls
 * (Testing/Emulators/OpenXR).
 */

#include "Rigs/DeviceRig.h"

#include <vtkEventData.h>
#include <vtkHapticXRController.h>
#include <vtkOpenXRRenderWindowInteractor.h>
#include <vtkQuaternion.h>

#include <cmath>
#include <limits>

using namespace devicetest;

namespace
{
using Headset = vtkOpenXRRenderWindowInteractor;

class XRController : public DeviceTest
{
protected:
  XRController()
  {
    this->Controller->SetDevice(this->Device);
    this->Controller->SetInteractor(this->Interactor);
    this->Controller->SetReach(0.0);
  }
  ~XRController() override { this->Device->Stop(); }

  /// Sends an event of a controller that points to -z, as the interactor does.
  void Send(unsigned long type, const Point& position,
    vtkEventDataAction action = vtkEventDataAction::Unknown,
    vtkEventDataDevice hand = vtkEventDataDevice::RightController)
  {
    vtkNew<vtkEventDataDevice3D> event;
    event->SetType(static_cast<int>(type));
    event->SetDevice(hand);
    event->SetAction(action);
    event->SetWorldPosition(position.data());
    event->SetWorldDirection(this->Direction.data());
    event->SetWorldOrientation(this->Turn.data());
    this->Interactor->InvokeEvent(type, event.GetPointer());
  }
  void Move(const Point& position) { this->Send(vtkCommand::Move3DEvent, position); }
  /// Presses 3 mm into the ramp within six frames: fast enough to feel the contact, and slow enough
  /// for the slew limit.
  bool Press()
  {
    int frame = 0;
    return this->Frames(
      [&]
      {
        frame = std::min(frame + 1, 6);
        this->Move({ 7.0, 7.0, 5.0 + 0.5 * frame });
        return Length(this->Device->GetState()->GetForce()) > 1.0;
      });
  }
  /// Sends frames of a headset until `holds` is true. Returns false if it never becomes true.
  template <typename F>
  bool Frames(F&& holds)
  {
    return Eventually(
      [&]
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
        this->Interactor->InvokeEvent(vtkCommand::RenderEvent);
        return holds();
      });
  }
  bool IsTipAt(const Point& point)
  {
    const double* const tip = this->Device->GetState()->GetTipPosition();
    return std::abs(tip[0] - point[0]) + std::abs(tip[1] - point[1]) + std::abs(tip[2] - point[2]) <
      1e-9;
  }

  vtkNew<Headset> Interactor;
  vtkNew<vtkHapticXRController> Controller;
  Point Direction{ 0.0, 0.0, -1.0 };
  std::array<double, 4> Turn{ 0.0, 0.0, 0.0, 1.0 }; // angle (degrees) and axis
};
} // namespace

TEST_F(XRController, LeadsTheTipByThePoseOfItsHand)
{
  ASSERT_TRUE(this->Device->Open("vibration:xr"));
  ASSERT_TRUE(this->Device->Start());
  this->Move({ 7.0, 7.0, 5.0 });
  EXPECT_TRUE(this->Frames([&] { return this->IsTipAt({ 7.0, 7.0, 5.0 }); }));
  // The other hand and the head must not move the tip.
  this->Send(vtkCommand::Move3DEvent, { 1.0, 1.0, 1.0 }, vtkEventDataAction::Unknown,
    vtkEventDataDevice::LeftController);
  this->Send(vtkCommand::Move3DEvent, { 1.0, 1.0, 1.0 }, vtkEventDataAction::Unknown,
    vtkEventDataDevice::HeadMountedDisplay);
  // A controller that is out of view has no position, so the tip must stay.
  this->Move({ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 });
  this->Interactor->InvokeEvent(vtkCommand::Move3DEvent, nullptr);
  EXPECT_TRUE(this->WaitTicks(5));
  EXPECT_TRUE(this->IsTipAt({ 7.0, 7.0, 5.0 }));
  // The tip is 10 mm in front of the hand in the room. One metre of the room is 200 world units, so
  // this is 2 world units.
  this->Controller->SetReach(0.01);
  this->Interactor->PhysicalScale = 200.0;
  this->Direction = { 0.6, 0.0, -0.8 };
  this->Turn = { 30.0, 0.0, 1.0, 0.0 };
  this->Move({ 7.0, 7.0, 5.0 });
  EXPECT_TRUE(this->Frames([&] { return this->IsTipAt({ 8.2, 7.0, 3.4 }); }));
  vtkQuaterniond expected;
  expected.SetRotationAngleAndAxis(vtkMath::RadiansFromDegrees(30.0), 0.0, 1.0, 0.0);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(this->Device->GetState()->GetTipOrientation()[i], expected[i], 1e-12);
  }
  this->Controller->SetHandToLeft();
  this->Controller->SetReach(0.0);
  this->Send(vtkCommand::Move3DEvent, { 6.0, 6.0, 4.0 }, vtkEventDataAction::Unknown,
    vtkEventDataDevice::LeftController);
  EXPECT_TRUE(this->Frames([&] { return this->IsTipAt({ 6.0, 6.0, 4.0 }); }));
}

TEST_F(XRController, ItsTriggerIsTheStylussButton)
{
  ASSERT_TRUE(this->Device->Open("vibration:xr"));
  ASSERT_TRUE(this->Device->Start());
  this->Move({ 7.0, 7.0, 5.0 });
  for (const unsigned long event : { vtkCommand::Select3DEvent, vtkCommand::Button3DEvent })
  {
    this->Send(event, { 7.0, 7.0, 5.0 }, vtkEventDataAction::Press);
    EXPECT_TRUE(this->Frames([&] { return this->Device->GetState()->GetButtons() == 1; }));
    this->Send(event, { 7.0, 7.0, 5.0 }, vtkEventDataAction::Release);
    EXPECT_TRUE(this->Frames([&] { return this->Device->GetState()->GetButtons() == 0; }));
  }
}

TEST_F(XRController, ContactVibratesAndRestIsSilent)
{
  ASSERT_TRUE(this->Device->Open("vibration:xr"));
  EXPECT_EQ(this->Device->GetMaximumForce(), 4.0);
  EXPECT_TRUE(this->Device->GetSignsConfirmed());
  ASSERT_TRUE(this->Device->Start());
  this->Move({ 7.0, 7.0, 5.0 });
  EXPECT_TRUE(this->Frames([&] { return this->IsTipAt({ 7.0, 7.0, 5.0 }); }));
  this->Device->Arm();
  EXPECT_TRUE(this->Frames([&] { return IsFullyArmed(this->Device); }));
  EXPECT_NE(
    this->Device->GetStatusText().find("vibration:xr (vibration, not force)"), std::string::npos);
  EXPECT_TRUE(this->Interactor->Calls.empty()) << "no force yet";
  EXPECT_TRUE(this->Press());
  EXPECT_TRUE(this->Frames([&] { return !this->Interactor->Calls.empty(); }));
  const std::vector<Headset::Call>& calls = this->Interactor->Calls;
  EXPECT_TRUE(this->Frames([&] { return calls.back().Amplitude == 0.0F; })) << "the tip rests";
  EXPECT_GT(Length(this->Device->GetState()->GetForce()), 1.0) << "and the force stays";
  float largest = 0.0F;
  for (std::size_t i = 0; i < calls.size(); ++i)
  {
    EXPECT_EQ(calls[i].Action, "haptic");
    EXPECT_EQ(calls[i].Hand, 1);
    EXPECT_EQ(calls[i].Duration, 150e6F) << "ns";
    EXPECT_EQ(calls[i].Frequency, 0.0F) << "any";
    EXPECT_GE(calls[i].Amplitude, 0.0F);
    EXPECT_LE(calls[i].Amplitude, 1.0F);
    largest = std::max(largest, calls[i].Amplitude);
    if (i > 0 && calls[i].Amplitude > 0.0F)
    {
      const std::chrono::duration<double> gap = calls[i].At - calls[i - 1].At;
      EXPECT_GE(gap.count(), 0.0099) << "its rate is limited";
    }
  }
  // A force that rises by more than 1 N at once must drive only the strong motor, with an amplitude
  // of 0.64.
  EXPECT_GT(largest, 0.5F);
  const std::size_t before = calls.size();
  for (int i = 0; i < 30; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
    this->Interactor->InvokeEvent(vtkCommand::RenderEvent);
  }
  EXPECT_EQ(calls.size(), before) << "silence is not renewed";
  // A controller that loses its interactor must stop vibrating.
  this->Move({ 7.0, 7.0, 5.0 });
  EXPECT_TRUE(this->Frames([&] { return calls.back().Amplitude > 0.2F; }));
  this->Controller->SetInteractor(nullptr);
  EXPECT_EQ(calls.back().Amplitude, 0.0F);
  EXPECT_FALSE(this->Controller->CanVibrate());
}

TEST_F(XRController, TellsTheProgramWhatAnInteractorCannotDo)
{
  vtkNew<vtkRenderWindowInteractor3D> other;
  this->Controller->SetInteractor(other);
  EXPECT_FALSE(this->Controller->CanVibrate());
  double told = 0.0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&told);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* largest, void* amplitude)
    {
      auto* const most = static_cast<double*>(largest);
      *most = std::max(*most, *static_cast<double*>(amplitude));
    });
  this->Controller->AddObserver(vtkCommand::UserEvent, observer);
  ASSERT_TRUE(this->Device->Open("vibration:xr"));
  ASSERT_TRUE(this->Device->Start());
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
  this->Device->Arm();
  EXPECT_TRUE(this->Wait([&] { return IsFullyArmed(this->Device); }));
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 8.0);
  EXPECT_TRUE(Eventually(
    [&]
    {
      other->InvokeEvent(vtkCommand::RenderEvent);
      return told > 0.3;
    }));
}

TEST_F(XRController, ARefusalIsToldOnceWithTheCure)
{
  MessageLog log(this->Controller);
  this->Interactor->Accepts = false;
  this->Controller->SetActionName("buzz");
  ASSERT_TRUE(this->Device->Open("vibration:xr"));
  ASSERT_TRUE(this->Device->Start());
  this->Move({ 7.0, 7.0, 5.0 });
  this->Device->Arm();
  EXPECT_TRUE(this->Frames([&] { return IsFullyArmed(this->Device); }));
  EXPECT_TRUE(this->Press());
  EXPECT_TRUE(this->Frames([&] { return this->Controller->GetAmplitude() == 0.0; }));
  EXPECT_EQ(this->Interactor->Calls.size(), 1U);
  ASSERT_EQ(log.Warnings.size(), 1U);
  EXPECT_NE(log.Warnings[0].find("\"buzz\""), std::string::npos) << log.Warnings[0];
  EXPECT_NE(log.Warnings[0].find("WriteActions()"), std::string::npos) << log.Warnings[0];
}
