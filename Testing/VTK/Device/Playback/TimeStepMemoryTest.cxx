// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests how many time steps of a moving volume are in memory at the same time, besides the one that
 * the source writes. The time steps are arrays that count themselves while the test plays and
 * jumps.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/GivenImage.h"
#include "Rigs/TimeSource.h"

#include <vtkDoubleArray.h>
#include <vtkHapticTimeStepSource.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

using namespace devicetest;

namespace
{
/// Samples of a time step. Counts the arrays of this class, including copies.
class CountedArray : public vtkDoubleArray
{
public:
  static CountedArray* New() { VTK_STANDARD_NEW_BODY(CountedArray); }
  vtkTypeMacro(CountedArray, vtkDoubleArray);

  static inline bool OfSource = false; ///< new arrays belong to the source and are not counted
  static inline int Live = 0;
  static inline int Most = 0;

protected:
  CountedArray()
  {
    Live += this->Counts ? 1 : 0;
    Most = std::max(Most, Live);
  }
  ~CountedArray() override { Live -= this->Counts ? 1 : 0; }

private:
  const bool Counts = !OfSource;
};

class TimeStepMemory : public DeviceTest
{
protected:
  static constexpr int Steps = 9;

  TimeStepMemory()
  {
    for (int step = 0; step < Steps; ++step)
    {
      this->Source->Steps.push_back(step);
    }
    this->Source->Make = [](double time)
    {
      CountedArray::OfSource = true;
      auto image = MakeCounted(time);
      CountedArray::OfSource = false;
      return image;
    };
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "counted");
    this->Filter->SetTimeUnitsPerSecond(20.0);
    // Reset the counts, because one time step was in use before the playback.
    CountedArray::Most = CountedArray::Live = 0;
  }

  /// Makes a wall at x = 8 mm + `time`.
  static vtkSmartPointer<vtkImageData> MakeCounted(double time)
  {
    auto image = MakeImage(24, VTK_DOUBLE,
      [time](const Point& p) { return 500.0 * (1.0 - std::tanh((p[0] - 8.0 - time) / 1.5)); });
    vtkNew<CountedArray> counted;
    counted->DeepCopy(image->GetPointData()->GetScalars());
    counted->SetName("counted");
    image->GetPointData()->SetScalars(counted);
    image->GetPointData()->RemoveArray("Density");
    return image;
  }

  void Begin()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetPosition(12.0, 11.5, 11.5);
    this->Device->GetPlayback()->Play();
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > 0.5; }));
  }

  bool GoTo(double time)
  {
    this->Device->GetPlayback()->SetDataTime(time);
    return this->WaitTicks(2) &&
      this->Wait([this] { return !this->Device->GetPlayback()->IsWaitingForData(); });
  }

  /// Returns the value of the current time step at (12, 12, 12), or -1 without a time step.
  double GetFelt() const
  {
    vtkImageData* const image = this->Device->GetPlayback()->GetTimeStepImage();
    return image ? image->GetScalarComponentAsDouble(12, 12, 12, 0) : -1.0;
  }
  /// Returns the value at (12, 12, 12) of a wall at this x (mm).
  static double GetValue(double wall) { return 500.0 * (1.0 - std::tanh((12.0 - wall) / 1.5)); }

  /// Returns the largest number of time steps that were in memory since the last call.
  static int DrainMost() { return std::exchange(CountedArray::Most, CountedArray::Live); }

  vtkNew<apitest::TimeSource> Source;
};
} // namespace

TEST_F(TimeStepMemory, HasThreeStepsAtMostWhileTimeRuns)
{
  this->Device->GetPlayback()->SetModeToLoop();
  this->Begin();
  ASSERT_TRUE(
    this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > Steps - 1.5; }));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() < 2.0; }))
    << "it goes on";
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > 4.0; }));
  EXPECT_EQ(DrainMost(), 3) << "in a loop";
  this->Device->GetPlayback()->SetModeToPingPong();
  ASSERT_TRUE(
    this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > Steps - 1.5; }));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() < 2.0; }))
    << "it turns";
  EXPECT_EQ(DrainMost(), 3) << "to and fro";
  this->Device->GetPlayback()->SetModeToLoop();
  this->Device->GetPlayback()->SetSpeed(-1.0);
  ASSERT_TRUE(
    this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() > Steps - 1.5; }));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() < 4.0; }));
  EXPECT_EQ(DrainMost(), 3) << "backward";
  this->Device->Stop();
  EXPECT_LE(CountedArray::Live, 3);
}

/// After a jump to another data time, the servo keeps the two previous time steps until one of the
/// new time steps is read. Then it keeps only this new time step until the second one is read.
TEST_F(TimeStepMemory, HasThreeStepsAtMostWhereAPersonGoesToAnotherTime)
{
  this->Begin();
  for (const bool plays : { false, true })
  {
    for (const auto mode :
      { vtkHapticPlayback::ONCE, vtkHapticPlayback::LOOP, vtkHapticPlayback::PING_PONG })
    {
      for (const double speed : { 0.01, -0.01 })
      {
        this->Device->GetPlayback()->SetMode(mode);
        this->Device->GetPlayback()->SetSpeed(speed);
        plays ? this->Device->GetPlayback()->Play() : this->Device->GetPlayback()->Hold();
        for (int i = 1; i < Steps; ++i)
        {
          // Each time is far from the last one, and either between time steps or at a time step.
          const double time = (i % 3) * 0.4 + static_cast<double>(i * 5 % (Steps - 1));
          ASSERT_TRUE(this->GoTo(time)) << time;
          if (!plays)
          {
            EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), time);
          }
          EXPECT_LE(DrainMost(), 3) << time;
        }
      }
    }
  }
  EXPECT_LE(CountedArray::Live, 3);
}

/// Sets new data times before the servo has reached the last one, as dragging a slider does.
TEST_F(TimeStepMemory, HasThreeStepsAtMostWhileASliderIsDrawn)
{
  this->Begin();
  this->Device->GetPlayback()->Hold();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-1.0, Steps);
  for (int i = 0; i < 200; ++i)
  {
    this->Device->GetPlayback()->SetDataTime(
      i % 2 ? anywhere(random) : std::round(anywhere(random)));
    ASSERT_TRUE(this->WaitTicks(i % 4));
  }
  ASSERT_TRUE(this->GoTo(3.4));
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), 3.4);
  EXPECT_EQ(DrainMost(), 3);
}

/// Changes the data time while the servo is stopped.
TEST_F(TimeStepMemory, HasThreeStepsAtMostWhereItWasStoppedMeanwhile)
{
  this->Begin();
  for (const double time : { 7.3, 2.0, 5.5 })
  {
    this->Device->Stop();
    this->Device->GetPlayback()->SetDataTime(time);
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->WaitTicks(2));
    ASSERT_TRUE(this->Wait([this] { return !this->Device->GetPlayback()->IsWaitingForData(); }));
    EXPECT_GE(this->Device->GetPlayback()->GetDataTime(), time);
  }
  EXPECT_EQ(DrainMost(), 3);
}

/// An image that the application has requested must be released together with its time step.
TEST_F(TimeStepMemory, HasThreeStepsAtMostWhereOneWasShown)
{
  this->Begin();
  this->Device->GetPlayback()->Hold();
  for (int i = 1; i < 10; ++i)
  {
    ASSERT_NE(this->Device->GetPlayback()->GetTimeStepImage(), nullptr);
    ASSERT_TRUE(this->GoTo(static_cast<double>(i * 5 % (Steps - 1))));
    EXPECT_LE(DrainMost(), 3);
  }
}

/// Jumps to other data times with the method Surface Proxy, whose meshes take time to make.
TEST_F(TimeStepMemory, HasThreeStepsAtMostWithTheirMeshes)
{
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(500.0);
  this->Begin();
  this->Device->GetPlayback()->Hold();
  for (int i = 1; i < 20; ++i)
  {
    const double time = (i % 3) * 0.4 + static_cast<double>(i * 5 % (Steps - 1));
    ASSERT_TRUE(this->GoTo(time)) << time;
    // The proxy's sphere starts at the tip, in front of the wall, so no contact delays the data
    // time.
    EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), time);
    EXPECT_LE(DrainMost(), 3) << time;
  }
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// A new model must reuse the time steps of the last model without a copy.
TEST_F(TimeStepMemory, HasThreeStepsAtMostWhereSettingsChangeMeanwhile)
{
  this->Filter->SetIsoValue(500.0);
  this->Device->GetPlayback()->SetModeToLoop();
  this->Begin();
  vtkHapticProperty* const property = this->Filter->GetProperty();
  for (int i = 0; i < 60; ++i)
  {
    switch (i % 4)
    {
      case 0:
        property->GetStiffness()->RemoveAllPoints();
        property->GetStiffness()->AddPoint(0.0, 200.0 + i);
        break;
      case 1:
        this->Filter->SetKernelRadius(1 + i / 4 % 2);
        break;
      case 2:
        this->Filter->SetMethod(
          i % 8 == 2 ? vtkVolumeHapticsFilter::SURFACE_PROXY : vtkVolumeHapticsFilter::PROXY);
        break;
      default:
        this->Device->GetPlayback()->SetSpeed(i % 8 == 3 ? 1.0 : -1.0);
        break;
    }
    const double before = this->Device->GetPlayback()->GetDataTime();
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
    ASSERT_TRUE(this->WaitTicks(7 * (i % 5)));
    ASSERT_TRUE(this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() != before; }));
    EXPECT_LE(DrainMost(), 3) << i;
  }
  EXPECT_LE(CountedArray::Live, 3);
}

/// The device must read its time steps again after a change of the source, and after a switch to
/// another array.
TEST_F(TimeStepMemory, KeepsNoTimeStepOfAnotherVolume)
{
  this->Begin();
  this->Device->GetPlayback()->Hold();
  ASSERT_TRUE(this->GoTo(2.0));
  EXPECT_DOUBLE_EQ(this->GetFelt(), GetValue(10.0));
  this->Source->Make = [](double time) { return MakeCounted(time + 1.0); };
  this->Source->Modified();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(2));
  EXPECT_DOUBLE_EQ(this->GetFelt(), GetValue(11.0));
  this->Source->Make = [](double time)
  {
    auto image = MakeCounted(time + 1.0);
    vtkNew<vtkDoubleArray> other;
    other->DeepCopy(image->GetPointData()->GetScalars());
    other->SetName("other");
    other->FillValue(7.0);
    image->GetPointData()->AddArray(other);
    return image;
  };
  this->Source->Modified();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(2));
  EXPECT_DOUBLE_EQ(this->GetFelt(), GetValue(11.0));
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "other");
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(2));
  EXPECT_DOUBLE_EQ(this->GetFelt(), 7.0);
}

/// The device must also read its time steps again after a change of an algorithm further up the
/// pipeline.
TEST_F(TimeStepMemory, KeepsNoTimeStepOfAnEarlierStage)
{
  const vtkNew<apitest::GivenImage> stage;
  stage->SetInputConnection(this->Source->GetOutputPort());
  this->Filter->SetInputConnection(stage->GetOutputPort());
  this->Begin();
  this->Device->GetPlayback()->Hold();
  ASSERT_TRUE(this->GoTo(2.0));
  EXPECT_DOUBLE_EQ(this->GetFelt(), GetValue(10.0));
  this->Source->Make = [](double time) { return MakeCounted(time + 1.0); };
  this->Source->Modified();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(2));
  EXPECT_DOUBLE_EQ(this->GetFelt(), GetValue(11.0));
}

/// Passes two images at a time, as ParaView's animation does: the last one and the new one.
TEST_F(TimeStepMemory, HasThreeStepsOfAStreamAtMost)
{
  vtkNew<vtkHapticTimeStepSource> stream;
  stream->StreamedOn();
  vtkSmartPointer<vtkImageData> last = this->MakeCounted(0.0);
  double time = -1.0;
  const auto give = [&](double next)
  {
    // The servo no longer needs the time step before `last`, so the new one may be created.
    const vtkSmartPointer<vtkImageData> image = next == time ? last : this->MakeCounted(next);
    stream->RemoveAllTimeSteps();
    stream->AddTimeStep(last, time);
    stream->AddTimeStep(image, next);
    stream->Update();
    last = image;
    this->Device->GetPlayback()->SetSpeed(next < time ? -1.0 : 1.0);
    time = next;
  };
  give(0.0);
  this->Filter->SetInputConnection(stream->GetOutputPort());
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetPosition(12.0, 11.5, 11.5);
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->Device->Start());
  DrainMost();
  for (const double next : { 1.0, 2.0, 3.0, 7.0, 8.0, 0.0, 8.0, 7.0, 6.0, 2.0, 1.0, 0.0 })
  {
    give(next);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_TRUE(this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() == next; }))
      << next;
    EXPECT_LE(DrainMost(), 3) << next;
  }
}
