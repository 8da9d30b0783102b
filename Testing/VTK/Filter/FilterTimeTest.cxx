// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A path through the time steps of a source: a wall comes towards a tip that rests, and the force
 * is the spring's to where the wall is, which is known at all times.
 */

#include "Rigs/ApiRig.h"

#include <vtkAlgorithmOutput.h>
#include <vtkDataArray.h>
#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace apitest;

namespace
{
/// V = 500 (1 - tanh((x - wall(t))/1.5)): a wall on the side of lower x.
vtkSmartPointer<vtkImageData> MakeWall(double wall, int n = 24, int type = VTK_DOUBLE)
{
  return MakeImage(
    n, type, [wall](const Point& p) { return 500.0 * (1.0 - std::tanh((p[0] - wall) / 1.5)); });
}

/// The wall of a time step, as a reader gives it: into the same memory each time.
class TimeSource : public vtkImageAlgorithm
{
public:
  static TimeSource* New();
  vtkTypeMacro(TimeSource, vtkImageAlgorithm);

  std::vector<double> Steps;
  std::function<vtkSmartPointer<vtkImageData>(double)> Make;
  std::vector<double> Asked;
  double FailsAt = std::numeric_limits<double>::quiet_NaN();

protected:
  TimeSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* const info = outputs->GetInformationObject(0);
    info->Set(Pipeline::WHOLE_EXTENT(), this->Make(this->Steps.front())->GetExtent(), 6);
    info->Set(Pipeline::TIME_STEPS(), this->Steps.data(), static_cast<int>(this->Steps.size()));
    const double range[] = { this->Steps.front(), this->Steps.back() };
    info->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* const info = outputs->GetInformationObject(0);
    const double time = info->Has(Pipeline::UPDATE_TIME_STEP())
      ? info->Get(Pipeline::UPDATE_TIME_STEP())
      : this->Steps.front();
    this->Asked.push_back(time);
    if (time == this->FailsAt)
    {
      return 0;
    }
    const auto made = this->Make(time);
    vtkDataArray* const array = made->GetPointData()->GetScalars();
    if (this->Memory && array && this->Memory->GetDataSize() == array->GetDataSize() &&
      this->Memory->GetDataType() == array->GetDataType())
    {
      std::memcpy(this->Memory->GetVoidPointer(0), array->GetVoidPointer(0),
        static_cast<std::size_t>(array->GetDataSize()) * array->GetDataTypeSize());
      made->GetPointData()->SetScalars(this->Memory);
    }
    else if (array)
    {
      this->Memory = array;
    }
    vtkImageData* const output = vtkImageData::GetData(info);
    output->ShallowCopy(made);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }

private:
  vtkSmartPointer<vtkDataArray> Memory;
};
vtkStandardNewMacro(TimeSource);

constexpr double K = 500.0;
constexpr double Rest = 12.0;

/// The wall is at 9 at time 10, and comes by 1 a step.
double WallAt(double time)
{
  return 9.0 + time - 10.0;
}

class FilterTime : public ApiTest
{
protected:
  FilterTime()
  {
    this->Source->Steps = { 10.0, 11.0, 12.0, 13.0, 14.0 };
    this->Source->Make = [](double time) { return MakeWall(WallAt(time)); };
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetMaterialPlacementToKernel();
    this->Property->GetSurfaceStrength()->AddPoint(0.0, 3.0);
    this->RestFor(1.0);
  }

  /// The tip rests for some seconds.
  void RestFor(double seconds)
  {
    const Point at{ Rest, 11.5, 11.5 };
    this->Filter->SetPathData(MakePath({ at, at }, { 0.0, seconds }));
  }

  vtkNew<TimeSource> Source;
};
} // namespace

TEST_F(FilterTime, AWallThatComesPushesATipThatRests)
{
  this->Filter->SetTimeUnitsPerSecond(4.0);
  vtkPolyData* const trace = this->Run(1001);
  for (vtkIdType tick = 0; tick <= 1000; ++tick)
  {
    const double time = 10.0 + 4.0 * 0.001 * static_cast<double>(tick);
    EXPECT_NEAR(Get(trace, "DataTime", tick), time, 1e-9);
    // A blend of two edges that are a voxel apart is off by 0.02 of their width at most.
    EXPECT_NEAR(Get(trace, "Force", tick), 0.001 * K * std::max(0.0, WallAt(time) - Rest), 0.015)
      << "tick " << tick;
  }
  // The first step comes with the image; then each comes once, and the first one last.
  EXPECT_EQ(this->Source->Asked, (std::vector<double>{ 10.0, 14.0, 13.0, 12.0, 11.0, 10.0 }));
  EXPECT_FALSE(
    this->Filter->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
}

TEST_F(FilterTime, OnlyTheStepsThatThePathNeedsAreRead)
{
  this->Filter->SetTimeUnitsPerSecond(1.5);
  vtkPolyData* const trace = this->Run(1001);
  EXPECT_EQ(this->Source->Asked, (std::vector<double>{ 10.0, 12.0, 11.0, 10.0 }));
  EXPECT_DOUBLE_EQ(Get(trace, "DataTime", 1000), 11.5);
}

TEST_F(FilterTime, TimeStopsAtTheLastStepAndTheForceStays)
{
  this->Filter->SetTimeUnitsPerSecond(8.0);
  vtkPolyData* const trace = this->Run(1001);
  EXPECT_DOUBLE_EQ(Get(trace, "DataTime", 1000), 14.0);
  EXPECT_NEAR(Get(trace, "Force", 1000), 0.5, 0.01);
  EXPECT_EQ(Get(trace, "Force", 600), Get(trace, "Force", 1000));
}

TEST_F(FilterTime, ItRunsBackwardsOnRequest)
{
  this->Filter->SetTimeUnitsPerSecond(-4.0);
  EXPECT_DOUBLE_EQ(Get(this->Run(1001), "DataTime", 1000), 10.0);
}

TEST_F(FilterTime, WithoutTimeOneStepIsFelt)
{
  this->Filter->SetTimeUnitsPerSecond(0.0);
  vtkPolyData* const trace = this->Run(1001);
  EXPECT_EQ(trace->GetPointData()->GetArray("DataTime"), nullptr);
  EXPECT_EQ(this->Source->Asked.size(), 1u);
  this->Filter->UpdateTimeStep(14.0);
  const auto fixed = Keep(this->Filter);
  vtkNew<vtkVolumeHapticsFilter> other;
  other->SetInputData(MakeWall(WallAt(14.0)));
  other->SetMaterialPlacementToKernel();
  other->GetProperty()->GetSurfaceStrength()->AddPoint(0.0, 3.0);
  other->SetPathData(vtkPolyData::SafeDownCast(this->Filter->GetInputDataObject(1, 0)));
  other->Update();
  EXPECT_TRUE(IsSame(fixed, Keep(other)));
}

TEST_F(FilterTime, StepsThatAreAlikeAreOneVolumeToTheBit)
{
  this->Source->Make = [](double) { return MakeWall(12.0); };
  const auto path = MakePath(Line({ 20, 11.5, 11.5 }, { 8, 11.1, 12.5 }, 900));
  this->Filter->SetPathData(path);
  this->Filter->SetTimeUnitsPerSecond(4.0);
  const auto moving = (this->Run(901), Keep(this->Filter));
  this->Filter->SetTimeUnitsPerSecond(0.0);
  const auto still = (this->Run(901), Keep(this->Filter));
  EXPECT_GT(Get(still, "NormalForce", 900), 0.5);
  moving->GetPointData()->RemoveArray("DataTime");
  EXPECT_TRUE(IsSame(moving, still));
}

TEST_F(FilterTime, StepsOfOtherGeometryAreAnError)
{
  this->Source->Make = [](double time) { return MakeWall(WallAt(time), time == 12.0 ? 20 : 24); };
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->ExpectError({ "time 12", "20 x 20 x 20", "vtkImageReslice", "SetTimeUnitsPerSecond(0)" });
  // And it goes on when they are right.
  this->Source->Make = [](double time) { return MakeWall(WallAt(time)); };
  this->Source->Modified();
  this->Log.Errors.clear();
  this->Run(1001);
}

TEST_F(FilterTime, StepsOfOtherTypesAreTaken)
{
  this->Filter->SetTimeUnitsPerSecond(4.0);
  const auto expected = (this->Run(1001), Keep(this->Filter));
  this->Source->Make = [](double time)
  { return MakeWall(WallAt(time), 24, time == 12.0 ? VTK_FLOAT : VTK_DOUBLE); };
  this->Source->Modified();
  vtkPolyData* const trace = this->Run(1001);
  for (vtkIdType tick = 0; tick <= 1000; tick += 10)
  {
    EXPECT_NEAR(Get(trace, "Force", tick), Get(expected, "Force", tick), 1e-4);
  }
}

TEST_F(FilterTime, AStepWithoutTheArrayIsAnError)
{
  this->Source->Make = [](double time)
  {
    const auto image = MakeWall(WallAt(time));
    if (time == 13.0)
    {
      image->GetPointData()->Initialize();
    }
    return image;
  };
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->ExpectError({ "time 13", "Give all time steps the same array" });
}

TEST_F(FilterTime, SamplesThatAreNotNumbersMakeNoForceThatIsNone)
{
  this->Source->Make = [](double time)
  {
    const auto image = MakeWall(WallAt(time));
    if (time == 13.0)
    {
      image->GetPointData()->GetScalars()->Fill(std::numeric_limits<double>::quiet_NaN());
    }
    return image;
  };
  this->Filter->SetTimeUnitsPerSecond(4.0);
  vtkPolyData* const trace = this->Run(1001);
  for (vtkIdType tick = 0; tick <= 1000; ++tick)
  {
    ASSERT_TRUE(std::isfinite(Get(trace, "Force", tick))) << "tick " << tick;
    ASSERT_LE(Get(trace, "NormalForce", tick), 3.0 + 1e-9);
  }
}

TEST_F(FilterTime, ASourceThatFailedHalfWayIsReadAnew)
{
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Source->FailsAt = 12.0;
  MessageLog sourceLog(this->Source->GetExecutive());
  this->ExpectError({ "time step", "input port 0", "SetTimeUnitsPerSecond(0)" });
  EXPECT_FALSE(sourceLog.Errors.empty());
  this->Log.Errors.clear();
  this->Source->FailsAt = std::numeric_limits<double>::quiet_NaN();
  this->Source->Modified();
  this->Source->Asked.clear();
  EXPECT_NEAR(Get(this->Run(1001), "Force", 1000), 0.5, 0.01);
  EXPECT_EQ(this->Source->Asked, (std::vector<double>{ 10.0, 14.0, 13.0, 12.0, 11.0, 10.0 }));
}

TEST_F(FilterTime, AMeshDoesNotMove)
{
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(500.0);
  this->ExpectError({ "SURFACE_PROXY", "SetTimeUnitsPerSecond(0)" });
}
