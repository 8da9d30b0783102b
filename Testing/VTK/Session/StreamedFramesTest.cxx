// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Frames that come one by one: a wall at x = 9 + t comes towards a tip that rests at 12, 1 mm a
 * frame, and the force is the spring's to where it is.
 */

#include "Rigs/DeviceRig.h"

#include <vtkAlgorithmOutput.h>
#include <vtkHapticFrameSource.h>
#include <vtkHapticRegionFilter.h>

#include <cmath>

using namespace devicetest;

namespace
{
constexpr double StreamedStiffness = 500.0;
constexpr double StreamedTip = 12.0;

/// @param radius of a sphere that rests on the wall
double ForceOfTheStreamedWall(double time, double radius)
{
  return 0.001 * StreamedStiffness * std::max(0.0, 9.0 + time + radius - StreamedTip);
}

class StreamedFrames : public DeviceTest
{
protected:
  StreamedFrames()
  {
    SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 3.0);
    this->Filter->SetMaterialPlacementToKernel();
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Source->StreamedOn();
  }
  vtkSmartPointer<vtkImageData> MakeFrame(double time, const int* region = nullptr)
  {
    const auto whole = MakeImage(40, VTK_DOUBLE,
      [time](const Point& p) { return 500.0 * (1.0 - std::tanh((p[0] - 9.0 - time) / 1.5)); });
    if (!region)
    {
      return whole;
    }
    vtkNew<vtkHapticRegionFilter> cut;
    cut->SetInputData(whole);
    cut->SetRegion(region);
    cut->Update();
    auto part = vtkSmartPointer<vtkImageData>::New();
    part->ShallowCopy(cut->GetOutput());
    return part;
  }
  void Give(double from, double to, const int* region = nullptr)
  {
    this->Source->RemoveAllFrames();
    this->Source->AddFrame(this->MakeFrame(from, region), from);
    this->Source->AddFrame(this->MakeFrame(to, region), to);
  }
  void Begin()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->SetVirtualTip(StreamedTip, 19.0, 19.0);
    this->Device->SetPlaybackSpeed(20.0);
    this->Device->Play();
    ASSERT_TRUE(this->Device->Start());
    this->GoTo(1.0);
  }
  void GoTo(double time)
  {
    ASSERT_TRUE(this->Wait(
      [&]
      {
        const double now = this->Device->GetDataTime();
        if (this->Device->GetTickRate() > 0.0)
        {
          EXPECT_NEAR(
            this->Device->GetComputedForce()[0], ForceOfTheStreamedWall(now, this->Radius), 0.02)
            << "at " << now;
        }
        return now == time;
      }))
      << time;
  }
  vtkNew<vtkHapticFrameSource> Source;
  double Radius = 0.0;
};
} // namespace

/// Steps of 6 mm, which a blend can't show.
TEST_F(StreamedFrames, ThatAreTooFastForABlendAreToldOnce)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->SetVirtualTip(StreamedTip, 19.0, 19.0);
  this->Device->Play();
  this->Give(0.0, 1.0);
  ASSERT_TRUE(this->Device->Start());
  EXPECT_TRUE(this->FilterLog.Warnings.empty());
  for (const double time : { 1.0, 7.0, 13.0 })
  {
    this->Give(time, time + 6.0);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_EQ(this->FilterLog.Warnings.size(), 1U) << "at " << time;
  }
}

TEST_F(StreamedFrames, PushAHandThatRestsAndComeBack)
{
  this->Give(0.0, 1.0);
  this->Begin();
  for (int i = 1; i < 5; ++i)
  {
    this->Give(i, i + 1.0);
    ASSERT_TRUE(this->Device->Publish());
    this->GoTo(i + 1.0);
  }
  EXPECT_NEAR(this->Device->GetComputedForce()[0], 1.0, 0.02);
  this->Device->SetPlaybackSpeed(-20.0);
  for (int i = 5; i > 1; --i)
  {
    this->Give(i, i - 1.0);
    ASSERT_TRUE(this->Device->Publish());
    this->GoTo(i - 1.0);
  }
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// The servo goes on with another region, as if it had the whole.
TEST_F(StreamedFrames, MayBeRegionsOfAVolume)
{
  const int region[] = { 0, 35, 3, 37, 4, 39 };
  const int other[] = { 0, 38, 0, 34, 2, 36 };
  this->Give(0.0, 1.0, region);
  this->Begin();
  for (int i = 1; i < 5; ++i)
  {
    this->Give(i, i + 1.0, i % 2 ? region : other);
    ASSERT_TRUE(this->Device->Publish());
    this->GoTo(i + 1.0);
  }
  ASSERT_TRUE(this->WaitTicks(20));
  const double force = this->Device->GetComputedForce()[0];
  EXPECT_NEAR(force, 1.0, 0.02);
  this->Give(4.0, 5.0, region);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(20));
  // Newton's method goes on where the last tick on the way has left it.
  EXPECT_NEAR(this->Device->GetComputedForce()[0], force, 1e-5);
  EXPECT_EQ(this->Device->GetResidency(), 1.0);
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// Each has its mesh on the way to the next one, also if the regions change.
TEST_F(StreamedFrames, MayBeMeshes)
{
  const int region[] = { 0, 35, 3, 37, 4, 39 };
  this->Radius = 1.0;
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(500.0);
  this->Filter->SetProxyRadius(this->Radius);
  this->Give(0.0, 1.0);
  this->Begin();
  for (int i = 1; i < 5; ++i)
  {
    this->Give(i, i + 1.0, i < 3 ? nullptr : region);
    ASSERT_TRUE(this->Device->Publish());
    this->GoTo(i + 1.0);
  }
  EXPECT_NEAR(this->Device->GetComputedForce()[0], 1.5, 0.02);
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// What is no frame of the volume is another volume, or an error, and never lost.
TEST_F(StreamedFrames, OfAnotherShapeAreAnotherVolume)
{
  this->Give(0.0, 1.0);
  this->Begin();
  const auto small = MakeImage(30, VTK_FLOAT, [](const Point&) { return 7.0; });
  this->Source->RemoveAllFrames();
  this->Source->AddFrame(small, 1.0);
  this->Source->AddFrame(small, 2.0);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() == 2.0; }));
  EXPECT_EQ(Length(this->Device->GetComputedForce()), 0.0);
  this->Source->AddFrame(this->MakeFrame(3.0), 3.0);
  EXPECT_FALSE(this->Device->Publish());
  ASSERT_EQ(this->FilterLog.Errors.size(), 1U);
  EXPECT_NE(this->FilterLog.Errors[0].find("has another geometry"), std::string::npos);
  this->FilterLog.Errors.clear();
}
