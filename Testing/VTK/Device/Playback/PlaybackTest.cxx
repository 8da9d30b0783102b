// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a device in a moving volume: a wall moves towards a resting tip. The force is that of the
 * spring to the wall, whose position is known at all times. Recordings must replay bitwise.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/TimeSource.h"

#include <vtkAlgorithmOutput.h>
#include <vtkAppendFilter.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkResampleToImage.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace devicetest;

namespace
{
constexpr double WallStiffness = 500.0;
constexpr double TipRests = 12.0;

/// Returns the x coordinate (mm) of the wall: 9 at time 10, increasing by 1 per unit of time.
double ComputeWall(double time)
{
  return 9.0 + time - 10.0;
}

vtkSmartPointer<vtkImageData> MakeWallStep(double time, int n = 24, int type = VTK_DOUBLE)
{
  return MakeImage(n, type,
    [time](const Point& p) { return 500.0 * (1.0 - std::tanh((p[0] - ComputeWall(time)) / 1.5)); });
}

class PlaybackOfSteps : public DeviceTest
{
protected:
  PlaybackOfSteps()
  {
    this->Source->Steps = { 10.0, 11.0, 12.0, 13.0, 14.0 };
    this->Source->Make = [](double time) { return MakeWallStep(time); };
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetMaterialPlacementToKernel();
    this->Filter->GetProperty()->GetSurfaceStrength()->RemoveAllPoints();
    this->Filter->GetProperty()->GetSurfaceStrength()->AddPoint(0.0, 3.0);
  }

  void Rest()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetPosition(TipRests, 11.5, 11.5);
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->WaitTicks(2));
  }

  /// Calls `look` for each new state during this time (s) of the servo.
  void Watch(double seconds, const std::function<void()>& look)
  {
    const double end = this->Device->GetState()->GetTime() + seconds;
    ASSERT_TRUE(Eventually(
      [&]
      {
        if (this->Device->UpdateState())
        {
          look();
        }
        return this->Device->GetState()->GetTime() >= end;
      }));
  }

  void ExpectFilterError(const std::string& words)
  {
    ASSERT_EQ(this->FilterLog.Errors.size(), 1U);
    EXPECT_NE(this->FilterLog.Errors[0].find(words), std::string::npos)
      << this->FilterLog.Errors[0];
    this->FilterLog.Errors.clear();
  }

  void ExpectForceOfTheWall()
  {
    const double time = this->Device->GetPlayback()->GetDataTime();
    // A blend of two edges that are one voxel apart has an error of at most 0.02 of their width.
    EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[0],
      0.001 * WallStiffness * std::max(0.0, ComputeWall(time) - TipRests), 0.02)
      << "at " << time;
  }

  /// Records a loop in which the wall jumps back, and expects a bitwise identical replay. The time
  /// steps are at `first` to `first` + 4.
  void ExpectThatARecordingReplaysToTheBit(double first)
  {
    this->Filter->SetTimeUnitsPerSecond(9.0);
    this->Device->GetPlayback()->SetModeToLoop();
    this->Rest();
    this->Device->GetPlayback()->Play();
    ASSERT_TRUE(
      this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() > first + 0.5; }));
    const std::string file = this->File("Playback.vtp");
    ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
    double time = first;
    int loops = 0;
    bool isBack = false;
    this->Watch(1.5,
      [&]
      {
        const double now = this->Device->GetPlayback()->GetDataTime();
        loops += now < time ? 1 : 0;
        time = now;
        if (loops > 0 && !isBack)
        {
          this->Device->GetVirtualHand()->SetPosition(TipRests - 1.0, 11.0, 12.0);
          this->Device->GetPlayback()->SetDataTime(first + 3.2);
          isBack = true;
        }
      });
    EXPECT_GT(loops, 1);
    ASSERT_TRUE(this->Device->GetRecorder()->Stop());
    this->Device->Close();
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* const recording = reader->GetOutput();
    const vtkIdType ticks = recording->GetNumberOfPoints();
    ASSERT_GT(ticks, 1000);
    this->Filter->SetPathData(recording);
    this->Filter->Update();
    vtkPolyData* const trace = this->Filter->GetOutput();
    ASSERT_EQ(trace->GetNumberOfPoints(), ticks);
    double strongest = 0.0;
    double latest = 0.0;
    for (vtkIdType tick = 0; tick < ticks; ++tick)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_EQ(Get(trace, "Force", tick, c), Get(recording, "Force", tick, c)) << tick;
      }
      ASSERT_EQ(Get(trace, "DataTime", tick), Get(recording, "DataTime", tick)) << tick;
      strongest = std::max(strongest, Get(trace, "Force", tick));
      latest = std::max(latest, Get(trace, "DataTime", tick));
    }
    EXPECT_GT(strongest, 0.3);
    EXPECT_GT(latest, first + 4.0); // the data time is between the last time step and the first one
  }

  vtkNew<apitest::TimeSource> Source;
};

/// A source with the same time steps as components of one array, at times from 0 onwards.
class PlaybackOfComponents : public PlaybackOfSteps
{
protected:
  PlaybackOfComponents()
  {
    this->TimeSteps->ShallowCopy(this->Source->Make(10.0));
    const auto array =
      vtk::TakeSmartPointer(this->TimeSteps->GetPointData()->GetScalars()->NewInstance());
    array->SetName("frames");
    array->SetNumberOfComponents(5);
    array->SetNumberOfTuples(this->TimeSteps->GetNumberOfPoints());
    for (int i = 0; i < 5; ++i)
    {
      array->CopyComponent(i, this->Source->Make(10.0 + i)->GetPointData()->GetScalars(), 0);
    }
    this->TimeSteps->GetPointData()->SetScalars(array);
    this->Filter->SetInputData(0, this->TimeSteps);
    this->Filter->SetFramesToComponents();
    this->Filter->SetFrameSpacing(1.0);
  }

  vtkNew<vtkImageData> TimeSteps;
};
} // namespace

/// A grid is resampled around the tip, so it can't be played: it stands still and causes one
/// warning, whose advice must make it move.
TEST_F(PlaybackOfSteps, OfAGridIsTold)
{
  vtkNew<vtkAppendFilter> grid;
  grid->SetInputConnection(this->Source->GetOutputPort());
  this->Filter->SetInputConnection(grid->GetOutputPort());
  this->Device->GetPlayback()->Play(); // plays before the grid exists
  this->Rest();
  ASSERT_TRUE(this->Wait([&] { return this->FilterLog.Warnings.size() == 1; }));
  for (const char* const part : { "vtkUnstructuredGrid", "5 time steps", "vtkResampleToImage" })
  {
    EXPECT_NE(this->FilterLog.Warnings.front().find(part), std::string::npos) << part;
  }
  this->Filter->Modified();
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_EQ(this->FilterLog.Warnings.size(), 1U) << "once for a series";
  this->FilterLog.Warnings.clear();

  vtkNew<vtkResampleToImage> image;
  image->SetInputConnection(grid->GetOutputPort());
  image->SetSamplingDimensions(24, 24, 24);
  image->Update();
  const char* const name = image->GetOutput()->GetPointData()->GetArrayName(0);
  this->Filter->SetInputConnection(image->GetOutputPort());
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
  this->Filter->SetTimeUnitsPerSecond(4.0);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() > 13.5; }));
  this->ExpectForceOfTheWall();
}

TEST_F(PlaybackOfSteps, AWallThatBeatsPushesAHandThatRests)
{
  this->Filter->SetTimeUnitsPerSecond(8.0);
  this->Device->GetPlayback()->SetModeToPingPong();
  this->Rest();
  EXPECT_FALSE(this->Device->GetPlayback()->IsPlaying());
  this->Device->GetPlayback()->Play();
  double most = 0.0;
  double last = 10.0;
  double least = 14.0;
  this->Watch(2.5,
    [&]
    {
      const double time = this->Device->GetPlayback()->GetDataTime();
      if (time == 0.0)
      {
        return; // no time step is in use yet
      }
      EXPECT_LE(10.0, time);
      EXPECT_LE(time, 14.0);
      this->ExpectForceOfTheWall();
      most = std::max(most, this->Device->GetState()->GetComputedForce()[0]);
      least = time < last ? std::min(least, time) : least;
      last = time;
    });
  EXPECT_GT(most, 0.4);
  EXPECT_LT(least, 11.0); // the data time has run back
  this->Device->GetPlayback()->Hold();
  ASSERT_TRUE(this->WaitTicks(20));
  const double held = this->Device->GetPlayback()->GetDataTime();
  ASSERT_TRUE(this->WaitTicks(50));
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), held);
  EXPECT_FALSE(this->Device->GetPlayback()->IsWaitingForData());
}

TEST_F(PlaybackOfSteps, TheVolumeStandsStillUntilItIsPlayed)
{
  this->Rest();
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), 0.0);
  EXPECT_EQ(this->Device->GetPlayback()->GetMode(), vtkHapticPlayback::ONCE);
  EXPECT_EQ(Length(this->Device->GetState()->GetComputedForce()), 0.0);
}

TEST_F(PlaybackOfSteps, GoesToAnyTimeAndFeelsTheWallThere)
{
  this->Rest();
  for (const double time : { 13.6, 10.5, 12.0, 99.0, 11.0 })
  {
    this->Device->GetPlayback()->SetDataTime(time);
    EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), time);
    const double there = std::min(time, 14.0);
    ASSERT_TRUE(this->WaitTicks(5));
    ASSERT_TRUE(this->Wait(
      [&]
      {
        return this->Device->GetPlayback()->GetDataTime() == there &&
          !this->Device->GetPlayback()->IsWaitingForData();
      }))
      << time;
    EXPECT_LE(this->Device->GetState()->GetComputedForce()[0], 0.52);
  }
  this->Device->GetPlayback()->SetDataTime(std::numeric_limits<double>::quiet_NaN());
  this->ExpectError("The data time has to be a finite number");
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), 11.0);
}

TEST_F(PlaybackOfSteps, WaitsForAStepThatCantBeReadAndTells)
{
  this->Filter->SetTimeUnitsPerSecond(20.0);
  this->Source->FailsAt = 12.0;
  this->Rest();
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->IsWaitingForData(); }));
  this->Source->FailsAt = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(this->WaitTicks(50));
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), 11.0);
  EXPECT_NE(
    this->Device->GetStatusText().find("waiting for the frame at data time 12"), std::string::npos)
    << this->Device->GetStatusText();
  this->ExpectFilterError("can't be read");
  // Once the time step can be read, publishing continues there.
  ASSERT_TRUE(this->Device->Publish());
  this->Filter->Modified();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 14.0; }));
  EXPECT_FALSE(this->Device->GetPlayback()->IsWaitingForData());
}

TEST_F(PlaybackOfSteps, StepsOfAnotherShapeAreRefusedAndOthersOfAnotherTypeAreFelt)
{
  this->Filter->SetTimeUnitsPerSecond(20.0);
  this->Source->Make = [](double time)
  {
    return time == 12.0 ? MakeWallStep(time, 24, VTK_FLOAT)
                        : MakeWallStep(time, time == 14.0 ? 20 : 24);
  };
  this->Rest();
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->IsWaitingForData(); }));
  ASSERT_TRUE(this->WaitTicks(10));
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), 13.0);
  this->ExpectForceOfTheWall();
  this->ExpectFilterError("has another geometry");
}

TEST_F(PlaybackOfSteps, ARecordingReplaysToTheBit)
{
  this->ExpectThatARecordingReplaysToTheBit(10.0);
}

TEST_F(PlaybackOfComponents, ARecordingReplaysToTheBit)
{
  this->ExpectThatARecordingReplaysToTheBit(0.0);
}

TEST_F(PlaybackOfComponents, PushAHandThatRestsWithoutACopy)
{
  this->Filter->SetTimeUnitsPerSecond(8.0);
  this->Device->GetPlayback()->SetModeToLoop();
  this->Rest();
  vtkDataArray* const array = this->TimeSteps->GetPointData()->GetScalars();
  const int users = array->GetReferenceCount();
  this->Device->GetPlayback()->Play();
  double most = 0.0;
  this->Watch(1.2,
    [&]
    {
      const double time = this->Device->GetPlayback()->GetDataTime();
      if (time > 0.0 && time <= 4.0)
      {
        EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[0],
          0.001 * WallStiffness * std::max(0.0, ComputeWall(10.0 + time) - TipRests), 0.02)
          << "at " << time;
      }
      most = std::max(most, this->Device->GetState()->GetComputedForce()[0]);
    });
  EXPECT_GT(most, 0.4);
  // The playback must not copy samples: its five time steps, and the first one again behind the
  // last one, all refer to the array.
  EXPECT_GE(array->GetReferenceCount(), users + 5);
  EXPECT_FALSE(this->Device->GetPlayback()->IsWaitingForData());
}

TEST_F(PlaybackOfComponents, ChangesOfTheImageArePublished)
{
  this->Filter->SetTimeUnitsPerSecond(1e-3);
  this->Device->GetPlayback()->SetDataTime(3.0);
  this->Rest();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 3.0; }));
  EXPECT_TRUE(this->Device->IsPublished());
  this->TimeSteps->GetPointData()->GetScalars()->Modified();
  EXPECT_FALSE(this->Device->IsPublished());
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished());
}

TEST_F(PlaybackOfComponents, OneAloneIsAnError)
{
  this->Filter->SetInputData(0, MakeWallStep(10.0));
  this->Rest();
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->WaitTicks(20));
  this->ExpectFilterError("has one component, and the components are the frames");
}

/// Cases V2 and V7 of Documentation/evaluation.md, with time that runs forwards and backwards. The
/// wall has a strength of 0.3 N and slips past the proxy; on its way back, the force falls to 0
/// over 0.6 mm. The whole motion absorbs the work of 0.3 N over the 0.4 mm that slipped.
TEST_F(PlaybackOfSteps, AWallThatSlipsTakesWorkToAndFro)
{
  constexpr double strength = 0.3;
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), strength);
  this->Filter->SetTimeUnitsPerSecond(8.0);
  this->Rest();
  this->Device->GetPlayback()->SetDataTime(10.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 10.0; }));
  const std::string file = this->File("Slips.vtp");
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 14.0; }));
  this->Device->GetPlayback()->SetSpeed(-0.5);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 10.0; }));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const ticks = reader->GetOutput();
  bool wasThere = false;
  double work = 0.0;
  for (vtkIdType i = 1; i < ticks->GetNumberOfPoints(); ++i)
  {
    const double time = Get(ticks, "DataTime", i);
    const double force = Get(ticks, "Force", i, 0);
    wasThere = wasThere || time == 14.0;
    const double come = 0.001 * WallStiffness * std::max(0.0, ComputeWall(time) - TipRests);
    const double expected = wasThere
      ? std::max(0.0, strength - 0.001 * WallStiffness * (14.0 - time))
      : std::min(strength, come);
    ASSERT_NEAR(force, expected, 0.02) << "at " << time << (wasThere ? " back" : "");
    work += 0.5 * (force + Get(ticks, "Force", i - 1, 0)) *
      (ComputeWall(time) - ComputeWall(Get(ticks, "DataTime", i - 1)));
  }
  EXPECT_TRUE(wasThere);
  EXPECT_NEAR(work, 0.3 * 0.4, 0.02); // mJ
}

/// Case V5 of Documentation/evaluation.md: identical time steps must have the force of a static
/// volume.
TEST_F(PlaybackOfSteps, StepsThatAreAlikeAreAVolumeThatStandsStill)
{
  this->Source->Make = [](double) { return MakeWallStep(13.5); };
  this->Filter->SetTimeUnitsPerSecond(20.0);
  this->Device->GetPlayback()->SetModeToLoop();
  this->Rest();
  this->Device->GetPlayback()->SetDataTime(10.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->GetDataTime() == 10.0; }));
  this->Device->GetVirtualHand()->SetPosition(12.2, 11.0, 11.7);
  ASSERT_TRUE(this->WaitTicks(100));
  const double* const force = this->Device->GetState()->GetComputedForce();
  const Point still{ force[0], force[1], force[2] };
  this->Device->GetPlayback()->Play();
  double latest = 0.0;
  this->Watch(0.5,
    [&]
    {
      const double* const now = this->Device->GetState()->GetComputedForce();
      EXPECT_EQ((Point{ now[0], now[1], now[2] }), still)
        << this->Device->GetPlayback()->GetDataTime();
      latest = std::max(latest, this->Device->GetPlayback()->GetDataTime());
    });
  EXPECT_GT(latest, 13.0);
}

/// The wall moves by 1 mm per time step, which a blend can represent, except for one step of 6 mm.
TEST_F(PlaybackOfSteps, AStepThatIsTooFastForABlendIsToldOnceAsItComes)
{
  this->Source->Steps = { 10.0, 11.0, 12.0, 13.0, 14.0, 15.0 };
  this->Source->Make = [](double time)
  { return MakeWallStep(time < 13.5 ? time - 3.0 : time + 2.0); };
  this->Filter->SetTimeUnitsPerSecond(5.0);
  this->Device->GetPlayback()->SetModeToPingPong();
  this->Rest();
  this->Device->GetPlayback()->SetDataTime(10.5);
  ASSERT_TRUE(this->Wait([&] { return this->Source->Asked.back() == 12.0; }));
  EXPECT_TRUE(this->FilterLog.Warnings.empty()); // the first three time steps are read by now
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() > 14.5; }));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() < 11.0; }));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() > 14.5; }));
  ASSERT_EQ(this->FilterLog.Warnings.size(), 1U);
  const std::string& warning = this->FilterLog.Warnings.front();
  for (const char* part : { "input port 0", "by about 6 world", "from time 13 to time 14",
         "vtkImageGaussianSmooth", "SetDisplacementArrayName" })
  {
    EXPECT_NE(warning.find(part), std::string::npos) << part << " in " << warning;
  }
}

/// A loop also runs from the last time step to the first one, where the wall jumps back by 6 mm.
/// Other modes have no such step.
TEST_F(PlaybackOfSteps, TheWayBackToTheFirstStepIsTooFastInALoopAlone)
{
  this->Source->Steps = { 10.0, 12.0, 14.0 };
  this->Source->Make = [](double time) { return MakeWallStep(6.0 + 1.5 * (time - 10.0)); };
  this->Device->GetPlayback()->SetModeToPingPong();
  this->Rest();
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->WaitTicks(2));
  EXPECT_TRUE(this->FilterLog.Warnings.empty()) << this->FilterLog.Warnings.front();
  this->Device->GetPlayback()->SetModeToLoop();
  this->Source->Modified();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_EQ(this->FilterLog.Warnings.size(), 1U);
  EXPECT_NE(this->FilterLog.Warnings[0].find("from time 14 to time 10"), std::string::npos)
    << this->FilterLog.Warnings[0];
}

/// The wall moves by 3.5 mm per time step, more than twice its width, so only displacements can
/// represent its motion.
TEST_F(PlaybackOfSteps, StepsAreBlendedAlongTheirDisplacements)
{
  const auto findWall = [](double time) { return 5.0 + 3.5 * (time - 10.0); };
  this->Source->Steps = { 10.0, 11.0, 12.0, 13.0 };
  this->Source->Make = [findWall](double time)
  {
    const auto step = MakeWallStep(10.0 + findWall(time) - 9.0);
    vtkNew<vtkFloatArray> motion;
    motion->SetName("motion");
    motion->SetNumberOfComponents(3);
    motion->SetNumberOfTuples(step->GetNumberOfPoints());
    motion->FillComponent(0, 3.5);
    motion->FillComponent(1, 0.0);
    motion->FillComponent(2, 0.0);
    step->GetPointData()->AddArray(motion);
    return step;
  };
  this->Filter->SetDisplacementArrayName("motion");
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Rest();
  this->Device->GetPlayback()->Play();
  double most = 0.0;
  this->Watch(1.0,
    [&]
    {
      const double time = this->Device->GetPlayback()->GetDataTime();
      const double deep = time == 0.0 ? 0.0 : std::max(0.0, findWall(time) - TipRests);
      EXPECT_NEAR(
        this->Device->GetState()->GetComputedForce()[0], 0.001 * WallStiffness * deep, 0.03)
        << "at " << time;
      most = std::max(most, this->Device->GetState()->GetComputedForce()[0]);
    });
  EXPECT_GT(most, 1.6);
}

TEST_F(PlaybackOfSteps, AStepWithoutNumbersHoldsNothingAndTimeGoesOn)
{
  this->Source->Make = [](double time)
  {
    const auto step = MakeWallStep(time);
    if (time == 12.0)
    {
      step->GetPointData()->GetScalars()->FillComponent(
        0, std::numeric_limits<double>::quiet_NaN());
    }
    return step;
  };
  this->Filter->SetTimeUnitsPerSecond(8.0);
  this->Rest();
  this->Device->GetPlayback()->Play();
  double latest = 0.0;
  this->Watch(1.0,
    [&]
    {
      latest = this->Device->GetPlayback()->GetDataTime();
      const double force = this->Device->GetState()->GetComputedForce()[0];
      EXPECT_TRUE(std::isfinite(force)) << "at " << latest;
      EXPECT_LE(std::abs(force), 0.52) << "at " << latest;
    });
  EXPECT_EQ(latest, 14.0);
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// The proxy is a sphere of 1 mm that rests against the wall's mesh. The mesh is made one time step
/// ahead.
TEST_F(PlaybackOfSteps, AMeshGoesAlong)
{
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(500.0);
  this->Filter->SetProxyRadius(1.0);
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Device->GetPlayback()->SetModeToPingPong();
  this->Rest();
  this->Device->GetPlayback()->Play();
  double most = 0.0;
  double latest = 0.0;
  this->Watch(1.8,
    [&]
    {
      latest = this->Device->GetPlayback()->GetDataTime();
      const double deep = latest == 0.0 ? 0.0 : std::max(0.0, ComputeWall(latest) + 1.0 - TipRests);
      EXPECT_NEAR(
        this->Device->GetState()->GetComputedForce()[0], 0.001 * WallStiffness * deep, 2e-3)
        << "at " << latest;
      most = std::max(most, this->Device->GetState()->GetComputedForce()[0]);
    });
  EXPECT_GT(most, 0.9);
  EXPECT_LT(latest, 14.0); // the data time has run back
}
