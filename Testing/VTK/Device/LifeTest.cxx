// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that devices, filters and images may be created and deleted in any order. */

#include "Rigs/DeviceRig.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkWeakPointer.h>

#include <fstream>

using namespace devicetest;

namespace
{
class DeviceLife : public DeviceTest
{
protected:
  static int CountThreads()
  {
    std::ifstream status("/proc/self/status");
    std::string word;
    int threads = -1;
    while (status >> word)
    {
      if (word == "Threads:")
      {
        status >> threads;
      }
    }
    return threads;
  }
};
} // namespace

TEST_F(DeviceLife, StartsAndStopsAThousandTimesWithoutLeavingAThread)
{
  this->Begin();
  this->Device->Stop();
  const int before = CountThreads();
  for (int i = 0; i < 1000; ++i)
  {
    ASSERT_TRUE(this->Device->Start());
    this->Device->Arm();
    this->Device->Stop();
  }
  EXPECT_EQ(CountThreads(), before);
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(DeviceLife, TheFilterAndTheImageMayGoWhileTheServoRuns)
{
  this->Begin();
  {
    vtkNew<vtkVolumeHapticsFilter> filter;
    filter->SetInputData(0, MakeRamp(20));
    this->Device->SetVolumeHaptics(filter);
    ASSERT_TRUE(this->Device->Publish());
  }
  this->Device->SetVolumeHaptics(nullptr);
  // Only the servo still has a reference to the image, and can use it.
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_LT(this->Device->GetState()->GetComputedForce()[2], -0.5);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(3));
  EXPECT_EQ(Length(this->Device->GetState()->GetComputedForce()), 0.0)
    << "without a filter: no touch";
}

TEST_F(DeviceLife, AnImageIsLetGoOnceItIsNoLongerTouched)
{
  this->Begin();
  vtkWeakPointer<vtkDataArray> scalars;
  {
    auto image = MakeRamp(20);
    scalars = image->GetPointData()->GetScalars();
    this->Filter->SetInputData(0, image);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_TRUE(this->WaitTicks(3));
    this->Filter->SetInputData(0, this->Image);
  }
  EXPECT_TRUE(scalars) << "the servo still touches it";
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Wait([&] { return !scalars; }));
}

TEST_F(DeviceLife, PublishingManyTimesWithoutLookingKeepsNoImages)
{
  this->Begin();
  std::vector<vtkWeakPointer<vtkDataArray>> images;
  for (int i = 0; i < 200; ++i)
  {
    auto image = MakeRamp(10);
    images.emplace_back(image->GetPointData()->GetScalars());
    this->Filter->SetInputData(0, image);
    ASSERT_TRUE(this->Device->Publish());
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  int kept = 0;
  for (const auto& image : images)
  {
    kept += image ? 1 : 0;
  }
  EXPECT_LT(kept, 200) << "only UpdateState lets go of them";
}

TEST_F(DeviceLife, MayBeDeletedWhileArmedAndRecording)
{
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkHapticDevice> device;
    device->SetVolumeHaptics(this->Filter);
    ASSERT_TRUE(device->Open("virtual"));
    device->GetVirtualHand()->SetPosition(7.0, 7.0, 7.0);
    ASSERT_TRUE(device->Start());
    device->Arm();
    ASSERT_TRUE(device->GetRecorder()->Start(this->File("Deleted.csv").c_str()));
  }
}

TEST_F(DeviceLife, PartsOutliveTheDevice)
{
  vtkSmartPointer<vtkHapticState> state;
  vtkSmartPointer<vtkHapticPlayback> playback;
  vtkSmartPointer<vtkHapticRecorder> recorder;
  vtkSmartPointer<vtkHapticVirtualHand> hand;
  {
    vtkNew<vtkHapticDevice> device;
    state = device->GetState();
    playback = device->GetPlayback();
    recorder = device->GetRecorder();
    hand = device->GetVirtualHand();
    ASSERT_TRUE(device->Open("virtual"));
    hand->Place(1.0, 2.0, 3.0);
    playback->SetSpeed(2.0);
    device->SetVolumeHaptics(this->Filter);
    ASSERT_TRUE(device->Start());
    ASSERT_TRUE(Eventually([&] { return device->UpdateState() && state->GetTick() > 2; }));
    EXPECT_EQ(device->GetState(), state) << "the parts stay the same";
    EXPECT_EQ(playback->GetSpeed(), 2.0);
  }
  EXPECT_NEAR(state->GetTipPosition()[2], 3.0, 1e-9) << "the last values stay";
  EXPECT_EQ(state->GetNeedleDepth(), 0.0);
  vtkNew<vtkPolyData> shapes;
  state->GetFollowed(shapes);
  EXPECT_EQ(shapes->GetNumberOfPoints(), 0);
  EXPECT_EQ(playback->GetSpeed(), 1.0);
  EXPECT_FALSE(playback->HasTimeSteps());
  EXPECT_EQ(recorder->GetFileName(), "");
  const MessageLog played(playback);
  playback->Play();
  ASSERT_EQ(played.Errors.size(), 1U);
  EXPECT_NE(
    played.Errors[0].find("take it from vtkHapticDevice::GetPlayback()"), std::string::npos);
  const MessageLog recorded(recorder);
  EXPECT_FALSE(recorder->Start("touch.vtp"));
  ASSERT_EQ(recorded.Errors.size(), 1U);
  EXPECT_NE(
    recorded.Errors[0].find("take it from vtkHapticDevice::GetRecorder()"), std::string::npos);
  const MessageLog led(hand);
  hand->SetPosition(0.0, 0.0, 0.0);
  ASSERT_EQ(led.Errors.size(), 1U);
  EXPECT_NE(
    led.Errors[0].find("take it from vtkHapticDevice::GetVirtualHand()"), std::string::npos);
}
