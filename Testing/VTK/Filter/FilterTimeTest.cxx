// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a path through the time steps of a source. A wall moves towards a resting tip. The force is
 * that of the spring to the wall, whose position is known at all times.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/TimeSource.h"

#include <vtkAlgorithmOutput.h>
#include <vtkAppendFilter.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkPointData.h>
#include <vtkResampleToImage.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

using namespace apitest;

namespace
{
/// Makes V = 500 (1 - tanh((x - wall)/1.5)), a wall that fills the space below x = `wall`.
vtkSmartPointer<vtkImageData> MakeWall(double wall, int n = 24, int type = VTK_DOUBLE)
{
  return MakeImage(
    n, type, [wall](const Point& p) { return 500.0 * (1.0 - std::tanh((p[0] - wall) / 1.5)); });
}

constexpr double K = 500.0;
constexpr double Rest = 12.0;

/// Returns the x coordinate (mm) of the wall: 9 at time 10, increasing by 1 per unit of time.
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

  /// Sets a path on which the tip rests for this time (s).
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
    // A blend of two edges that are one voxel apart has an error of at most 0.02 of their width.
    EXPECT_NEAR(Get(trace, "Force", tick), 0.001 * K * std::max(0.0, WallAt(time) - Rest), 0.015)
      << "tick " << tick;
  }
  // The image provides the time step 10. Then the filter must read each time step once, from 14
  // back to 10.
  EXPECT_EQ(this->Source->Asked, (std::vector<double>{ 10.0, 14.0, 13.0, 12.0, 11.0, 10.0 }));
  EXPECT_FALSE(
    this->Filter->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
}

/// A grid is resampled around the tip, so it stays at its first time step and causes one warning.
/// vtkResampleToImage, which the warning suggests, must make it move.
TEST_F(FilterTime, AGridThatMovesIsFeltAsTheImagesOfItsSteps)
{
  vtkNew<vtkAppendFilter> grid;
  grid->SetInputConnection(this->Source->GetOutputPort());
  this->Filter->SetInputConnection(grid->GetOutputPort());
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Filter->Update();
  const auto still = Keep(this->Filter);
  EXPECT_EQ(Get(still, "Force", 1000), Get(still, "Force", 0)) << "the first step stays";
  ASSERT_EQ(this->Log.Warnings.size(), 1u);
  for (const char* const part : { "vtkUnstructuredGrid", "5 time steps", "vtkResampleToImage" })
  {
    EXPECT_NE(this->Log.Warnings.front().find(part), std::string::npos) << part;
  }
  this->RestFor(0.5);
  this->Filter->Update();
  EXPECT_EQ(this->Log.Warnings.size(), 1u) << "once for a series";
  this->RestFor(1.0);
  this->Log.Warnings.clear();

  vtkNew<vtkResampleToImage> image;
  image->SetInputConnection(grid->GetOutputPort());
  image->SetSamplingDimensions(24, 24, 24);
  this->Filter->SetInputConnection(image->GetOutputPort());
  image->UpdateInformation();
  image->Update();
  const char* const name = image->GetOutput()->GetPointData()->GetArrayName(0);
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
  vtkPolyData* const trace = this->Run(1001);
  EXPECT_DOUBLE_EQ(Get(trace, "DataTime", 1000), 14.0);
  EXPECT_NEAR(Get(trace, "Force", 1000), 0.001 * K * (WallAt(14.0) - Rest), 0.015);
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

/// A path begins at the first time step, so the data time can't run backwards from there.
TEST_F(FilterTime, BackwardsThereIsNothingButTheFirstStep)
{
  this->Filter->SetTimeUnitsPerSecond(-4.0);
  const auto backwards = (this->Run(1001), Keep(this->Filter));
  EXPECT_DOUBLE_EQ(Get(backwards, "DataTime", 500), 10.0);
  EXPECT_EQ(this->Source->Asked.back(), 10.0);
  backwards->GetPointData()->RemoveArray("DataTime");
  this->Filter->SetTimeUnitsPerSecond(0.0);
  EXPECT_TRUE(IsSame(backwards, (this->Run(1001), Keep(this->Filter))));
}

TEST_F(FilterTime, StepsMayBeGivenInAnyOrder)
{
  this->Filter->SetTimeUnitsPerSecond(4.0);
  const auto expected = (this->Run(1001), Keep(this->Filter));
  EXPECT_GT(Get(expected, "Force", 1000), 0.4);
  this->Source->Steps = { 14.0, 13.0, 11.0, std::numeric_limits<double>::quiet_NaN(), 12.0, 11.0,
    10.0 };
  this->Source->Modified();
  EXPECT_TRUE(IsSame(expected, (this->Run(1001), Keep(this->Filter))));
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
  // The filter must work again when all images have the same size.
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

/// Only the touched array has time steps, so modes' arrays would stand still while the volume
/// moves.
TEST_F(FilterTime, ModesOfAVolumeThatMovesAreRefusedUnlessTimeStandsStill)
{
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Filter->SetMethodToPrimitives();
  this->ExpectError({ "PRIMITIVES", "one time", "several frames", "SetTimeUnitsPerSecond(0)" });
  this->Filter->SetTimeUnitsPerSecond(0.0);
  this->Run(1001);
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

namespace
{
/// Makes the time steps of FilterTime as components of one array, at times from 0 onwards, or five
/// copies of the time step at `always`. Both arrays have the same stride, so that sums have the
/// same order of additions.
vtkSmartPointer<vtkImageData> MakeComponents(int type, double always = -1.0)
{
  const auto image = MakeWall(WallAt(10.0), 24, type);
  const auto frames = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  frames->SetName("frames");
  frames->SetNumberOfComponents(5);
  frames->SetNumberOfTuples(image->GetNumberOfPoints());
  for (int frame = 0; frame < 5; ++frame)
  {
    const auto wall = MakeWall(WallAt(10.0 + (always < 0.0 ? frame : always)), 24, type);
    frames->CopyComponent(frame, wall->GetPointData()->GetScalars(), 0);
  }
  image->GetPointData()->SetScalars(frames);
  return image;
}

class FilterComponents : public FilterTime
{
protected:
  FilterComponents() { this->Filter->SetTimeUnitsPerSecond(4.0); }

  /// Returns the trace of the same time steps in separate images of this type.
  vtkSmartPointer<vtkPolyData> FeelSteps(int type)
  {
    this->Source->Steps = { 0.0, 1.0, 2.0, 3.0, 4.0 };
    this->Source->Make = [type](double time) { return MakeComponents(type, time); };
    this->Source->Modified();
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetFramesToTimeSteps();
    this->Run(1001);
    return Keep(this->Filter);
  }
};
} // namespace

TEST_F(FilterComponents, AreTimeStepsToTheBit)
{
  for (const int type : { VTK_SHORT, VTK_DOUBLE })
  {
    const auto steps = this->FeelSteps(type);
    EXPECT_GT(Get(steps, "Force", 1000), 0.4);
    const auto image = MakeComponents(type);
    const long memory = static_cast<long>(image->GetActualMemorySize());
    this->Filter->SetInputData(image);
    this->Filter->SetFramesToComponents();
    this->Property->SetComponent(3); // has no effect
    this->Run(1001);
    EXPECT_TRUE(IsSame(Keep(this->Filter), steps)) << "type " << type;
    EXPECT_EQ(static_cast<long>(image->GetActualMemorySize()), memory);
    // With time steps twice as far apart, and the data time at twice the speed, each time step must
    // occur at the same tick.
    this->Filter->SetFrameSpacing(2.0);
    this->Filter->SetTimeUnitsPerSecond(8.0);
    vtkPolyData* const slow = this->Run(1001);
    EXPECT_DOUBLE_EQ(Get(slow, "DataTime", 500), 4.0);
    EXPECT_NEAR(Get(slow, "Force", 700), Get(steps, "Force", 700), 1e-9);
    this->Filter->SetFrameSpacing(1.0);
    this->Filter->SetTimeUnitsPerSecond(4.0);
    this->Property->SetComponent(0);
  }
}

TEST_F(FilterComponents, OneComponentStandsStillOnRequest)
{
  this->Filter->SetInputData(MakeComponents(VTK_DOUBLE));
  this->Filter->SetFramesToComponents();
  this->Filter->SetTimeUnitsPerSecond(0.0);
  this->Property->SetComponent(4); // the wall of this component is 1 mm beyond the tip
  vtkPolyData* const trace = this->Run(1001);
  EXPECT_EQ(trace->GetPointData()->GetArray("DataTime"), nullptr);
  this->Filter->SetInputData(MakeWall(WallAt(14.0)));
  this->Property->SetComponent(0);
  const auto fixed = Keep(this->Filter);
  EXPECT_EQ(Get(this->Run(1001), "Force", 1000), Get(fixed, "Force", 1000));
}

TEST_F(FilterComponents, OneAloneIsAnError)
{
  this->Filter->SetInputData(MakeWall(12.0));
  this->Filter->SetFramesToComponents();
  this->ExpectError({ "one component", "TimeAsVectorOn", "SetFramesToTimeSteps()" });
}

TEST_F(FilterComponents, HaveNoDisplacements)
{
  this->Filter->SetInputData(MakeComponents(VTK_DOUBLE));
  this->Filter->SetFramesToComponents();
  this->Filter->SetDisplacementArrayName("motion");
  this->ExpectError({ "\"frames\"", "no displacements", "SetDisplacementArrayName(\"\")" });
}

TEST_F(FilterComponents, OfANiftiFileAreItsTimes)
{
  const auto steps = this->FeelSteps(VTK_SHORT);
  const std::string file = testing::TempDir() + "FilterComponents.nii";
  vtkNew<vtkNIFTIImageWriter> writer;
  writer->SetInputData(MakeComponents(VTK_SHORT));
  writer->SetTimeDimension(5);
  writer->SetTimeSpacing(0.25);
  writer->SetFileName(file.c_str());
  writer->Write();
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(file.c_str());
  reader->TimeAsVectorOn();
  reader->Update();
  ASSERT_EQ(reader->GetTimeDimension(), 5);
  this->Filter->SetInputConnection(reader->GetOutputPort());
  this->Filter->SetFramesToComponents();
  this->Filter->SetFrameSpacing(reader->GetTimeSpacing());
  this->Filter->SetTimeUnitsPerSecond(1.0); // times in NIfTI files are in seconds
  vtkPolyData* const trace = this->Run(1001);
  EXPECT_DOUBLE_EQ(Get(trace, "DataTime", 600), 0.6);
  for (vtkIdType tick = 0; tick <= 1000; tick += 20)
  {
    EXPECT_NEAR(Get(trace, "Force", tick), Get(steps, "Force", tick), 1e-6) << "tick " << tick;
  }
  std::remove(file.c_str());
}

namespace
{
/// Tests a wall that jumps by four times its width per time step. The array "motion" contains the
/// displacements.
class FilterMotion : public FilterTime
{
protected:
  FilterMotion()
  {
    this->Source->Steps = { 10.0, 11.0, 12.0 };
    this->Source->Make = [](double time) { return MakeLeap(time, VTK_DOUBLE); };
    this->Filter->SetTimeUnitsPerSecond(1.6);
    this->Filter->SetDisplacementArrayName("motion");
  }

  static double LeapAt(double time) { return 5.0 + 6.0 * (time - 10.0); }

  static vtkSmartPointer<vtkImageData> MakeLeap(double time, int type, int components = 3)
  {
    const auto image = MakeWall(LeapAt(time));
    const auto motion = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    motion->SetName("motion");
    motion->SetNumberOfComponents(components);
    motion->SetNumberOfTuples(image->GetNumberOfPoints());
    motion->Fill(0.0);
    motion->FillComponent(0, 6.0);
    image->GetPointData()->AddArray(motion);
    return image;
  }

  /// Changes the arrays of the time step at `at`.
  void Change(double at, const std::function<void(vtkPointData*)>& change)
  {
    this->Source->Make = [=](double time)
    {
      const auto image = MakeLeap(time, VTK_DOUBLE);
      if (time == at)
      {
        change(image->GetPointData());
      }
      return image;
    };
  }

  void ExpectLeap()
  {
    vtkPolyData* const trace = this->Run(1001);
    for (vtkIdType tick = 0; tick <= 1000; ++tick)
    {
      const double wall = LeapAt(10.0 + 1.6e-3 * static_cast<double>(tick));
      EXPECT_NEAR(Get(trace, "Force", tick), 0.001 * K * std::max(0.0, wall - Rest), 0.012)
        << "tick " << tick;
    }
  }
};
} // namespace

TEST_F(FilterMotion, AWallThatLeapsIsFeltOnItsWay)
{
  this->ExpectLeap();
  // Without displacements, the wall stays at its place, and then appears at the next place.
  this->Filter->SetDisplacementArrayName("");
  this->Filter->Update(); // warns
  vtkPolyData* const trace = this->Filter->GetOutput();
  EXPECT_LT(Get(trace, "Force", 800), 0.001 * K * 0.3); // the wall is 0.68 mm beyond the tip
}

TEST_F(FilterMotion, ABlendThatIsNoMotionWarnsOnce)
{
  this->Run(1001);
  EXPECT_TRUE(this->Log.Warnings.empty());
  this->Filter->SetDisplacementArrayName("");
  this->Filter->Update();
  ASSERT_EQ(this->Log.Warnings.size(), 1u);
  const std::string& warning = this->Log.Warnings.front();
  for (const char* part : { "input port 0", "by about 6", "from time 1", " to time 1", " wide",
         "to a width of 3", "vtkImageGaussianSmooth", "SetDisplacementArrayName" })
  {
    EXPECT_NE(warning.find(part), std::string::npos) << part << " in " << warning;
  }
  this->Filter->SetTimeUnitsPerSecond(1.5);
  this->Filter->Update();
  EXPECT_EQ(this->Log.Warnings.size(), 1u);
  this->Source->Modified();
  this->Filter->Update();
  EXPECT_EQ(this->Log.Warnings.size(), 2u);
}

TEST_F(FilterTime, ABlendThatIsAMotionDoesNotWarn)
{
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Run(1001);
  EXPECT_TRUE(this->Log.Warnings.empty());
}

TEST_F(FilterMotion, DisplacementsMayHaveAnyType)
{
  for (const int type : { VTK_FLOAT, VTK_INT })
  {
    this->Source->Make = [type](double time) { return MakeLeap(time, type); };
    this->Source->Modified();
    this->ExpectLeap();
  }
}

TEST_F(FilterMotion, TheLastStepNeedsNone)
{
  this->Change(12.0, [](vtkPointData* data) { data->RemoveArray("motion"); });
  this->ExpectLeap();
}

TEST_F(FilterMotion, AStepWithoutDisplacementsIsAnError)
{
  this->Change(11.0, [](vtkPointData* data) { data->RemoveArray("motion"); });
  this->ExpectError({ "time 11", "\"motion\"", "SetDisplacementArrayName(\"\")" });
}

TEST_F(FilterMotion, DisplacementsOfTwoComponentsAreAnError)
{
  this->Source->Make = [](double time) { return MakeLeap(time, VTK_DOUBLE, 2); };
  this->ExpectError({ "time 10", "\"motion\"", "2 components", "have three" });
}

TEST_F(FilterMotion, OtherNumbersOfDisplacementsAreAnError)
{
  this->Change(11.0, [](vtkPointData* data) { data->GetArray("motion")->SetNumberOfTuples(1000); });
  this->ExpectError({ "time 11", "1000 displacements for 13824 points" });
}

TEST_F(FilterMotion, DisplacementsThatAreNotNumbersAreAnError)
{
  this->Change(
    11.0, [](vtkPointData* data) { data->GetArray("motion")->SetComponent(77, 1, std::nan("")); });
  this->ExpectError({ "time 11", "\"motion\"", "point 77", "not finite" });
}
