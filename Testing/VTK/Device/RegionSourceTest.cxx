// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a device on a volume that is read in regions. The force starts when the samples are
 * available, fades if a reader is late or fails, and returns. It never changes faster than the slew
 * limit allows.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/Growth.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkHapticRegionSource.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <random>
#include <stdexcept>
#include <thread>

using namespace devicetest;

namespace
{
/// Flags by which a test controls and observes its reader.
struct Led
{
  std::atomic<bool> IsOpen{ true };
  std::atomic<bool> IsBroken{ false };
  std::atomic<bool> GivesNumbers{ true };
  std::atomic<bool> GivesJunk{ false };
  std::atomic<int> Waiting{ 0 };
};

/// Fills the samples with random bits: numbers of all magnitudes, infinities and NaN.
void FillJunk(const int box[6], void* samples)
{
  const std::int64_t place = box[0] + 2000 * (box[2] + std::int64_t{ 2000 } * box[4]);
  std::mt19937 random(static_cast<unsigned>(place));
  auto* to = static_cast<char*>(samples);
  const std::int64_t slice =
    std::int64_t{ box[1] - box[0] + 1 } * std::int64_t{ box[3] - box[2] + 1 };
  for (std::int64_t n = slice * (box[5] - box[4] + 1); n > 0; --n)
  {
    const auto bits = static_cast<std::uint32_t>(random());
    std::memcpy(to, &bits, sizeof(bits));
    to += sizeof(bits);
  }
}

/// A grid whose cells block all threads except the test's until the grid is open. This also applies
/// to copies of the grid.
class LedGrid : public vtkRectilinearGrid
{
public:
  static LedGrid* New() { VTK_STANDARD_NEW_BODY(LedGrid); }
  vtkTypeMacro(LedGrid, vtkRectilinearGrid);
  void GetCellBounds(vtkIdType cell, double bounds[6]) override
  {
    while (!IsOpen && std::this_thread::get_id() != Owner)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    this->Superclass::GetCellBounds(cell, bounds);
  }

  static inline std::atomic<bool> IsOpen{ true };
  static inline const std::thread::id Owner = std::this_thread::get_id();
};

/// A volume V = 100 z of 2000^3 samples, which would take 32 GB as float.
class RegionSource : public DeviceTest
{
protected:
  RegionSource()
  {
    this->Source->SetWholeExtent(0, 1999, 0, 1999, 0, 1999);
    this->Source->SetScalarType(VTK_FLOAT);
    this->Source->SetMemoryLimit(4194304);
    const auto led = this->Reader;
    this->Source->SetReader(
      [led](const int box[6], void* samples)
      {
        ++led->Waiting;
        while (!led->IsOpen)
        {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        --led->Waiting;
        if (led->IsBroken)
        {
          throw std::runtime_error("the disk is on fire.");
        }
        if (led->GivesJunk)
        {
          FillJunk(box, samples);
          return true;
        }
        const bool gives = led->GivesNumbers;
        auto* sample = static_cast<float*>(samples);
        for (int k = box[4]; k <= box[5]; ++k)
        {
          for (int n = (box[1] - box[0] + 1) * (box[3] - box[2] + 1); n > 0; --n)
          {
            *sample++ = gives ? 100.0F * static_cast<float>(k) : NAN;
          }
        }
        return true;
      });
    this->Filter->SetInputConnection(0, this->Source->GetOutputPort());
  }
  /// Starts and arms the servo with the tip in the middle of the volume, and waits for the samples
  /// there.
  void BeginInTheMiddle()
  {
    this->BeginWayHere();
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetPosition(1000.0, 1000.0, 1000.0);
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->WaitTicks(2));
    ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
    ASSERT_TRUE(this->ArmFully());
    this->Device->GetState()->Drain(this->States);
  }
  void Press(double x = 1000.0)
  {
    for (int z = 0; z <= 6; ++z)
    {
      ASSERT_TRUE(this->Lead(x, 1000.0, 1000.0 + z));
    }
    ASSERT_TRUE(this->WaitForce());
  }
  bool Says(const char* words)
  {
    return this->Device->GetStatusText().find(words) != std::string::npos;
  }
  /// Expects that no force command since the last call exceeds the maximum force, or grows by more
  /// than the slew limit.
  void ExpectNoStep()
  {
    this->Device->GetState()->Drain(this->States);
    auto* const command = vtkDataArray::SafeDownCast(this->States->GetColumnByName("Command"));
    auto* const time = vtkDataArray::SafeDownCast(this->States->GetColumnByName("Time"));
    ASSERT_TRUE(command && time && command->GetNumberOfTuples() > 10);
    const auto at = [&](vtkIdType t)
    {
      const double* const f = command->GetTuple3(t);
      return VolumeHaptics::Vector3{ f[0], f[1], f[2] };
    };
    for (vtkIdType t = 1; t < command->GetNumberOfTuples(); ++t)
    {
      EXPECT_LE(Norm(at(t)), this->Device->GetMaximumForce() * (1.0 + 1e-9));
      const double elapsed =
        std::max(0.001, time->GetComponent(t, 0) - time->GetComponent(t - 1, 0));
      EXPECT_LE(servotest::GrowthOf(at(t - 1), at(t)),
        this->Device->GetMaximumForceRate() * elapsed * (1.0 + 1e-6));
    }
  }

  /// Returns how many samples of the region are not finite.
  int CountJunk()
  {
    auto* const samples =
      vtkFloatArray::SafeDownCast(this->Source->GetOutput()->GetPointData()->GetScalars());
    int count = 0;
    for (vtkIdType i = 0; samples && i < samples->GetNumberOfTuples(); ++i)
    {
      count += std::isfinite(samples->GetValue(i)) ? 0 : 1;
    }
    return count;
  }

  const std::shared_ptr<Led> Reader = std::make_shared<Led>();
  vtkSmartPointer<vtkHapticRegionSource> Source = vtkSmartPointer<vtkHapticRegionSource>::New();
  MessageLog SourceLog{ this->Source };
  vtkNew<vtkTable> States;
};
} // namespace

TEST_F(RegionSource, IsFeltAndFollowsTheHand)
{
  this->BeginInTheMiddle();
  this->Press();
  const double pressed = Length(this->Device->GetState()->GetForce());
  EXPECT_GT(pressed, 0.5);
  EXPECT_LT(
    4.0 * this->Filter->GetInputDataObject(0, 0)->GetActualMemorySize() * 1024.0, 1.1 * 4194304.0);
  // Move the tip out of the region, where the volume must be felt, too.
  ASSERT_TRUE(this->Lead(1000.0, 1000.0, 998.0));
  ASSERT_TRUE(this->Lead(1400.0, 1000.0, 998.0));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  ASSERT_TRUE(this->WaitFullyArmed());
  this->Press(1400.0);
  EXPECT_TRUE(this->Wait([&] { return !this->Says("being read"); }))
    << this->Device->GetStatusText();
  this->ExpectNoStep();
  EXPECT_EQ(this->SourceLog.Errors.size(), 0U);
}

/// The isosurface is the plane z = 1000 mm. It stops the proxy, a sphere of 0.5 mm, at z = 999.5
/// mm, so the force is the stiffness times the distance from there to the tip. The region has 8
/// million samples, whose surface takes more than 40 ms to mesh.
TEST_F(RegionSource, HasASurfaceThatIsMeshedInTheBackground)
{
  this->Source->SetMemoryLimit(134217728);
  this->Source->SetMaximumSpeed(10.0);
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(100000.0);
  this->Filter->SetProxyRadius(0.5);
  SetConstant(this->Filter->GetProperty()->GetStiffness(), 500.0);
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetPosition(1000.0, 1000.0, 998.0);
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->Wait([&] { return this->Says("the surface is meshed"); }));
  const int* const extent = this->Source->GetOutput()->GetExtent();
  EXPECT_GT(extent[1] - extent[0], 150);
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  EXPECT_FALSE(this->Says("the surface is meshed"));
  ASSERT_TRUE(this->ArmFully());
  this->Device->GetState()->Drain(this->States);
  ASSERT_TRUE(this->Lead(1000.0, 1000.0, 1002.0));
  ASSERT_TRUE(this->Wait([&] { return Length(this->Device->GetState()->GetForce()) > 0.9; }));
  const double* const proxy = this->Device->GetState()->GetProxyPosition();
  EXPECT_NEAR(proxy[2], 999.5, 0.01) << "the surface is in its place in the whole";
  ASSERT_TRUE(this->Wait(
    [&] { return std::abs(Length(this->Device->GetState()->GetForce()) - 1.25) < 0.01; }))
    << Length(this->Device->GetState()->GetForce());
  ASSERT_TRUE(this->WaitTicks(20));
  this->ExpectNoStep();
  EXPECT_EQ(this->SourceLog.Errors.size(), 0U);
}

TEST_F(RegionSource, GivesNoForceBeforeItsSamplesAreThere)
{
  this->Reader->IsOpen = false;
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetPosition(1000.0, 1000.0, 1000.0);
  ASSERT_TRUE(this->Device->Start()) << "without waiting for the reader";
  this->Device->GetState()->Drain(this->States);
  this->Device->Arm();
  ASSERT_TRUE(this->WaitTicks(20));
  ASSERT_TRUE(this->Wait([&] { return this->Reader->Waiting == 1; }));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 0.0; }));
  EXPECT_TRUE(this->Says("The noise of the volume is being estimated."))
    << this->Device->GetStatusText();
  this->Device->GetState()->Drain(this->States);
  auto* const command = vtkDataArray::SafeDownCast(this->States->GetColumnByName("Command"));
  ASSERT_TRUE(command && command->GetNumberOfTuples() > 10);
  EXPECT_EQ(command->GetMaxNorm(), 0.0);
  this->Reader->IsOpen = true;
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  this->Press();
  this->ExpectNoStep();
}

TEST_F(RegionSource, ThatIsLateFadesAndComesBack)
{
  this->BeginInTheMiddle();
  this->Press();
  this->Reader->IsOpen = false;
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1006.0));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 0.0; }));
  ASSERT_TRUE(this->Wait([&] { return Length(this->Device->GetState()->GetForce()) == 0.0; }));
  EXPECT_TRUE(this->Says("The samples around the tip are being read."))
    << this->Device->GetStatusText();
  EXPECT_TRUE(this->Source->IsWaiting());
  this->Reader->IsOpen = true;
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1012.0));
  ASSERT_TRUE(this->WaitForce());
  this->ExpectNoStep();
}

/// A blocked worker resamples a grid around the tip. The force must fade, and return with the
/// samples.
TEST_F(RegionSource, OfADataSetThatIsLateFadesAndComesBack)
{
  vtkNew<LedGrid> grid;
  vtkNew<vtkDoubleArray> along;
  for (int i = 0; i <= 20; ++i)
  {
    along->InsertNextValue(100.0 * i);
  }
  grid->SetDimensions(21, 21, 21);
  grid->SetXCoordinates(along);
  grid->SetYCoordinates(along);
  grid->SetZCoordinates(along);
  vtkNew<vtkDoubleArray> values;
  values->SetName("V");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(100.0 * grid->GetPoint(i)[2]);
  }
  grid->GetPointData()->SetScalars(values);
  vtkNew<vtkHapticRegionSource> source;
  source->SetMemoryLimit(4194304);
  ASSERT_TRUE(source->OpenDataSet(grid, 1.0));
  this->Filter->SetInputConnection(0, source->GetOutputPort());
  this->BeginInTheMiddle();
  this->Press();
  LedGrid::IsOpen = false;
  EXPECT_TRUE(this->Lead(1200.0, 1000.0, 1006.0));
  EXPECT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 0.0; }));
  EXPECT_TRUE(this->Wait([&] { return Length(this->Device->GetState()->GetForce()) == 0.0; }));
  EXPECT_TRUE(source->IsWaiting());
  LedGrid::IsOpen = true;
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1012.0));
  ASSERT_TRUE(this->WaitForce());
  this->ExpectNoStep();
}

TEST_F(RegionSource, ThatIsLateHasACoarseImageThatIsFeltByHalf)
{
  // The coarse image also has the values V = 100 z.
  vtkNew<vtkImageData> coarse;
  coarse->SetDimensions(21, 21, 21);
  coarse->SetSpacing(100.0, 100.0, 100.0);
  coarse->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 21 * 21 * 21; ++i)
  {
    static_cast<float*>(coarse->GetScalarPointer())[i] = 1e4F * static_cast<float>(i / 441);
  }
  this->Source->SetCoarseImage(coarse);
  this->BeginInTheMiddle();
  this->Press();
  const double whole = Length(this->Device->GetState()->GetForce());
  ASSERT_TRUE(this->Lead(1000.0, 1000.0, 998.0));
  this->Reader->IsOpen = false;
  ASSERT_TRUE(this->Lead(1300.0, 1000.0, 998.0));
  this->BeginWayHere();
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 0.5; }));
  EXPECT_TRUE(this->Says("the coarse image stands in")) << this->Device->GetStatusText();
  this->Press(1300.0);
  EXPECT_TRUE(this->Wait([&]
    { return std::abs(Length(this->Device->GetState()->GetForce()) - 0.5 * whole) < 0.1 * whole; }))
    << Length(this->Device->GetState()->GetForce()) << " N, of " << whole;
  this->Reader->IsOpen = true;
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  // Press again, because the contact may have faded on a busy machine.
  ASSERT_TRUE(this->Lead(1300.0, 1000.0, 998.0));
  this->Press(1300.0);
  this->ExpectNoStep();
  EXPECT_EQ(this->SourceLog.Errors.size(), 0U);
}

TEST_F(RegionSource, ThatFailsIsToldFadesAndIsTriedAgain)
{
  this->BeginInTheMiddle();
  this->Press();
  this->Reader->IsBroken = true;
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1006.0));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 0.0; }));
  ASSERT_TRUE(this->Wait([&] { return this->Says("the disk is on fire."); }))
    << this->Device->GetStatusText();
  EXPECT_TRUE(this->Says("can't be read from the reader"));
  ASSERT_TRUE(this->WaitTicks(300));
  ASSERT_EQ(this->SourceLog.Errors.size(), 1U) << "once, not with every attempt";
  EXPECT_NE(this->SourceLog.Errors[0].find("The samples ("), std::string::npos);
  this->Reader->IsBroken = false;
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  EXPECT_FALSE(this->Says("on fire"));
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1012.0));
  ASSERT_TRUE(this->WaitForce());
  this->ExpectNoStep();
}

TEST_F(RegionSource, OfSamplesThatAreNotNumbersGivesNoForce)
{
  this->BeginInTheMiddle();
  this->Press();
  this->Reader->GivesNumbers = false;
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1006.0));
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1012.0));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
  EXPECT_LT(Length(this->Device->GetState()->GetForce()), 1e-9);
  this->ExpectNoStep();
}

TEST_F(RegionSource, OfJunkStaysWithinTheLimitsAndIsFeltAgainWhenItIsMended)
{
  this->BeginInTheMiddle();
  this->Press();
  this->Reader->GivesJunk = true;
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1006.0));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  for (int i = 0; i < 40; ++i)
  {
    if (this->Device->GetStatus() == vtkHapticDevice::FAULT)
    {
      this->Device->Arm(); // arms again, as an insistent user does
    }
    ASSERT_TRUE(
      this->Lead(1200.0 + 0.7 * (i % 7), 1000.0 + 0.9 * (i % 5), 1006.0 + 0.3 * (i % 11)));
    ASSERT_TRUE(this->WaitTicks(5));
  }
  EXPECT_GT(this->CountJunk(), 0) << "samples that are not finite";
  this->ExpectNoStep();
  this->Reader->GivesJunk = false;
  this->Source->Reload();
  ASSERT_TRUE(this->Lead(1000.0, 1000.0, 998.0));
  this->BeginWayHere();
  ASSERT_TRUE(this->Wait(
    [&] { return !this->Source->IsWaiting() && this->Device->GetState()->GetResidency() == 1.0; }));
  // Leave the surface, and press again once the device is fully armed.
  this->Device->Arm();
  ASSERT_TRUE(this->Lead(1000.0, 1000.0, 990.0));
  ASSERT_TRUE(this->WaitFullyArmed());
  this->Press();
  this->ExpectNoStep();
}

TEST_F(RegionSource, ThatIsReloadedIsFeltAsItIsThen)
{
  this->BeginInTheMiddle();
  this->Press();
  this->Reader->GivesNumbers = false;
  this->Source->Reload();
  ASSERT_TRUE(this->Wait(
    [&]
    {
      return this->Device->GetState()->GetResidency() == 1.0 &&
        Length(this->Device->GetState()->GetForce()) == 0.0;
    }));
  this->Reader->GivesNumbers = true;
  this->Source->Reload();
  ASSERT_TRUE(this->Wait([&] { return !this->Source->IsWaiting(); }));
  ASSERT_TRUE(this->Lead(1000.0, 1000.0, 1000.0));
  ASSERT_TRUE(this->WaitFullyArmed());
  this->Press();
  this->ExpectNoStep();
}

TEST_F(RegionSource, CanGoWhileItIsBeingRead)
{
  this->BeginInTheMiddle();
  this->Press();
  this->Reader->IsOpen = false;
  ASSERT_TRUE(this->Lead(1200.0, 1000.0, 1006.0));
  ASSERT_TRUE(this->Wait([&] { return this->Reader->Waiting == 1; }));
  std::thread opener(
    [led = this->Reader]
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      led->IsOpen = true;
    });
  this->Filter->SetInputData(0, this->Image);
  this->Source = nullptr;
  opener.join();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(20));
}

TEST_F(RegionSource, IsNotRecorded)
{
  this->BeginInTheMiddle();
  EXPECT_FALSE(this->Device->GetRecorder()->Start(this->File("Large.vtp").c_str()));
  this->ExpectError("region of a larger volume can't be recorded");
}

TEST_F(RegionSource, ReplaysNoRecording)
{
  const std::string file = this->File("Whole.vtp");
  this->Filter->SetInputData(0, this->Image);
  this->Begin();
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  ASSERT_TRUE(this->WaitTicks(20));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkVolumeHapticsFilter> replay;
  replay->SetInputConnection(0, this->Source->GetOutputPort());
  replay->SetPathConnection(reader->GetOutputPort());
  const MessageLog log(replay);
  const MessageLog executive(replay->GetExecutive());
  replay->Update();
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("recording, which can't be replayed"), std::string::npos);
  EXPECT_EQ(replay->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(RegionSource, FollowsNothingWithoutATip)
{
  const double tip[3] = { 1000.0, 1000.0, 1000.0 };
  EXPECT_FALSE(this->Source->Follow(nullptr, 0.0));
  EXPECT_EQ(this->SourceLog.Errors.size(), 1U);
  const double nowhere[3] = { NAN, NAN, NAN };
  this->Filter->ConfigureSource(this->Source);
  ASSERT_TRUE(Eventually([&] { return this->Source->Follow(nowhere, 1.0); }));
  EXPECT_EQ(this->SourceLog.Errors.size(), 1U);
}

// The corners of the segmentation have the value -32768. FilterOutsideTest.cxx tests images in
// memory.
TEST_F(RegionSource, LabelsAreReadAsTheyAre)
{
  vtkNew<vtkHapticRegionSource> source;
  MessageLog log(source);
  source->SetWholeExtent(0, 63, 0, 63, 0, 63);
  source->SetScalarType(VTK_SHORT);
  source->SetReader(
    [](const int box[6], void* samples)
    {
      auto* to = static_cast<short*>(samples);
      for (int k = box[4]; k <= box[5]; ++k)
      {
        for (int j = box[2]; j <= box[3]; ++j)
        {
          for (int i = box[0]; i <= box[1]; ++i)
          {
            *to++ = static_cast<short>(i < 20 ? -32768 : i < 40 ? 1 : 2);
          }
        }
      }
      return true;
    });
  const double tip[3] = { 30.0, 30.0, 30.0 };
  for (const bool areLabels : { true, false, true })
  {
    this->Filter->GetProperty()->SetScalarsAreLabels(areLabels);
    this->Filter->ConfigureSource(source);
    ASSERT_TRUE(Eventually([&] { return source->Follow(tip, 1.0); }));
    source->Update();
    EXPECT_EQ(
      source->GetOutput()->GetScalarComponentAsDouble(5, 30, 30, 0), areLabels ? -32768.0 : 1.0);
    EXPECT_EQ(source->GetOutput()->GetScalarComponentAsDouble(50, 30, 30, 0), 2.0);
    EXPECT_EQ(log.Warnings.empty(), areLabels);
    log.Warnings.clear();
  }
}
