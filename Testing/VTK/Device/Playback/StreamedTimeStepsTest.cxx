// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests time steps that arrive one by one. A wall at x = 9 + t moves towards a tip that rests at
 * 12, by 1 mm per time step. The force is that of the spring to the wall.
 */

#include "Rigs/DeviceRig.h"

#include <vtkAlgorithmOutput.h>
#include <vtkHapticRegionFilter.h>
#include <vtkHapticTimeStepSource.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace devicetest;

namespace
{
constexpr double StreamedStiffness = 500.0;
constexpr double StreamedTip = 12.0;

/// Returns the force (N) of the wall at a data time on a proxy of this radius (mm).
double ForceOfTheStreamedWall(double time, double radius)
{
  return 0.001 * StreamedStiffness * std::max(0.0, 9.0 + time + radius - StreamedTip);
}

class StreamedTimeSteps : public DeviceTest
{
protected:
  StreamedTimeSteps()
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
    this->Source->RemoveAllTimeSteps();
    this->Source->AddTimeStep(this->MakeFrame(from, region), from);
    this->Source->AddTimeStep(this->MakeFrame(to, region), to);
  }
  void Begin(double end = 1.0)
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetPosition(StreamedTip, 19.0, 19.0);
    this->Device->GetPlayback()->SetSpeed(20.0);
    this->Device->GetPlayback()->Play();
    ASSERT_TRUE(this->Device->Start());
    this->GoTo(end);
  }
  /// Expects the force of the wall at the newest state's data time, and that the data time has not
  /// jumped.
  void Feel()
  {
    const double now = this->Device->GetPlayback()->GetDataTime();
    if (this->Device->GetTickRate() > 0.0)
    {
      EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[0],
        ForceOfTheStreamedWall(now, this->Radius), this->Tolerance)
        << "at " << now;
      // Compare with the servo's time, because this thread may pause.
      const double elapsed = this->Device->GetState()->GetTime() - this->FeltAt;
      if (this->FeltAt > 0.0)
      {
        EXPECT_LE(std::abs(now - this->Felt), this->Speed * elapsed + 0.02) << "a leap at " << now;
      }
      this->Felt = now;
      this->FeltAt = this->Device->GetState()->GetTime();
    }
  }
  void GoTo(double time)
  {
    ASSERT_TRUE(this->Wait(
      [&]
      {
        this->Feel();
        return this->Device->GetPlayback()->GetDataTime() == time;
      }))
      << time << ", but " << this->Device->GetPlayback()->GetDataTime();
  }
  void SetSpeed(double speed)
  {
    // Keep the largest speed, because the newest state may still have the earlier one.
    this->Speed = std::max(this->Speed, std::abs(speed));
    this->Device->GetPlayback()->SetSpeed(speed);
  }
  vtkNew<vtkHapticTimeStepSource> Source;
  double Radius = 0.0;
  double Tolerance = 0.02; ///< N, error of the expected force
  double Speed = 20.0;     ///< largest speed of the data time (1/s)
  double Felt = 0.0;       ///< data time of the last checked state
  double FeltAt = 0.0;     ///< servo time (s) of the last checked state
};
} // namespace

/// The wall moves by 6 mm per time step, which a blend can't represent.
TEST_F(StreamedTimeSteps, ThatAreTooFastForABlendAreToldOnce)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetPosition(StreamedTip, 19.0, 19.0);
  this->Device->GetPlayback()->Play();
  this->Give(0.0, 1.0);
  ASSERT_TRUE(this->Device->Start());
  EXPECT_TRUE(this->FilterLog.Warnings.empty());
  for (const double time : { 1.0, 7.0, 13.0 })
  {
    ASSERT_TRUE(this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() == time; }))
      << time;
    this->Give(time, time + 6.0);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_EQ(this->FilterLog.Warnings.size(), 1U) << "at " << time;
  }
}

TEST_F(StreamedTimeSteps, PushAHandThatRestsAndComeBack)
{
  this->Give(0.0, 1.0);
  this->Begin();
  for (int i = 1; i < 5; ++i)
  {
    this->Give(i, i + 1.0);
    ASSERT_TRUE(this->Device->Publish());
    this->GoTo(i + 1.0);
  }
  EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[0], 1.0, 0.02);
  this->Device->GetPlayback()->SetSpeed(-20.0);
  for (int i = 5; i > 1; --i)
  {
    this->Give(i, i - 1.0);
    ASSERT_TRUE(this->Device->Publish());
    this->GoTo(i - 1.0);
  }
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// Sends time steps at random moments, while the servo runs at its own pace. An early time step
/// waits; for a late one, the data time waits. The contact must never be lost.
TEST_F(StreamedTimeSteps, ThatAreEarlyOrLateAreFeltOneAfterTheOther)
{
  const int region[] = { 0, 35, 3, 37, 4, 39 };
  const int other[] = { 0, 38, 0, 34, 2, 36 };
  std::mt19937 random(3);
  this->Give(0.0, 1.0, region);
  this->Begin();
  this->SetSpeed(10.0); // a time step takes 100 ms
  double at = 1.0;
  int waited = 0;
  for (int i = 0; i < 24; ++i)
  {
    // The wall moves by 5 mm and back, 1 mm per time step.
    const double next = at + (i / 5 % 2 == 0 ? 1.0 : -1.0);
    this->Give(at, next, random() % 2 ? region : other);
    ASSERT_TRUE(this->Device->Publish());
    const bool isEarly = !this->Device->IsPublished();
    const std::string text = this->Device->GetStatusText();
    EXPECT_EQ(text.find("felt to their end") != std::string::npos, isEarly) << text;
    waited += isEarly ? 1 : 0;
    ASSERT_TRUE(this->Wait(
      [this]
      {
        this->Feel();
        return this->Device->IsPublished();
      }));
    this->SetSpeed(next < at ? -10.0 : 10.0);
    if (random() % 2)
    {
      this->GoTo(next);
      ASSERT_TRUE(this->WaitTicks(random() % 100));
    }
    else
    {
      ASSERT_TRUE(this->WaitTicks(random() % 60));
    }
    at = next;
  }
  this->GoTo(at);
  EXPECT_GT(waited, 4);
  EXPECT_GT(ForceOfTheStreamedWall(at, 0.0), 0.4);
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// If the stream has left out time steps, the last used time step is joined to the next ones, so
/// that the wall moves through the missing part.
TEST_F(StreamedTimeSteps, ThatWereLeftOutAreGoneOver)
{
  this->Tolerance = 0.03;
  this->Give(2.0, 3.0);
  this->Begin(3.0);
  this->SetSpeed(2.0);
  this->Give(3.0, 3.8);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > 3.1; }));
  // The next time steps replace the time steps 3.8 and 4.2 before the data time reaches them.
  // Later, the stream leaves out the part from 5.0 to 5.6.
  this->Give(3.8, 4.2);
  ASSERT_TRUE(this->Device->Publish());
  this->Give(4.2, 5.0);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_LT(this->Device->GetPlayback()->GetDataTime(), 3.8);
  this->GoTo(5.0);
  this->Give(5.6, 6.4);
  ASSERT_TRUE(this->Device->Publish());
  this->GoTo(6.4);
  EXPECT_GT(this->Device->GetState()->GetComputedForce()[0], 1.65);
  // The wall must also move through missing parts when the data time runs backwards, and after the
  // data time was held.
  this->Give(4.6, 5.4);
  ASSERT_TRUE(this->Device->Publish());
  this->SetSpeed(-2.0);
  this->GoTo(4.6);
  this->SetSpeed(2.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > 4.8; }));
  this->Device->GetPlayback()->Hold();
  ASSERT_TRUE(this->WaitTicks(20));
  const double held = this->Device->GetPlayback()->GetDataTime();
  this->Give(5.8, 6.4);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(50));
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), held);
  this->Feel();
  this->Device->GetPlayback()->Play();
  this->GoTo(6.4);
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// If the hand has left the region in memory, the data time waits until a region around the hand is
/// available.
TEST_F(StreamedTimeSteps, HoldTimeWhileARegionIsLate)
{
  const int region[] = { 0, 35, 3, 37, 4, 39 };
  const int other[] = { 0, 35, 0, 37, 0, 25 };
  this->Give(2.0, 3.0, region);
  this->Begin(3.0);
  this->SetSpeed(0.5);
  this->Give(3.0, 4.0, region);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > 3.1; }));
  this->Device->GetVirtualHand()->SetPosition(StreamedTip, 19.0, 1.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetResidency() == 0.0; }));
  ASSERT_TRUE(this->WaitTicks(5));
  const double held = this->Device->GetPlayback()->GetDataTime();
  EXPECT_GT(held, 3.1);
  EXPECT_LT(held, 4.0);
  ASSERT_TRUE(this->WaitTicks(300));
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), held)
    << "the wall goes past a hand that can't feel it";
  this->Give(3.0, 4.0, other);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetResidency() == 1.0; }));
  const double before = this->Device->GetPlayback()->GetDataTime();
  EXPECT_LT(before, 4.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 4.0; }));
  // After the gap, the proxy starts at the tip, and then the wall pushes the proxy.
  EXPECT_GT(this->Device->GetState()->GetComputedForce()[0],
    0.001 * StreamedStiffness * 0.5 * (4.0 - before));
}

/// When another region of the volume arrives, the servo must continue as if it had the whole
/// volume.
TEST_F(StreamedTimeSteps, MayBeRegionsOfAVolume)
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
  const double force = this->Device->GetState()->GetComputedForce()[0];
  EXPECT_NEAR(force, 1.0, 0.02);
  this->Give(4.0, 5.0, region);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(20));
  // Newton's method starts from the last tick's result, so the forces may differ by rounding
  // errors.
  EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[0], force, 1e-5);
  EXPECT_EQ(this->Device->GetState()->GetResidency(), 1.0);
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// Each time step has a mesh while the data time runs to the next one, even if the regions change.
TEST_F(StreamedTimeSteps, MayBeMeshes)
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
  EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[0], 1.5, 0.02);
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// A time step of another shape must start another volume or cause an error; it is never ignored
/// silently.
TEST_F(StreamedTimeSteps, OfAnotherShapeAreAnotherVolume)
{
  this->Give(0.0, 1.0);
  this->Begin();
  const auto small = MakeImage(30, VTK_FLOAT, [](const Point&) { return 7.0; });
  this->Source->RemoveAllTimeSteps();
  this->Source->AddTimeStep(small, 1.0);
  this->Source->AddTimeStep(small, 2.0);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 2.0; }));
  EXPECT_EQ(Length(this->Device->GetState()->GetComputedForce()), 0.0);
  this->Source->AddTimeStep(this->MakeFrame(3.0), 3.0);
  EXPECT_FALSE(this->Device->Publish());
  ASSERT_EQ(this->FilterLog.Errors.size(), 1U);
  EXPECT_NE(this->FilterLog.Errors[0].find("has another geometry"), std::string::npos);
  this->FilterLog.Errors.clear();
}
