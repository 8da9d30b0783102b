// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that the filter executes only if something changed that affects its output. */

#include "Rigs/ApiRig.h"
#include "Rigs/EventCounter.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkTrivialProducer.h>
#include <vtkVolumeProperty.h>

using namespace apitest;

namespace
{
class FilterExecution : public ApiTest
{
protected:
  FilterExecution() { this->Run(51); }

  /// Returns how often the filter executes in two updates after a change.
  int RunsAfter(const std::function<void()>& change)
  {
    change();
    this->Executions.Count = 0;
    this->Filter->Update();
    this->Filter->Update();
    return this->Executions.Count;
  }

  EventCounter Executions{ this->Filter, vtkCommand::EndEvent };
};
} // namespace

TEST_F(FilterExecution, NothingChanged)
{
  EXPECT_EQ(this->RunsAfter([] {}), 0);
}

TEST_F(FilterExecution, LookingAtThePropertyIsNoChange)
{
  EXPECT_EQ(this->RunsAfter(
              [&]
              {
                this->Filter->GetProperty()->GetStiffness();
                this->Filter->GetProperty()->GetDistinctness();
                this->Filter->GetProperty()->GetVisibilityFrom();
              }),
    0);
}

TEST_F(FilterExecution, PropertyAndItsFunctions)
{
  vtkNew<vtkVolumeProperty> volume;
  vtkNew<vtkHapticProperty> other;
  const vtkSmartPointer<vtkHapticProperty> former = this->Property;
  vtkNew<vtkPiecewiseFunction> function;
  const std::function<void()> changes[] = {
    [&] { this->Property->GetStiffness()->AddPoint(0.0, 100.0); },
    [&] { this->Property->GetFriction()->AddPoint(0.0, 0.1); },
    [&] { this->Property->GetViscosity()->AddPoint(0.0, 0.1); },
    [&] { this->Property->GetSurfaceStrength()->AddPoint(0.0, 0.1); },
    [&] { this->Property->GetDistinctness()->AddPoint(0.0, 0.1); },
    [&] { this->Property->SetFriction(function); },
    [&] { function->AddPoint(0.0, 0.2); },
    [&] { this->Property->SetSurfaceSideToBoth(); },
    [&] { this->Property->SetVisibilityFrom(volume); },
    [&] { volume->GetScalarOpacity()->AddPoint(0.0, 1.0); },
    [&] { this->Property->ApplyPreset("MRI"); },
    [&] { this->Filter->SetProperty(other); },
  };
  int number = 0;
  for (const std::function<void()>& change : changes)
  {
    EXPECT_EQ(this->RunsAfter(change), 1) << "change " << number++;
  }
  EXPECT_EQ(this->RunsAfter([&] { former->GetFriction()->AddPoint(0.0, 0.7); }), 0)
    << "the former property has nothing to say any more";
}

TEST_F(FilterExecution, ImagePathAndSettings)
{
  EXPECT_EQ(this->RunsAfter([&] { this->Image->Modified(); }), 1);
  EXPECT_EQ(this->RunsAfter([&] { this->Image->GetPointData()->GetScalars()->Modified(); }), 1);
  EXPECT_EQ(this->RunsAfter([&] { this->Path->GetPoints()->Modified(); }), 1);
  EXPECT_EQ(this->RunsAfter([&] { this->Filter->SetPathData(MakePath({ { 7, 7, 7 } })); }), 1);
  EXPECT_EQ(this->RunsAfter([&] { this->Filter->SetKernelRadius(1); }), 1);
  EXPECT_EQ(this->RunsAfter([&] { this->Filter->SetInputDataObject(0, MakeRamp(12)); }), 1);
}

TEST_F(FilterExecution, PathFromAPipeline)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(this->Path);
  this->Filter->SetPathConnection(producer->GetOutputPort());
  const auto kept = (this->Filter->Update(), Keep(this->Filter));
  EXPECT_EQ(this->Filter->GetInputConnection(1, 0), producer->GetOutputPort());
  this->Filter->SetPathData(this->Path);
  this->Filter->Update();
  EXPECT_TRUE(IsSame(kept, this->Filter->GetOutput()));
}
