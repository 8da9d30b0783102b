// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests observers of vtkCommand::DisableEvent that call methods of the device that sends the event.
 */

#include "Rigs/DeviceRig.h"

#include <vtkCommand.h>
#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <functional>
#include <utility>

using namespace devicetest;

namespace
{
/// A source of a volume whose events the tests can observe.
class VolumeSource : public vtkImageAlgorithm
{
public:
  static VolumeSource* New();
  vtkTypeMacro(VolumeSource, vtkImageAlgorithm);

protected:
  VolumeSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Image->GetExtent(), 6);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkImageData::GetData(outputs)->ShallowCopy(this->Image);
    return 1;
  }

private:
  const vtkSmartPointer<vtkImageData> Image = MakeRamp();
};
vtkStandardNewMacro(VolumeSource);

class DeviceObservers : public DeviceTest
{
protected:
  /// Calls a function at every DisableEvent, and counts the events.
  void AtDisable(std::function<void(vtkHapticDevice*)> act)
  {
    this->Act = std::move(act);
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject* caller, unsigned long, void* self, void*)
      {
        auto* const test = static_cast<DeviceObservers*>(self);
        ++test->Calls;
        ASSERT_LT(test->Calls, 100) << "endless";
        test->Act(vtkHapticDevice::SafeDownCast(caller));
      });
    this->Device->AddObserver(vtkCommand::DisableEvent, this->Command);
  }

  int Calls = 0;
  vtkNew<vtkCallbackCommand> Command;

private:
  std::function<void(vtkHapticDevice*)> Act;
};
} // namespace

TEST_F(DeviceObservers, MayDisarmAndStopWhatTellsThem)
{
  using Method = void (vtkHapticDevice::*)();
  const Method methods[] = { &vtkHapticDevice::Disarm, &vtkHapticDevice::FadeOut,
    &vtkHapticDevice::Home, &vtkHapticDevice::Stop, &vtkHapticDevice::Close };
  Method react = nullptr;
  this->AtDisable([&react](vtkHapticDevice* device) { (device->*react)(); });
  for (const Method act : methods)
  {
    for (const Method method : methods)
    {
      react = method;
      ASSERT_TRUE(this->Device->Open("virtual"));
      ASSERT_TRUE(this->Device->Start());
      this->Device->Arm();
      this->Calls = 0;
      (this->Device->*act)();
      EXPECT_EQ(this->Calls, 1) << "told once";
      EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
      this->Device->Close();
      EXPECT_FALSE(this->Device->IsOpen());
    }
  }
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(DeviceObservers, MayOpenAnotherDeviceWhereOneIsClosed)
{
  this->AtDisable(
    [](vtkHapticDevice* device)
    {
      EXPECT_TRUE(device->Open("virtual"));
      EXPECT_TRUE(device->Start());
      device->Arm();
    });
  this->Begin();
  this->Device->Arm();
  this->Device->Close();
  EXPECT_FALSE(this->Device->IsOpen()) << "who closes has the last word";
  EXPECT_FALSE(this->Device->IsRunning());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::CLOSED);
  this->Begin();
  this->Device->Stop();
  EXPECT_FALSE(this->Device->IsRunning()) << "who stops, too";
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY);
}

TEST_F(DeviceObservers, AreToldAgainOfTheNextTime)
{
  this->AtDisable([](vtkHapticDevice* device) { device->Disarm(); });
  this->Begin();
  this->Calls = 0;
  for (int i = 1; i <= 3; ++i)
  {
    this->Device->Arm();
    this->Device->Disarm();
    EXPECT_EQ(this->Calls, i);
  }
}

TEST_F(DeviceObservers, MayLetGoOfTheLastReference)
{
  using Method = void (vtkHapticDevice::*)();
  for (const Method act : { &vtkHapticDevice::Disarm, &vtkHapticDevice::FadeOut,
         &vtkHapticDevice::Home, &vtkHapticDevice::Stop, &vtkHapticDevice::Close })
  {
    auto device = vtkSmartPointer<vtkHapticDevice>::New();
    const vtkWeakPointer<vtkHapticDevice> watched(device);
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&device);
    command->SetCallback([](vtkObject*, unsigned long, void* owner, void*)
      { *static_cast<vtkSmartPointer<vtkHapticDevice>*>(owner) = nullptr; });
    ASSERT_TRUE(device->Open("virtual"));
    ASSERT_TRUE(device->Start());
    device->AddObserver(vtkCommand::DisableEvent, command);
    (device.Get()->*act)();
    EXPECT_FALSE(watched);
  }
}

TEST_F(DeviceObservers, MayStartCloseAndOpenWhatIsBeingStarted)
{
  // Start() reads the volume. Then the source sends an EndEvent, whose observer acts on the device.
  vtkNew<VolumeSource> source;
  this->Filter->SetInputConnection(source->GetOutputPort());
  std::function<void()> act;
  vtkNew<vtkCallbackCommand> read;
  read->SetClientData(&act);
  read->SetCallback([](vtkObject*, unsigned long, void* act, void*)
    { std::exchange(*static_cast<std::function<void()>*>(act), [] {})(); });
  source->AddObserver(vtkCommand::EndEvent, read);

  bool hasStarted = false;
  ASSERT_TRUE(this->Device->Open("virtual"));
  act = [&] { hasStarted = this->Device->Start(); };
  source->Modified();
  EXPECT_TRUE(this->Device->Start());
  EXPECT_TRUE(hasStarted);
  EXPECT_TRUE(this->WaitTicks(20));
  EXPECT_TRUE(this->Log.Errors.empty());

  this->Device->Stop();
  act = [&] { this->Device->Close(); };
  source->Modified();
  EXPECT_FALSE(this->Device->Start());
  this->ExpectError("No device is open");
  EXPECT_FALSE(this->Device->IsRunning());

  ASSERT_TRUE(this->Device->Open("virtual"));
  act = [&] { EXPECT_TRUE(this->Device->Open("virtual")); };
  source->Modified();
  EXPECT_FALSE(this->Device->Start());
  this->ExpectError("Start() again");
  EXPECT_TRUE(this->Device->Start());
}
