// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests regions that follow a tip, without a device: the replacement for late samples, memory
 * consumption, and a day of use. Values are closed forms of the indices.
 */

#include "LargeRig.h"

#include "Rigs/Eventually.h"
#include "Rigs/TemporaryFolder.h"
#include "VTK/Regions/RegionPlanner.h"

#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkHapticRegionFilter.h>
#include <vtkPointData.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

using namespace largetest;
using devicetest::Eventually;

namespace
{
/// 125 million samples; the noise is estimated from 512 blocks.
constexpr Extent Cube = { 0, 499, 0, 499, 0, 499 };

/// Returns a value that is linear in the indices, so that interpolation is exact.
double PlainAt(int i, int j, int k)
{
  return 2.0 * i + 3.0 * j - 5.0 * k + 7.0;
}

class LiveRegions : public testing::Test
{
protected:
  LiveRegions()
  {
    const auto gate = this->Gate;
    this->Source->SetWholeExtent(Cube.data());
    this->Source->SetSpacing(0.5, 1.0, 2.0);
    this->Source->SetOrigin(-3.0, 4.0, 5.0);
    this->Source->SetScalarType(VTK_SHORT);
    this->Source->SetMemoryLimit(4194304);
    this->Source->SetReader(
      [gate](const int box[6], void* samples)
      {
        const bool isRegion = box[1] - box[0] > 10;
        gate->Waiting += isRegion;
        while (isRegion && !gate->IsOpen)
        {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        gate->Waiting -= isRegion;
        gate->Most = std::max<std::int64_t>(gate->Most, Count(box));
        ++gate->Calls;
        if (gate->IsBroken)
        {
          throw 7; // an exception that is not a std::exception
        }
        gate->IsFlat ? FillFlat(box, samples) : FillBox<short>(box, samples, PlainAt);
        return true;
      },
      false);
    this->Touch->SetInputConnection(0, this->Source->GetOutputPort());
  }
  ~LiveRegions() override { this->Gate->IsOpen = true; }

  struct Led
  {
    std::atomic<bool> IsOpen{ true };
    std::atomic<bool> IsBroken{ false };
    std::atomic<bool> IsFlat{ false };
    std::atomic<int> Waiting{ 0 };
    std::atomic<int> Calls{ 0 };
    std::atomic<std::int64_t> Most{ 0 };
  };

  static std::int64_t Count(const int box[6])
  {
    return std::int64_t{ box[1] - box[0] + 1 } * (box[3] - box[2] + 1) * (box[5] - box[4] + 1);
  }
  static void FillFlat(const int box[6], void* samples)
  {
    std::memset(samples, 0, static_cast<std::size_t>(Count(box)) * sizeof(short));
  }
  /// Returns the world position of an index.
  static Point At(double i, double j, double k)
  {
    return { -3.0 + 0.5 * i, 4.0 + j, 5.0 + 2.0 * k };
  }
  bool Follow(const Point& tip)
  {
    this->Time += 0.01;
    this->Touch->ConfigureSource(this->Source);
    return this->Source->Follow(tip.data(), this->Time);
  }
  /// Returns the value of the output's array "HapticShare", or 1 without this array.
  double GetShare()
  {
    this->Source->Update();
    vtkDataArray* const share = this->Source->GetOutput()->GetFieldData()->GetArray("HapticShare");
    return share ? share->GetComponent(0, 0) : 1.0;
  }
  /// Follows a tip, and waits until the output has the samples of the volume (`share` is 1) or of
  /// the coarse image.
  bool Await(const Point& tip, double share = 1.0)
  {
    return Eventually(
      [&]
      {
        this->Follow(tip);
        const bool isSo = this->GetShare() == share;
        const int* const extent = this->Source->GetOutput()->GetExtent();
        return isSo && this->Source->GetPlanner().ComputeRoom(tip.data(), extent) >= 0.0;
      });
  }
  void ExpectPlain(int i, int j, int k)
  {
    vtkImageData* const output = this->Source->GetOutput();
    const int* const extent = output->GetExtent();
    EXPECT_TRUE(extent[0] <= i && i <= extent[1] && extent[2] <= j && j <= extent[3] &&
      extent[4] <= k && k <= extent[5]);
    const auto* sample = static_cast<const short*>(output->GetScalarPointer());
    for (int c = extent[4]; c <= extent[5]; ++c)
    {
      for (int b = extent[2]; b <= extent[3]; ++b)
      {
        for (int a = extent[0]; a <= extent[1]; ++a)
        {
          ASSERT_EQ(*sample++, PlainAt(a, b, c)) << a << " " << b << " " << c;
        }
      }
    }
  }

  const std::shared_ptr<Led> Gate = std::make_shared<Led>();
  vtkNew<vtkHapticRegionSource> Source;
  vtkNew<vtkVolumeHapticsFilter> Touch;
  MessageLog Log{ this->Source };
  double Time = 0.0;
};

/// Makes a coarse image with every fourth sample along each axis.
vtkSmartPointer<vtkImageData> MakeCoarse()
{
  constexpr int n = 125;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetSpacing(2.0, 4.0, 8.0);
  image->SetOrigin(-3.0, 4.0, 5.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  FillBox<float>(image->GetExtent(), image->GetScalarPointer(),
    [](int i, int j, int k) { return PlainAt(4 * i, 4 * j, 4 * k); });
  return image;
}
} // namespace

TEST_F(LiveRegions, AreOfTheCoarseImageWhereTheFineOneIsLate)
{
  this->Source->SetCoarseImage(MakeCoarse());
  ASSERT_TRUE(this->Await(At(100, 100, 100)));
  this->Gate->IsOpen = false;
  ASSERT_TRUE(this->Await(At(300, 200, 250), 0.5));
  this->ExpectPlain(300, 200, 250);
  EXPECT_EQ(this->Source->GetStatusText(),
    "The samples around the tip are being read; the coarse image stands in.");
  EXPECT_FALSE(this->Follow(At(300, 200, 250))) << "the stand-in is there";
  ASSERT_TRUE(this->Await(At(100, 400, 50), 0.5)) << "it follows the tip";
  this->ExpectPlain(100, 400, 50);
  // Samples for a position that the tip has left must not replace the coarse samples at the tip.
  ASSERT_TRUE(Eventually([&] { return this->Gate->Waiting == 1; }));
  this->Gate->IsOpen = true;
  ASSERT_TRUE(this->Await(At(100, 400, 50)));
  this->ExpectPlain(100, 400, 50);
  EXPECT_EQ(this->Log.Errors.size(), 0U);
}

TEST_F(LiveRegions, AreOfTheCoarseImageWhereTheReaderThrowsWhatIsNoException)
{
  this->Source->SetCoarseImage(MakeCoarse());
  ASSERT_TRUE(this->Await(At(100, 100, 100)));
  this->Gate->IsBroken = true;
  ASSERT_TRUE(this->Await(At(300, 200, 250), 0.5));
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Follow(At(300, 200, 250));
      return !this->Log.Errors.empty();
    }));
  EXPECT_NE(
    this->Log.Errors[0].find("throws an exception that is no std::exception"), std::string::npos)
    << this->Log.Errors[0];
  this->Gate->IsBroken = false;
  ASSERT_TRUE(this->Await(At(300, 200, 250)));
  this->ExpectPlain(300, 200, 250);
}

TEST_F(LiveRegions, OfACoarseImageWithoutScalarsAreToldAsWrong)
{
  this->Source->SetCoarseImage(vtkSmartPointer<vtkImageData>::New());
  MessageLog executive(this->Source->GetExecutive());
  this->Source->Update();
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("CoarseImage has no point scalars"), std::string::npos);
}

TEST_F(LiveRegions, BeyondACoarseImageAreAsAtItsBorderAndRoundedToTheType)
{
  // The coarse image has three values along x: -0.6, 10.4, and 1e9, which is too large for the type
  // of the volume.
  vtkNew<vtkImageData> coarse;
  coarse->SetDimensions(3, 2, 2);
  coarse->SetSpacing(100.0, 499.0, 998.0);
  coarse->SetOrigin(47.0, 4.0, 5.0); // puts the samples at i = 100, 300 and 500
  coarse->AllocateScalars(VTK_DOUBLE, 1);
  FillBox<double>(coarse->GetExtent(), coarse->GetScalarPointer(),
    [](int i, int, int) { return i == 0 ? -0.6
                            : i == 1    ? 10.4
                                        : 1e9; });
  this->Source->SetCoarseImage(coarse);
  ASSERT_TRUE(this->Await(At(250, 250, 250)));
  this->Gate->IsOpen = false;
  const auto valueAt = [&](int i)
  {
    EXPECT_TRUE(this->Await(At(i, 100, 100), 0.5));
    return this->Source->GetOutput()->GetScalarComponentAsDouble(i, 100, 100, 0);
  };
  EXPECT_EQ(valueAt(20), -1.0);
  EXPECT_EQ(valueAt(300), 10.0);
  EXPECT_EQ(valueAt(480), std::numeric_limits<short>::max());
}

TEST_F(LiveRegions, GoThroughADayInTheirMemory)
{
  // The hand wanders for 24 hours, with one step every half second.
  this->Gate->IsFlat = true;
  ASSERT_TRUE(this->Await(At(250, 250, 250)));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(-12.0, 12.0);
  std::array<double, 3> index = { 250.0, 250.0, 250.0 };
  constexpr int steps = 24 * 3600 * 2;
  int regions = 0;
  for (int s = 0; s < steps; ++s)
  {
    for (double& x : index)
    {
      x = std::clamp(x + step(random), 0.0, 499.0);
    }
    const Point tip = At(index[0], index[1], index[2]);
    this->Time += 0.5;
    this->Touch->ConfigureSource(this->Source);
    if (this->Source->Follow(tip.data(), this->Time))
    {
      ++regions;
      this->Source->Update();
      ASSERT_LE(4 * Count(this->Source->GetOutput()->GetExtent()) * 2, 4194304);
    }
  }
  EXPECT_GT(regions, 100);
  EXPECT_LE(4 * this->Gate->Most * 2, 4194304) << "a region takes a quarter of the memory";
  EXPECT_EQ(this->Source->GetStatusText().find("can't"), std::string::npos);
  EXPECT_EQ(this->Log.Errors.size(), 0U);
  // At the end, the samples at the last position must arrive.
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Follow(At(index[0], index[1], index[2]));
      return !this->Source->IsWaiting();
    }));
}

TEST_F(LiveRegions, OfAFileThatShrinksAreToldAndComeBackWhenItGrows)
{
  const std::string name = TemporaryPath("shrinks.raw");
  constexpr std::uintmax_t bytes = 500ULL * 500 * 500 * 2;
  std::ofstream(name).put('\0');
  std::filesystem::resize_file(name, bytes); // makes the file sparse
  this->Source->SetReader({});
  this->Source->SetFileName(name.c_str());
  ASSERT_TRUE(this->Await(At(100, 100, 100)));
  std::filesystem::resize_file(name, bytes / 2);
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Follow(At(250, 250, 450));
      return !this->Log.Errors.empty();
    }));
  EXPECT_NE(this->Log.Errors[0].find("it ends before byte"), std::string::npos)
    << this->Log.Errors[0];
  std::filesystem::resize_file(name, bytes);
  EXPECT_TRUE(this->Await(At(250, 250, 450)));
  std::filesystem::remove(name);
}
