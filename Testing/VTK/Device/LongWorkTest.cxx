// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the force is off while work prevents the owner from updating the device, and returns
 * afterwards.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/EventCounter.h"
#include "Rigs/GatedArray.h"
#include "VTK/Filter/HapticBaker.h"

#include "Core/Model/HapticModel.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <thread>

using namespace devicetest;

namespace
{
/// Opens the array at the end of the test, even after a failure, so that the worker can finish.
class OpenAtTheEnd
{
public:
  explicit OpenAtTheEnd(GatedArray* array)
    : Array(array)
  {
  }
  ~OpenAtTheEnd() { this->Array->IsOpen = true; }
  OpenAtTheEnd(const OpenAtTheEnd&) = delete;
  OpenAtTheEnd& operator=(const OpenAtTheEnd&) = delete;

private:
  GatedArray* const Array;
};

void Sleep(int milliseconds)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

class LongWork : public DeviceTest
{
protected:
  LongWork() { this->Device->SetAttentionTime(2.0); }
  /// Presses into the ramp with 1.5 N, and discards the states recorded until then.
  void Press()
  {
    ASSERT_NO_FATAL_FAILURE(this->BeginPressed());
    this->Device->GetState()->Drain(this->States);
  }
  bool WaitRest()
  {
    return this->Wait([this] { return Length(this->Device->GetState()->GetForce()) == 0.0; });
  }
  /// Expects that the force was never off, unless the loop has paused: after a pause, the force may
  /// stay off until the next contact.
  void ExpectForce() { EXPECT_TRUE(this->CountForceless() == 0 || this->HasPaused); }
  /// Returns how many of the states since the last call have no force. Expects no fault, and that
  /// the force fades gradually from tick to tick.
  int CountForceless(bool isArmed = true)
  {
    this->Device->GetState()->Drain(this->States);
    const auto column = [this](const char* name)
    { return vtkDataArray::SafeDownCast(this->States->GetColumnByName(name)); };
    int forceless = 0;
    for (vtkIdType i = 0; i < this->States->GetNumberOfRows(); ++i)
    {
      const double force = Length(column("Command")->GetTuple3(i));
      forceless += force == 0.0;
      EXPECT_EQ(column("Fault")->GetComponent(i, 0), 0.0);
      EXPECT_TRUE(!isArmed || column("Armed")->GetComponent(i, 0) == 1.0);
      // The force changes by at most 500 N/s: 0.5 N in a tick of 1 ms.
      const double tick = column("Tick")->GetComponent(i, 0);
      const double time = column("Time")->GetComponent(i, 0);
      const double period = 1.0 / this->Device->GetServoRate();
      const bool isNext = tick == this->Tick + 1.0 && time <= this->Time + 1.5 * period;
      this->HasPaused = this->HasPaused || (this->HasForce && !isNext);
      EXPECT_TRUE(!this->HasForce || !isNext || std::abs(force - this->Force) <= 0.5 + 1e-9)
        << "row " << i;
      this->Tick = tick;
      this->Time = time;
      this->Force = force;
      this->HasForce = true;
    }
    return forceless;
  }
  /// Makes V = 100 z with more than 8 million samples. At this size, even the estimate of the
  /// triangles runs on a worker.
  static vtkSmartPointer<vtkImageData> MakeLarge(GatedArray* values)
  {
    constexpr int n = 204;
    values->SetNumberOfValues(vtkIdType{ n } * n * n);
    for (vtkIdType k = 0; k < n; ++k)
    {
      std::fill_n(values->GetPointer(k * n * n), n * n, static_cast<short>(100 * k));
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(n, n, n);
    image->GetPointData()->SetScalars(values);
    return image;
  }
  /// Expects that the filter, which uses a worker, bakes triangles that are bitwise identical to
  /// those that `other` bakes without a worker.
  void ExpectSameMesh(vtkVolumeHapticsFilter* other, std::int64_t triangles)
  {
    using VolumeHaptics::HapticBaker;
    const auto ours = this->Filter->GetBaker().Bake(1000.0, {}, nullptr);
    const auto theirs = other->GetBaker().Bake(1000.0, {}, nullptr);
    ASSERT_TRUE(ours && theirs);
    const VolumeHaptics::SurfaceMesh& mesh = *ours->Baked->Mesh;
    const VolumeHaptics::SurfaceMesh& expected = *theirs->Baked->Mesh;
    ASSERT_EQ(expected.GetNumberOfTriangles(), triangles);
    ASSERT_EQ(mesh.GetNumberOfTriangles(), triangles);
    for (std::int32_t i = 0; i < triangles; ++i)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const VolumeHaptics::Vector3 a = mesh.GetTriangle(i).Corner[corner];
        const VolumeHaptics::Vector3 b = expected.GetTriangle(i).Corner[corner];
        ASSERT_TRUE(a.X == b.X && a.Y == b.Y && a.Z == b.Z) << i;
      }
    }
  }
  bool IsFeltAs(const char* method)
  {
    return this->Wait([&] { return this->Device->GetMethodText() == method; });
  }
  bool Says(const char* words)
  {
    return this->Device->GetStatusText().find(words) != std::string::npos;
  }

  vtkNew<vtkTable> States;
  apitest::EventCounter Starts{ this->Device, vtkCommand::StartEvent };
  apitest::EventCounter Ends{ this->Device, vtkCommand::EndEvent };
  double Force = 0.0;
  double Tick = 0.0;
  double Time = 0.0;
  bool HasPaused = false;
  bool HasForce = false;
};
} // namespace

TEST_F(LongWork, IsWithoutForceThatComesBackWithARamp)
{
  this->Press();
  this->ExpectForce();
  this->Device->BeginLongWork("the test sleeps");
  EXPECT_EQ(this->Starts.Count, 1);
  ASSERT_TRUE(this->WaitRest());
  EXPECT_TRUE(this->Says("Force is off while the test sleeps")) << this->Device->GetStatusText();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  this->CountForceless();
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_GT(this->CountForceless(), 10);
  EXPECT_EQ(this->Force, 0.0);
  EXPECT_EQ(this->Ends.Count, 0);
  this->Device->EndLongWork();
  EXPECT_EQ(this->Ends.Count, 1);
  EXPECT_FALSE(this->Says("Force is off"));
  ASSERT_TRUE(this->PressAgain());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  // The proxy starts again at the tip inside the ramp, so no spring has pushed the tip out, and
  // some states have no force.
  EXPECT_GT(this->CountForceless(), 0);
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(LongWork, NeedsNoAttention)
{
  this->Press();
  this->Device->BeginLongWork("the test sleeps");
  this->Device->SetAttentionTime(0.05);
  Sleep(300);
  this->CountForceless();
  this->Device->SetAttentionTime(2.0);
  this->Device->EndLongWork();
  EXPECT_TRUE(this->PressAgain()) << this->Device->GetStatusText();
}

TEST_F(LongWork, StaysWithoutForceIfACallerDisarmsMeanwhile)
{
  for (const bool fades : { false, true })
  {
    this->Press();
    this->Device->BeginLongWork("the test disarms");
    fades ? this->Device->FadeOut() : this->Device->Disarm();
    EXPECT_FALSE(this->Says("Force is off while")) << "it will not come back";
    this->Device->EndLongWork();
    ASSERT_TRUE(this->WaitRest());
    this->CountForceless(false);
    ASSERT_TRUE(this->WaitTicks(100));
    EXPECT_GE(this->CountForceless(false), 100);
    EXPECT_EQ(this->Force, 0.0);
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY);
    this->HasForce = false;
  }
}

TEST_F(LongWork, StaysWithoutForceIfAnObserverSaysSo)
{
  this->Press();
  vtkNew<vtkCallbackCommand> refuses;
  refuses->SetCallback([](vtkObject* device, unsigned long, void*, void*)
    { static_cast<vtkHapticDevice*>(device)->Disarm(); });
  this->Device->AddObserver(vtkCommand::StartEvent, refuses);
  this->Device->BeginLongWork(nullptr);
  this->Device->EndLongWork();
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY);
}

TEST_F(LongWork, Nests)
{
  this->Press();
  this->Device->BeginLongWork("one works");
  this->Device->BeginLongWork("another works");
  this->Device->BeginLongWork("a short one works", 1e-3);
  EXPECT_TRUE(this->Says("one works"));
  this->Device->EndLongWork();
  this->Device->EndLongWork();
  ASSERT_TRUE(this->WaitRest());
  this->CountForceless();
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_GE(this->CountForceless(), 100);
  EXPECT_EQ(this->Force, 0.0);
  this->Device->EndLongWork();
  EXPECT_EQ(this->Starts.Count, 1);
  EXPECT_EQ(this->Ends.Count, 1);
  EXPECT_TRUE(this->PressAgain());
  EXPECT_TRUE(this->Log.Errors.empty());
  this->Device->EndLongWork();
  this->ExpectError("BeginLongWork() first");
}

TEST_F(LongWork, ThatIsShortIsNotFelt)
{
  this->Press();
  this->Device->BeginLongWork("the test waits", 0.2);
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_FALSE(this->Says("Force is off"));
  this->ExpectForce();
  this->Device->EndLongWork();
  ASSERT_TRUE(this->WaitTicks(10));
  this->ExpectForce();
  EXPECT_EQ(this->Starts.Count, 0);
  EXPECT_EQ(this->Ends.Count, 0);
  // A shorter AttentionTime also shortens the time from which work counts as long.
  this->Device->SetAttentionTime(0.8);
  this->Device->BeginLongWork("the test waits", 0.2);
  EXPECT_EQ(this->Starts.Count, 1);
  this->Device->EndLongWork();
}

TEST_F(LongWork, OutlivesAServoAndHoldsTheNextOne)
{
  this->Press();
  this->Device->BeginLongWork("the test opens a device");
  this->Device->Close();
  this->HasForce = false;
  this->Begin();
  this->Device->Arm();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  this->Device->GetState()->Drain(this->States);
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_GE(this->CountForceless(false), 100);
  EXPECT_EQ(this->Force, 0.0);
  this->Device->EndLongWork();
  EXPECT_TRUE(this->PressAgain()) << "it was armed during the work";
  this->Device->BeginLongWork("the test closes a device");
  this->Device->Close();
  this->Device->EndLongWork();
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(LongWork, IsNotMeshingWhatHasManyTriangles)
{
  // V = 100 z below z = 12 mm. The values above are random, so the isosurface passes through all of
  // them, with several hundred thousand triangles.
  constexpr int n = 40;
  std::mt19937 random(1);
  const auto image = MakeImage(n, VTK_FLOAT,
    [&](const Point& x)
    { return x[2] < 12.0 ? 100.0 * x[2] : static_cast<double>(random() % 2001); });
  this->Filter->SetInputData(0, image);
  this->Filter->GetProperty()->DistinctnessFromNoiseOff();
  this->Press();
  this->Filter->SetIsoValue(1000.0);
  this->Filter->SetMethodToSurfaceProxy();
  this->ExpectForce();
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_FALSE(this->Device->IsPublished());
  EXPECT_TRUE(this->Says("Meanwhile the surface is meshed.")) << this->Device->GetStatusText();
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  EXPECT_FALSE(this->Says("is meshed"));
  EXPECT_EQ(this->Device->GetMethodText(), "Surface proxy");
  this->Filter->GetProperty()->GetFriction()->AddPoint(0.0, 0.1);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished()) << "the mesh is there";
  this->Filter->SetMethodToProxy();
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished());
  EXPECT_TRUE(this->PressAgain());
  EXPECT_EQ(this->Starts.Count, 0);
}

TEST_F(LongWork, IsNotMeshingALargeVolume)
{
  vtkNew<GatedArray> values;
  const OpenAtTheEnd opener(values);
  const vtkSmartPointer<vtkImageData> image = MakeLarge(values);
  this->Filter->SetInputData(0, image);
  this->Filter->GetProperty()->DistinctnessFromNoiseOff();
  this->Press();
  const auto isMeshing = [this] { return this->Says("the surface is meshed"); };
  this->Filter->SetIsoValue(700.0);
  this->Filter->SetMethodToSurfaceProxy();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([&] { return values->Asked > 0; }));
  EXPECT_TRUE(isMeshing());
  // Further changes of settings must not wait for the worker, which is still reading the array.
  this->Filter->SetIsoValue(750.0);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(isMeshing());
  this->Filter->SetMethodToProxy();
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished());
  EXPECT_FALSE(isMeshing());
  this->Filter->SetMethodToSurfaceProxy();
  ASSERT_TRUE(this->Device->Publish());
  this->Filter->Update(); // without a path, only checks the input, and does not wait
  EXPECT_EQ(this->FilterLog.Errors.size(), 0U);
  // The worker first meshes the surface around the tip. The mesh must then follow the tip.
  ASSERT_TRUE(this->IsFeltAs("Surface proxy"));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetResidency() == 1.0; }));
  ASSERT_TRUE(this->Lead(7.0, 7.0, 5.0) && this->WaitFullyArmed() && this->LeadInto(10.0));
  EXPECT_TRUE(this->WaitPressed()); // the press is 3 mm deep, including the proxy's radius
  ASSERT_TRUE(this->Lead(7.0, 7.0, 5.0) && this->Lead(150.0, 150.0, 5.0));
  this->BeginWayHere();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetResidency() == 1.0; }));
  ASSERT_TRUE(this->WaitFullyArmed());
  for (int z = 10; z <= 20; ++z)
  {
    ASSERT_TRUE(this->Lead(150.0, 150.0, 0.5 * z));
  }
  EXPECT_TRUE(this->WaitPressed())
    << Length(this->Device->GetState()->GetForce()) << " N, " << this->Device->GetStatusText();
  EXPECT_TRUE(isMeshing());
  EXPECT_FALSE(this->Device->IsPublished());
  EXPECT_FALSE(this->Device->GetRecorder()->Start(this->File("LongWorkPart.vtp").c_str()));
  this->ExpectError("if its surface is being meshed, wait until IsPublished()");
  this->Device->GetState()->Drain(this->States);
  values->IsOpen = true;
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  EXPECT_FALSE(isMeshing());
  ASSERT_TRUE(this->WaitPressed()) << "the same surface goes on";
  EXPECT_TRUE(this->CountForceless() == 0 || this->HasPaused);
  EXPECT_EQ(this->Starts.Count, 0);

  vtkNew<vtkVolumeHapticsFilter> other;
  other->SetMethodToSurfaceProxy();
  other->SetIsoValue(750.0);
  other->SetInputData(0, image);
  this->ExpectSameMesh(other, std::int64_t{ 2 } * 203 * 203);
}

TEST_F(LongWork, IsNotMeshingWhenTheServoStarts)
{
  vtkNew<GatedArray> values;
  const OpenAtTheEnd opener(values);
  this->Filter->SetInputData(0, MakeLarge(values));
  this->Filter->SetIsoValue(750.0);
  this->Filter->SetMethodToSurfaceProxy();
  EXPECT_TRUE(this->Device->Publish()) << "which only checks, and does not wait for the worker";
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
  this->BeginWayHere();
  ASSERT_TRUE(this->Device->Start());
  EXPECT_FALSE(this->Device->GetRecorder()->Start(this->File("LongWorkStart.vtp").c_str()));
  this->ExpectError("nothing to record");
  EXPECT_TRUE(this->Says("Meanwhile the surface is meshed.")) << this->Device->GetStatusText();
  ASSERT_TRUE(this->IsFeltAs("Surface proxy"));
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(10.0));
  EXPECT_TRUE(this->WaitPressed());
  values->IsOpen = true;
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  EXPECT_EQ(this->Starts.Count, 0);
}

TEST_F(LongWork, IsNotPreparingAGivenSurfaceOfManyTriangles)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(7.0, 7.0, 17.0);
  sphere->SetRadius(10.0);
  sphere->SetThetaResolution(300);
  sphere->SetPhiResolution(300);
  sphere->Update();
  this->Press();
  this->Filter->SetSurfaceData(sphere->GetOutput());
  this->Filter->SetProxyRadius(0.05);
  this->Filter->SetMethodToSurfaceProxy();
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_FALSE(this->Device->IsPublished());
  EXPECT_TRUE(this->Says("Meanwhile the surface is meshed.")) << this->Device->GetStatusText();
  ASSERT_TRUE(this->WaitTicks(10));
  this->ExpectForce();
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  EXPECT_EQ(this->Device->GetMethodText(), "Surface proxy");
  EXPECT_EQ(this->Starts.Count, 0);
  vtkNew<vtkVolumeHapticsFilter> other;
  other->SetMethodToSurfaceProxy();
  other->SetInputData(0, this->Image);
  other->SetSurfaceData(sphere->GetOutput());
  other->SetProxyRadius(0.05);
  this->ExpectSameMesh(other, sphere->GetOutput()->GetNumberOfPolys());

  // An error in the surface must be reported as soon as the worker has found it.
  sphere->GetOutput()->GetPoints()->SetPoint(5, NAN, 0.0, 0.0);
  sphere->GetOutput()->Modified();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return !this->FilterLog.Errors.empty(); }));
  EXPECT_NE(
    this->FilterLog.Errors[0].find("NaN, infinite or beyond 1e30 at point 5"), std::string::npos)
    << this->FilterLog.Errors[0];
}

TEST_F(LongWork, StopsWhileALargeVolumeIsMeshed)
{
  constexpr int n = 204;
  vtkNew<GatedArray> values;
  const OpenAtTheEnd opener(values);
  values->SetNumberOfValues(vtkIdType{ n } * n * n);
  values->FillValue(7);
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->GetPointData()->SetScalars(values);
  ASSERT_NO_FATAL_FAILURE(this->BeginPressed());
  this->Filter->SetInputData(0, image);
  this->Filter->SetIsoValue(700.0);
  this->Filter->SetMethodToSurfaceProxy();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([&] { return values->Asked > 0; }));
  this->Device->Stop();
  EXPECT_FALSE(this->Says("is meshed"));
  EXPECT_FALSE(values->IsOpen) << "nothing waited for the worker";
  values->IsOpen = true;
}

TEST_F(LongWork, IsNotMeshingASmallVolume)
{
  this->Press();
  this->Filter->SetIsoValue(700.0);
  this->Filter->SetMethodToSurfaceProxy();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Device->GetRecorder()->Start(this->File("LongWorkSmall.vtp").c_str()));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_EQ(this->Starts.Count, 0);
}

TEST_F(LongWork, IsNotHashingALargeVolume)
{
  // An image of V = 100 z with 162 MB of samples.
  vtkNew<vtkImageData> image;
  image->SetDimensions(256, 256, 310);
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType k = 0; k < 310; ++k)
  {
    std::fill_n(values->GetPointer(k * 256 * 256), 256 * 256, 100.0 * k);
  }
  image->GetPointData()->SetScalars(values);
  this->Filter->SetInputData(0, image);
  this->Filter->GetProperty()->DistinctnessFromNoiseOff();
  this->Press();
  this->ExpectForce();
  ASSERT_TRUE(this->Device->GetRecorder()->Start(this->File("LongWork.vtp").c_str()));
  ASSERT_TRUE(this->WaitTicks(10));
  this->ExpectForce();
  EXPECT_TRUE(this->Wait([this] { return !this->Says("is hashed"); }));
  EXPECT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_EQ(this->Starts.Count, 0);
  EXPECT_TRUE(this->Log.Warnings.empty());
}
