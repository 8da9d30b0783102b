// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * How many time steps of a volume that moves are in memory at once, beside the one that its source
 * writes to: arrays that count themselves are played, and gone through.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/TimeSource.h"

#include <vtkDoubleArray.h>
#include <vtkObjectFactory.h>

#include <algorithm>

using namespace devicetest;

namespace
{
/// Samples of a time step; a copy is an array of the same kind, and counts.
class CountedArray : public vtkDoubleArray
{
public:
  static CountedArray* New() { VTK_STANDARD_NEW_BODY(CountedArray); }
  vtkTypeMacro(CountedArray, vtkDoubleArray);

  /// For what belongs to the source.
  void LeaveOut()
  {
    this->Counts = false;
    --Live;
  }

  static inline int Live = 0;
  static inline int Most = 0;

protected:
  CountedArray() { Most = std::max(Most, ++Live); }
  ~CountedArray() override { Live -= this->Counts ? 1 : 0; }

private:
  bool Counts = true;
};

class FrameMemory : public DeviceTest
{
protected:
  static constexpr int Steps = 9;

  FrameMemory()
  {
    for (int step = 0; step < Steps; ++step)
    {
      this->Source->Steps.push_back(step);
    }
    this->Source->Make = [](double time)
    {
      auto image = MakeImage(24, VTK_DOUBLE,
        [time](const Point& p) { return 500.0 * (1.0 - std::tanh((p[0] - 8.0 - time) / 1.5)); });
      vtkDataArray* const plain = image->GetPointData()->GetScalars();
      vtkNew<CountedArray> counted;
      counted->LeaveOut();
      counted->DeepCopy(plain);
      counted->SetName("counted");
      image->GetPointData()->SetScalars(counted);
      image->GetPointData()->RemoveArray("Density");
      return image;
    };
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "counted");
    this->Filter->SetTimeUnitsPerSecond(20.0);
    // Of the step that was felt while the volume stood still, there is none yet.
    CountedArray::Most = CountedArray::Live = 0;
  }

  void Begin()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->SetVirtualTip(12.0, 11.5, 11.5);
    this->Device->Play();
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() > 0.5; }));
  }

  /// The most steps that were in memory since the last call.
  static int TakeMost() { return std::exchange(CountedArray::Most, CountedArray::Live); }

  vtkNew<apitest::TimeSource> Source;
};
} // namespace

TEST_F(FrameMemory, HasThreeStepsAtMostWhileTimeRuns)
{
  this->Device->SetPlaybackToLoop();
  this->Begin();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() > Steps - 1.5; }));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() < 2.0; })) << "it goes on";
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() > 4.0; }));
  EXPECT_EQ(TakeMost(), 3) << "in a loop";
  this->Device->SetPlaybackToPingPong();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() > Steps - 1.5; }));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() < 2.0; })) << "it turns";
  EXPECT_EQ(TakeMost(), 3) << "to and fro";
  this->Device->SetPlaybackToLoop();
  this->Device->SetPlaybackSpeed(-1.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() > Steps - 1.5; }));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetDataTime() < 4.0; }));
  EXPECT_EQ(TakeMost(), 3) << "backward";
  this->Device->Stop();
  EXPECT_LE(CountedArray::Live, 3);
}

TEST_F(FrameMemory, HasFourForAMomentWhereAPersonGoesToAnotherTime)
{
  // The servo keeps the pair that is felt until it has the other one.
  this->Begin();
  this->Device->Hold();
  TakeMost();
  for (int i = 1; i < 40; ++i)
  {
    const double time = 0.3 + static_cast<double>(i * 5 % (Steps - 1)); // far from the last one
    this->Device->SetDataTime(time);
    ASSERT_TRUE(this->WaitTicks(2));
    ASSERT_TRUE(this->Wait(
      [&] { return this->Device->GetDataTime() == time && !this->Device->IsWaitingForData(); }))
      << time;
  }
  EXPECT_EQ(TakeMost(), 4);
  // The last pair of the old place goes, and the third step of the new one comes: then it is still.
  ASSERT_TRUE(this->WaitTicks(500));
  EXPECT_LE(CountedArray::Live, 3);
  TakeMost();
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_LE(TakeMost(), 3);
}
