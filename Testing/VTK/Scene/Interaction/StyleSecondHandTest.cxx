// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a scene with a second device. Keys and the window act on both hands, a fault and a force on
 * one, and the head-up display and a widget show both.
 */

#include "Rigs/EventCounter.h"
#include "Rigs/PlayedHardware.h"
#include "StyleRig.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticFunctionEditor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticRegionSource.h>
#include <vtkHapticRepresentation.h>
#include <vtkHapticWidget.h>

#include <algorithm>
#include <cstring>
#include <functional>

using namespace scenetest;

namespace
{
/// Calls a function at an event of a device, during the object's lifetime.
class Observed
{
public:
  Observed(vtkHapticDevice* device, unsigned long event, std::function<void()> call)
    : Device(device)
    , Call(std::move(call))
  {
    this->Command->SetClientData(&this->Call);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* function, void*)
      { (*static_cast<std::function<void()>*>(function))(); });
    device->AddObserver(event, this->Command);
  }
  Observed(const Observed&) = delete;
  Observed& operator=(const Observed&) = delete;
  ~Observed() { this->Device->RemoveObserver(this->Command); }

private:
  vtkHapticDevice* const Device;
  std::function<void()> Call;
  vtkNew<vtkCallbackCommand> Command;
};

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
  /// Returns a volume that displays the ball.
  vtkSmartPointer<vtkVolume> MakeVolume()
  {
    vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
    mapper->SetInputData(this->Ball);
    auto volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(mapper);
    ShowBall(volume);
    return volume;
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
  /// Presses the second tip 4 mm deep into the ball, beside its top. Returns true if a force acts
  /// on the device.
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
  // An observer may open a dialog, so no hand may be armed while the observer runs.
  std::vector<bool> wasArmed;
  const auto watch = [&]
  {
    return Observed(this->Device, vtkCommand::DisableEvent,
      [&] { wasArmed.push_back(this->Second->IsArmOrdered()); });
  };
  {
    const auto watched = watch();
    this->Press("Escape");
  }
  ASSERT_TRUE(this->AreArmed(false, false));
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  ASSERT_TRUE(this->PressSecond());
  {
    const auto watched = watch();
    this->Interactor->SetInteractorStyle(nullptr);
  }
  EXPECT_GE(wasArmed.size(), 2U);
  EXPECT_EQ(std::count(wasArmed.begin(), wasArmed.end(), true), 0);
  EXPECT_FALSE(IsArmed(this->Second)) << "the last state is shown from now on";
  EXPECT_EQ(Length(this->Second->GetState()->GetForce()), 0.0);
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
  PlayedHardware::Get().Stage = VolumeHaptics::DeviceStage::Lost;
  ASSERT_TRUE(this->Wait([this] { return this->Second->GetStatus() == vtkHapticDevice::FAULT; }));
  const MessageLog log(this->Second);
  this->Press("a");
  EXPECT_EQ(log.Errors.size(), 1U) << "it can't be armed";
  EXPECT_FALSE(this->Device->IsArmOrdered()) << "so the key lets the other hand go";
  PlayedHardware::Get().Stage = VolumeHaptics::DeviceStage::Ready;
}

TEST_F(StyleSecondHand, TheKeyLeavesAStoppedOneAlone)
{
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  this->Second->Stop();
  this->Press("a");
  EXPECT_FALSE(this->Device->IsArmOrdered());
  EXPECT_FALSE(this->Second->IsArmOrdered());
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
  // An observer may remove the second device.
  this->Second->Arm();
  {
    const auto watched = Observed(
      this->Second, vtkCommand::DisableEvent, [this] { this->Style->SetSecondDevice(nullptr); });
    this->Style->UpdateHaptics();
  }
  EXPECT_EQ(this->Style->GetSecondDevice(), nullptr);
  EXPECT_EQ(this->Log.Warnings.size(), 2U);
  this->Log.Warnings.clear();
}

TEST_F(StyleSecondHand, AStillVolumeOfItsOwnIsFeltBesideOneThatMoves)
{
  vtkNew<vtkVolumeHapticsFilter> still;
  still->SetInputData(0, this->Ball);
  still->GetProperty()->DeepCopy(this->Filter->GetProperty());
  this->Second->SetVolumeHaptics(still);
  vtkNew<vtkImageData> beats;
  beats->CopyStructure(this->Ball);
  beats->AllocateScalars(VTK_FLOAT, 2);
  beats->GetPointData()->GetScalars()->Fill(-1.0);
  this->Filter->SetFramesToComponents();
  this->Filter->SetInputData(0, beats);
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->HasTimeSteps(); }));
  this->Second->Arm();
  EXPECT_TRUE(this->PressSecond());
}

TEST_F(StyleSecondHand, TheFirstOneLeadsTheRegionsOfALargeVolume)
{
  vtkNew<vtkHapticRegionSource> source;
  source->SetWholeExtent(0, 1999, 0, 1999, 0, 1999);
  source->SetScalarType(VTK_UNSIGNED_CHAR);
  source->SetMemoryLimit(4194304);
  source->SetReader(
    [](const int box[6], void* samples)
    {
      const std::size_t count = static_cast<std::size_t>(box[1] - box[0] + 1) *
        static_cast<std::size_t>(box[3] - box[2] + 1) *
        static_cast<std::size_t>(box[5] - box[4] + 1);
      std::memset(samples, 1, count);
      return true;
    });
  this->Filter->SetInputConnection(0, source->GetOutputPort());
  this->Device->GetVirtualHand()->Place(500.0, 500.0, 500.0);
  this->Second->GetVirtualHand()->Place(1500.0, 1500.0, 1500.0);
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetState()->GetResidency() == 1.0; }));
  EXPECT_NE(this->Second->GetStatusText().find("around the other hand"), std::string::npos)
    << this->Second->GetStatusText();
}

TEST_F(StyleSecondHand, AHiddenVolumeLetsItGoWithoutTheFirst)
{
  const auto volume = this->MakeVolume();
  this->Renderer->AddVolume(volume);
  ASSERT_TRUE(this->Style->TouchVolume(volume));
  this->Device->Stop();
  for (const bool hasFirst : { true, false })
  {
    volume->VisibilityOn();
    this->Style->UpdateHaptics();
    this->Second->Arm();
    ASSERT_TRUE(this->Wait([this] { return IsArmed(this->Second); }));
    volume->VisibilityOff();
    this->Style->UpdateHaptics();
    EXPECT_FALSE(this->Second->IsArmOrdered()) << hasFirst;
    this->Style->SetDevice(nullptr);
  }
  EXPECT_EQ(this->Log.Warnings.size(), 2U);
  this->Log.Warnings.clear();
}

TEST_F(StyleSecondHand, TheEditorsWorkHoldsBoth)
{
  vtkNew<vtkHapticFunctionEditor> editor;
  editor->SetProperty(this->Filter->GetProperty());
  editor->SetInputData(MakeRamp());
  this->Style->SetFunctionEditor(editor);
  this->Press("a");
  ASSERT_TRUE(this->AreArmed(true, true));
  const EventCounter begins(this->Second, vtkCommand::StartEvent);
  const EventCounter ends(this->Second, vtkCommand::EndEvent);
  editor->Propose();
  EXPECT_EQ(begins.Count, 1);
  EXPECT_EQ(ends.Count, 1);
}

TEST_F(StyleSecondHand, TheFirstDeviceIsNotTheSecondOneToo)
{
  this->Style->SetSecondDevice(this->Device);
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("Open() another vtkHapticDevice"), std::string::npos);
  EXPECT_EQ(this->Style->GetSecondDevice(), this->Second);
  this->Log.Errors.clear();
  this->Style->SetDevice(this->Second);
  EXPECT_EQ(this->Style->GetSecondDevice(), nullptr) << "it is the first one now";
  this->Style->SetSecondDevice(this->Device);
  EXPECT_EQ(this->Style->GetSecondDevice(), this->Device);
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
  const auto volume = this->MakeVolume();
  this->Renderer->AddVolume(volume);
  vtkNew<vtkHapticWidget> widget;
  const MessageLog log(widget->GetStyle());
  widget->SetInteractor(this->Interactor);
  widget->SetSecondDevice(this->Second);
  widget->On();
  EXPECT_TRUE(this->Second->IsRunning());
  EXPECT_EQ(this->Second->GetVolumeHaptics(), widget->GetVolumeHaptics());
  EXPECT_TRUE(this->Renderer->HasViewProp(widget->GetSecondRepresentation()));
  EXPECT_EQ(
    widget->GetSecondRepresentation()->GetRadius(), widget->GetRepresentation()->GetRadius());
  EXPECT_EQ(widget->GetHeadUpDisplay()->GetSecondDevice(), this->Second);
  widget->SetSecondDevice(widget->GetDevice());
  EXPECT_EQ(log.Errors.size(), 1U);
  EXPECT_TRUE(this->Second->IsRunning()) << "the refused one leaves it";
  EXPECT_EQ(widget->GetHeadUpDisplay()->GetSecondDevice(), this->Second);
  vtkNew<vtkVolumeHapticsFilter> other;
  widget->SetVolumeHaptics(other);
  EXPECT_EQ(this->Second->GetVolumeHaptics(), other);
  widget->Off();
  EXPECT_FALSE(this->Second->IsRunning());
  EXPECT_FALSE(this->Renderer->HasViewProp(widget->GetSecondRepresentation()));
  EXPECT_TRUE(this->Second->IsOpen());
  widget->SetDevice(this->Second);
  EXPECT_EQ(widget->GetSecondDevice(), nullptr);
  EXPECT_EQ(widget->GetHeadUpDisplay()->GetSecondDevice(), nullptr);
}

TEST_F(StyleSecondHand, AWidgetTakesItDuringATouch)
{
  this->Interactor->SetInteractorStyle(nullptr);
  this->Style->SetSecondDevice(nullptr);
  const auto volume = this->MakeVolume();
  const auto beside = this->MakeVolume();
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->AddVolume(beside);
  this->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  this->Renderer->AddVolume(volume);
  this->Window->AddRenderer(right);
  vtkNew<vtkHapticWidget> widget;
  widget->SetInteractor(this->Interactor);
  this->Interactor->SetEventInformation(75, 150);
  widget->On();
  widget->SetTouchMode(true);
  ASSERT_TRUE(widget->GetTouchMode());
  this->Interactor->SetEventInformation(225, 150);
  widget->SetSecondDevice(this->Second);
  EXPECT_EQ(widget->GetStyle()->GetTouchedVolume(), volume) << "not what the pointer is on now";
  EXPECT_TRUE(this->Renderer->HasViewProp(widget->GetSecondRepresentation()));
  widget->SetSecondDevice(nullptr);
  EXPECT_EQ(widget->GetStyle()->GetTouchedVolume(), volume);
  EXPECT_FALSE(this->Renderer->HasViewProp(widget->GetSecondRepresentation()));
}
