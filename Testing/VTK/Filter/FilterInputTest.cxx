// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the samples are used in place: the filter neither copies nor changes them, and keeps a
 * reference while it executes.
 */

#include "Rigs/ApiRig.h"

#include "Core/Model/HapticModel.h"
#include "VTK/Filter/HapticBaker.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cstring>

using namespace apitest;

namespace
{
class FilterInput : public ApiTest
{
protected:
  vtkDataArray* Scalars() { return this->Image->GetPointData()->GetScalars(); }

  /// Calls `f` during the next update, after some ticks.
  void UnderWay(const std::function<void()>& f)
  {
    this->Callback = [this, f]
    {
      const double progress = this->Filter->GetProgress();
      if (progress > 0.1 && progress < 0.9)
      {
        f();
      }
    };
    this->Command->SetClientData(&this->Callback);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* callback, void*)
      { (*static_cast<std::function<void()>*>(callback))(); });
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }

  /// Sets a path of a tip that rests for 5000 ticks, so that progress events are sent.
  void Rest() { this->Filter->SetPathData(MakePath(std::vector<Point>(5000, { 7, 7, 7 }))); }

  std::function<void()> Callback;
  vtkNew<vtkCallbackCommand> Command;
};
} // namespace

TEST_F(FilterInput, InPlaceEditsAreFelt)
{
  this->Run(51);
  this->Scalars()->Fill(42.0);
  this->Scalars()->Modified();
  EXPECT_EQ(Get(this->Run(51), "Value", 0), 42.0);
}

TEST_F(FilterInput, SamplesAreNotCopied)
{
  this->Rest();
  // The filter reads the samples in place, so samples that are written during its execution affect
  // the output.
  this->UnderWay([&] { this->Scalars()->Fill(42.0); });
  vtkPolyData* const output = this->Run(5000);
  EXPECT_EQ(Get(output, "Value", 0), 700.0);
  EXPECT_EQ(Get(output, "Value", 4999), 42.0);
}

TEST_F(FilterInput, SamplesOutliveTheirImageWhileTheFilterRuns)
{
  this->Rest();
  const vtkWeakPointer<vtkDataArray> samples = this->Scalars();
  bool kept = true;
  int calls = 0;
  this->UnderWay(
    [&]
    {
      this->Image->GetPointData()->SetScalars(nullptr);
      kept = kept && samples != nullptr;
      ++calls;
    });
  vtkPolyData* const output = this->Run(5000);
  EXPECT_GT(calls, 1);
  EXPECT_TRUE(kept);
  EXPECT_EQ(Get(output, "Value", 4999), 700.0);
  EXPECT_EQ(samples, nullptr) << "and the filter keeps no reference afterwards";
}

TEST_F(FilterInput, InputsAreLeftAlone)
{
  vtkNew<vtkImageData> before;
  before->DeepCopy(this->Image);
  const vtkMTimeType times[] = { this->Image->GetMTime(), this->Path->GetMTime() };
  const int references = this->Scalars()->GetReferenceCount();
  this->Run(51);
  EXPECT_EQ(this->Image->GetMTime(), times[0]);
  EXPECT_EQ(this->Path->GetMTime(), times[1]);
  EXPECT_EQ(this->Scalars()->GetReferenceCount(), references);
  EXPECT_EQ(std::memcmp(this->Scalars()->GetVoidPointer(0),
              before->GetPointData()->GetScalars()->GetVoidPointer(0), 16 * 16 * 16 * 8),
    0);
}

// Bakes twice, as for a hand on a surface: each motion looks ahead for the surface with a separate
// model. Both models must share one bake.
TEST_F(FilterInput, IsBakedOnceForModelsThatComeAndGo)
{
  const auto bake = [this] { return this->Filter->GetBaker().Bake(1000.0, {}, nullptr); };
  const auto held = bake();
  ASSERT_TRUE(held);
  EXPECT_EQ(bake()->Baked, held->Baked);
  EXPECT_EQ(bake()->Baked, held->Baked) << "the model before is gone";
  this->Scalars()->Modified();
  EXPECT_NE(bake()->Baked, held->Baked);
}
