// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the large meshes of a moving volume's first time steps, which a worker makes. The test
 * blocks the worker, so a device that waited for it would wait forever.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/GatedArray.h"

#include <vtkAlgorithmOutput.h>
#include <vtkDataArray.h>
#include <vtkHapticTimeStepSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

using namespace devicetest;

namespace
{
constexpr double MeshedStiffness = 500.0;
constexpr double MeshedRadius = 0.5;
constexpr double MeshedTip = 6.5;

/// Time steps of V = 100 (z + t): the surface at the value 750 moves by 1 mm per unit of data time.
/// At time 0, the proxy's sphere is 0.5 mm in front of the surface.
class MeshedTimeSteps : public DeviceTest
{
protected:
  MeshedTimeSteps()
  {
    for (vtkSmartPointer<GatedArray>& timeStep : this->TimeSteps)
    {
      timeStep = vtkSmartPointer<GatedArray>::New();
    }
    this->Source->StreamedOn();
    this->Give(0);
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetMethodToSurfaceProxy();
    this->Filter->SetIsoValue(750.0);
    this->Filter->SetProxyRadius(MeshedRadius);
    SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 3.0);
    this->Filter->GetProperty()->DistinctnessFromNoiseOff();
  }
  /// Releases the worker, even after a failure.
  ~MeshedTimeSteps() override { this->LetTheWorkerGoOn(); }

  void LetTheWorkerGoOn()
  {
    for (GatedArray* const timeStep : this->TimeSteps)
    {
      timeStep->IsOpen = true;
    }
  }
  bool IsWorkerHeldUp() { return this->TimeSteps[0]->Asked > 0 && !this->TimeSteps[0]->IsOpen; }
  /// Passes the time step `first` and the next one to the source.
  void Give(int first)
  {
    // Each time step has a mesh of 33 000 triangles.
    constexpr int n = 130;
    this->Source->RemoveAllTimeSteps();
    for (int i = first; i < first + 2; ++i)
    {
      GatedArray* const values = this->TimeSteps[i];
      if (values->GetNumberOfValues() == 0)
      {
        values->SetNumberOfValues(vtkIdType{ n } * n * n);
        for (vtkIdType k = 0; k < n; ++k)
        {
          std::fill_n(values->GetPointer(k * n * n), n * n, static_cast<short>(100 * (k + i)));
        }
      }
      vtkNew<vtkImageData> image;
      image->SetDimensions(n, n, n);
      image->GetPointData()->SetScalars(values);
      this->Source->AddTimeStep(image, i);
    }
  }
  void BeginToPlay()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetPosition(60.3, 60.2, MeshedTip);
    this->Device->GetPlayback()->SetSpeed(4.0);
    this->Device->GetPlayback()->Play();
    ASSERT_TRUE(this->Device->Start());
  }
  bool Says(const char* words)
  {
    return this->Device->GetStatusText().find(words) != std::string::npos;
  }
  bool WaitTime(double time)
  {
    return this->Wait([&] { return this->Device->GetPlayback()->GetDataTime() == time; });
  }
  void ExpectForce()
  {
    const double deep =
      std::max(0.0, MeshedTip + MeshedRadius - 7.5 + this->Device->GetPlayback()->GetDataTime());
    EXPECT_NEAR(
      Length(this->Device->GetState()->GetComputedForce()), 0.001 * MeshedStiffness * deep, 2e-3);
  }

  vtkSmartPointer<GatedArray> TimeSteps[3];
  vtkNew<vtkHapticTimeStepSource> Source;
};
} // namespace

TEST_F(MeshedTimeSteps, AreNotWaitedFor)
{
  this->BeginToPlay();
  ASSERT_TRUE(this->Wait([this] { return this->IsWorkerHeldUp(); }));
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_TRUE(this->Says("Meanwhile the surfaces of the frames are meshed."))
    << this->Device->GetStatusText();
  EXPECT_FALSE(this->Device->GetPlayback()->HasTimeSteps());
  EXPECT_EQ(Length(this->Device->GetState()->GetComputedForce()), 0.0);
  EXPECT_EQ(this->Device->GetPlayback()->GetDataTime(), 0.0);
  // Further changes of settings must not wait for the worker.
  this->Filter->SetIsoValue(700.0);
  ASSERT_TRUE(this->Device->Publish());
  this->Filter->SetIsoValue(750.0);
  ASSERT_TRUE(this->Device->Publish());
  this->Device->GetPlayback()->Hold();
  this->LetTheWorkerGoOn();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetPlayback()->HasTimeSteps(); }));
  EXPECT_FALSE(this->Says("meshed"));
  ASSERT_TRUE(this->WaitTicks(5));
  this->ExpectForce();

  // The filter makes the meshes itself, and must compute bitwise identical forces along the
  // recorded path.
  const std::string file = this->File("MeshedFrames.vtp");
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(this->WaitTime(1.0));
  this->ExpectForce();
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->Device->Close();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const recording = reader->GetOutput();
  vtkNew<vtkVolumeHapticsFilter> other;
  other->SetInputConnection(this->Source->GetOutputPort());
  other->SetMethodToSurfaceProxy();
  other->SetIsoValue(750.0);
  other->SetProxyRadius(MeshedRadius);
  other->SetProperty(this->Filter->GetProperty());
  other->SetPathData(recording);
  other->Update();
  vtkPolyData* const trace = other->GetOutput();
  const vtkIdType ticks = recording->GetNumberOfPoints();
  ASSERT_GT(ticks, 200);
  ASSERT_EQ(trace->GetNumberOfPoints(), ticks);
  for (vtkIdType tick = 0; tick < ticks; ++tick)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(Get(trace, "Force", tick, c), Get(recording, "Force", tick, c)) << tick;
    }
  }
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// Time steps of a stream must be felt before the next ones arrive, even if making their meshes
/// takes longer than the interval between them.
TEST_F(MeshedTimeSteps, OfAStreamAreFeltBeforeTheNextOnes)
{
  this->BeginToPlay();
  ASSERT_TRUE(this->Wait([this] { return this->IsWorkerHeldUp(); }));
  this->Give(1);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_FALSE(this->Device->GetPlayback()->HasTimeSteps());
  this->LetTheWorkerGoOn();
  double least = 2.0;
  ASSERT_TRUE(this->Wait(
    [&]
    {
      least = this->Device->GetPlayback()->HasTimeSteps()
        ? std::min(least, this->Device->GetPlayback()->GetDataTime())
        : least;
      return this->Device->GetPlayback()->GetDataTime() == 2.0;
    }));
  EXPECT_LT(least, 1.0);
  this->ExpectForce();
  EXPECT_TRUE(this->Device->IsPublished());
  EXPECT_TRUE(this->FilterLog.Errors.empty());
}

/// While the meshes for another method are made, the servo continues with the present method.
TEST_F(MeshedTimeSteps, GoOnWhileOthersAreMade)
{
  this->Filter->SetTimeUnitsPerSecond(0.0);
  this->Filter->SetMethodToProxy();
  this->BeginToPlay();
  ASSERT_TRUE(this->WaitTicks(5));
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetTimeUnitsPerSecond(1.0);
  ASSERT_TRUE(this->Lead(60.3, 60.2, MeshedTip + 1.0));
  const double before = Length(this->Device->GetState()->GetComputedForce());
  EXPECT_GT(before, 0.2);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->IsWorkerHeldUp(); }));
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_NEAR(Length(this->Device->GetState()->GetComputedForce()), before, 1e-3);
  this->Device->Stop();
  EXPECT_FALSE(this->Says("meshed"));
  EXPECT_TRUE(this->IsWorkerHeldUp()) << "nothing waited for the worker";
}
