// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Devices, filters and images come and go in any order.
 */

#include "Rigs/DeviceRig.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
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
  // The servo touches the image that only it holds now.
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_LT(this->Device->GetComputedForce()[2], -0.5);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(3));
  EXPECT_EQ(Length(this->Device->GetComputedForce()), 0.0) << "without a filter: no touch";
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
    device->SetVirtualTip(7.0, 7.0, 7.0);
    ASSERT_TRUE(device->Start());
    device->Arm();
    ASSERT_TRUE(device->StartRecording(this->File("Deleted.csv").c_str()));
  }
}
