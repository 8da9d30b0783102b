// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that paths through a volume that is read in regions have bitwise the same trace as through
 * the whole volume in memory, in any order of the regions. The reference is the filter on a
 * vtkImageData.
 */

#include "LargeRig.h"

#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>

#include <map>
#include <sstream>
#include <stdexcept>

using namespace largetest;

namespace
{
constexpr Extent Long = { -7, 592, 3, 112, 20, 119 };

class LargePaths : public testing::Test
{
protected:
  LargePaths()
  {
    this->Source->SetOrigin(-20.0, 7.0, 3.0);
    this->Source->SetSpacing(0.8, 1.0, 1.2);
    const double direction[9] = { 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1 };
    this->Source->SetDirection(direction);
    for (vtkVolumeHapticsFilter* filter : { this->Touch.Get(), this->TouchRegions.Get() })
    {
      filter->SetIsoValue(500.0);
      filter->SetForceFieldGain(0.01);
      SetConstant(filter->GetProperty()->GetFriction(), 0.2);
      SetConstant(filter->GetProperty()->GetViscosity(), 0.1);
      SetConstant(filter->GetProperty()->GetSurfaceStrength(), 0.8);
    }
    this->TouchRegions->SetInputConnection(0, this->Source->GetOutputPort());
  }
  /// Returns the world position of an index.
  Point At(double i, double j, double k)
  {
    const double x = 0.8 * i;
    return { -20.0 + 0.8 * x - 0.6 * j, 7.0 + 0.6 * x + 0.8 * j, 3.0 + 1.2 * k };
  }
  /// Makes a path along most of the bed, in and out of it.
  std::vector<Point> Slide(int ticks, double j = 57.0)
  {
    std::vector<Point> path;
    for (int t = 0; t < ticks; ++t)
    {
      const double i = 20.0 + 540.0 * t / ticks;
      const double top = TopAt(static_cast<int>(i), static_cast<int>(j));
      path.push_back(this->At(i, j, top + 1.0 - 3.0 * std::sin(0.013 * t)));
    }
    return path;
  }
  void SetMethod(const char* name)
  {
    EXPECT_TRUE(this->Touch->SetMethodByName(name));
    EXPECT_TRUE(this->TouchRegions->SetMethodByName(name));
  }
  void SetPath(vtkPolyData* path)
  {
    this->Touch->SetPathData(path);
    this->TouchRegions->SetPathData(path);
  }
  void MakeTraces(int type, const ValueAt& value)
  {
    const auto whole = MakeWhole(this->Source, type, value);
    this->Touch->SetInputData(0, whole);
    this->Touch->Update();
    this->TouchRegions->Update();
    EXPECT_EQ(this->Log.Errors.size(), 0U);
    EXPECT_GT(this->Felt()->GetPointData()->GetArray("Force")->GetMaxNorm(), 0.1) << "it is felt";
    EXPECT_EQ(this->Touch->GetProperty()->GetNoiseRamp()[0],
      this->TouchRegions->GetProperty()->GetNoiseRamp()[0]);
  }
  vtkPolyData* Felt() { return this->Touch->GetOutput(); }
  void ExpectError(const std::vector<std::string>& words)
  {
    this->TouchRegions->Update();
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->Log.Errors[0].find(word), std::string::npos) << this->Log.Errors[0];
    }
    EXPECT_EQ(this->TouchRegions->GetOutput()->GetNumberOfPoints(), 0);
    this->Log.Errors.clear();
  }

  const std::shared_ptr<Reads> Counted = std::make_shared<Reads>();
  vtkSmartPointer<vtkHapticRegionSource> Source = MakeSource(Long, VTK_SHORT, BedAt, this->Counted);
  vtkNew<vtkVolumeHapticsFilter> Touch;
  vtkNew<vtkVolumeHapticsFilter> TouchRegions;
  MessageLog Log{ this->TouchRegions };
  MessageLog ExecutiveLog{ this->TouchRegions->GetExecutive() };
};

class RegionSource
  : public LargePaths
  , public testing::WithParamInterface<const char*>
{
};
} // namespace

TEST_P(RegionSource, IsFeltAsTheWhole)
{
  const bool isMeshed = std::string(this->GetParam()) == "surface-proxy";
  this->SetMethod(this->GetParam());
  this->SetPath(MakePath(this->Slide(3000)));
  this->MakeTraces(VTK_SHORT, BedAt);
  vtkPolyData* const felt = this->TouchRegions->GetOutput();
  EXPECT_EQ(felt->GetNumberOfPoints(), 3000);
  if (isMeshed)
  {
    // The mesh differs, so the proxy's sphere touches the triangles in another order.
    vtkDataArray* const a = this->Felt()->GetPointData()->GetArray("Force");
    vtkDataArray* const b = felt->GetPointData()->GetArray("Force");
    for (vtkIdType t = 0; t < 3 * 3000; ++t)
    {
      ASSERT_NEAR(a->GetComponent(t / 3, t % 3), b->GetComponent(t / 3, t % 3), 1e-7) << t / 3;
    }
  }
  else
  {
    EXPECT_TRUE(IsSame(this->Felt(), felt));
  }
  // The whole volume has 6.6 million samples. It must be read in several small regions along the
  // path.
  EXPECT_GT(this->Counted->Calls, 12);
  EXPECT_LE(this->Counted->Most, 1 << 20);
}
INSTANTIATE_TEST_SUITE_P(Methods, RegionSource,
  testing::Values("proxy", "paper", "force-field", "surface-proxy", "local-surface"),
  [](const auto& info)
  {
    std::string name = info.param;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
  });

TEST_F(LargePaths, AreFeltAsIfEachWereAlone)
{
  const auto points = MakePath(this->Slide(900));
  vtkNew<vtkPolyData> paths;
  paths->SetPoints(points->GetPoints());
  vtkNew<vtkCellArray> lines;
  for (vtkIdType line = 0; line < 9; ++line)
  {
    // Order the lines so that each line starts in a different region than the one where the last
    // line ended.
    lines->InsertNextCell(100);
    for (vtkIdType t = 0; t < 100; ++t)
    {
      lines->InsertCellPoint(100 * ((4 * line) % 9) + t);
    }
  }
  paths->SetLines(lines);
  this->SetPath(paths);
  this->MakeTraces(VTK_SHORT, BedAt);
  EXPECT_TRUE(IsSame(this->Felt(), this->TouchRegions->GetOutput()));
  EXPECT_EQ(this->TouchRegions->GetOutput()->GetNumberOfLines(), 9);
}

TEST_F(LargePaths, MayBeginAndEndOutsideOfTheVolume)
{
  this->SetPath(MakePath(Line(this->At(290, 57, 400), this->At(290, 57, 30), 900)));
  this->MakeTraces(VTK_SHORT, BedAt);
  EXPECT_TRUE(IsSame(this->Felt(), this->TouchRegions->GetOutput()));
  this->SetPath(MakePath(Line(this->At(-60, -40, 45), this->At(660, 150, 45), 900)));
  this->MakeTraces(VTK_SHORT, BedAt);
  EXPECT_TRUE(IsSame(this->Felt(), this->TouchRegions->GetOutput()));
}

TEST_F(LargePaths, MayJumpFarInOneTick)
{
  this->SetPath(MakePath({ this->At(30, 57, 60), this->At(30, 57, 49), this->At(560, 57, 49),
    this->At(560, 57, 48.5), this->At(40, 30, 60), this->At(40, 30, 47), this->At(40, 30, 46) }));
  this->MakeTraces(VTK_SHORT, BedAt);
  EXPECT_TRUE(IsSame(this->Felt(), this->TouchRegions->GetOutput()));
}

TEST_F(LargePaths, MeetSamplesThatAreNotNumbersAsInMemory)
{
  const ValueAt holes = [](int i, int j, int k)
  {
    const bool isHole = (i + 2 * j + 3 * k) % 97 == 0 || (i == -7 && j == 3 && k == 20);
    return isHole ? std::nan("") : BedAt(i, j, k);
  };
  const auto source = MakeSource(Long, VTK_FLOAT, holes);
  source->SetOrigin(this->Source->GetOrigin());
  source->SetSpacing(this->Source->GetSpacing());
  source->SetDirection(this->Source->GetDirection());
  this->Source = source;
  this->TouchRegions->SetInputConnection(0, source->GetOutputPort());
  this->SetPath(MakePath(this->Slide(600)));
  this->MakeTraces(VTK_FLOAT, holes);
  EXPECT_TRUE(IsSame(this->Felt(), this->TouchRegions->GetOutput()));
}

TEST_F(LargePaths, TellWhichSamplesCouldNotBeReadAndGoOnLater)
{
  auto isBroken = std::make_shared<bool>(false);
  this->Source->SetReader(
    [isBroken](const int box[6], void* samples)
    {
      if (*isBroken)
      {
        throw std::runtime_error("the cable is out.");
      }
      FillBox(VTK_SHORT, box, samples, BedAt);
      return true;
    });
  this->SetPath(MakePath(this->Slide(300)));
  this->MakeTraces(VTK_SHORT, BedAt);
  *isBroken = true;
  this->TouchRegions->Modified();
  this->ExpectError({ "The samples (-7 to ", "can't be read from the reader: the cable is out." });
  *isBroken = false;
  this->TouchRegions->Modified();
  this->TouchRegions->Update();
  EXPECT_TRUE(IsSame(this->Felt(), this->TouchRegions->GetOutput()));
  this->Source->SetReader([](const int[6], void*) { return false; });
  this->ExpectError({ "can't be read from the reader: it gives no samples" });
  this->Source->SetReader([](const int[6], void*) -> bool { throw 7; });
  this->ExpectError({ "throws an exception" });
}

TEST_F(LargePaths, OfATipThatJumpsThroughABillionSamplesAreRefused)
{
  const auto source = MakeSource(
    { 0, 2719, 0, 2719, 0, 2719 }, VTK_SHORT, [](int, int, int k) { return k > 1360 ? 9.0 : 0.0; });
  this->TouchRegions->SetInputConnection(0, source->GetOutputPort());
  this->TouchRegions->SetPathData(MakePath({ { 5, 5, 5 }, { 2700, 2700, 2700 } }));
  this->ExpectError({ "jumps so far", "more points" });
  this->TouchRegions->SetPathData(MakePath({ { 5, 5, 1355 }, { 9, 9, 1362 } }, { 0.0, 0.1 }));
  this->TouchRegions->Update();
  EXPECT_EQ(this->TouchRegions->GetOutput()->GetNumberOfPoints(), 101);
  EXPECT_GT(Get(this->TouchRegions->GetOutput(), "NormalForce", 100), 0.1);
}

TEST_F(LargePaths, WithoutPointsAreEmpty)
{
  vtkNew<vtkPolyData> empty;
  this->TouchRegions->SetPathData(empty);
  this->TouchRegions->Update();
  EXPECT_EQ(this->TouchRegions->GetOutput()->GetNumberOfPoints(), 0);
  this->TouchRegions->SetPathData(nullptr);
  this->TouchRegions->Update();
  EXPECT_EQ(this->TouchRegions->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Log.Errors.size(), 0U);
}

TEST(RegionSourceSettings, ThatAreMissingAreOneErrorWithTheCure)
{
  const auto expect = [](vtkHapticRegionSource* source, const char* words)
  {
    const MessageLog log(source);
    const MessageLog executive(source->GetExecutive());
    source->Update();
    ASSERT_EQ(log.Errors.size(), 1U) << words;
    EXPECT_NE(log.Errors[0].find(words), std::string::npos) << log.Errors[0];
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  };
  vtkNew<vtkHapticRegionSource> source;
  expect(source, "SetWholeExtent()");
  source->SetWholeExtent(0, 9, 0, 9, 0, 9);
  expect(source, "SetFileName()");
  source->SetFileName("/nowhere.raw");
  for (const int type : { VTK_STRING, VTK_OPAQUE, VTK_VARIANT, VTK_VOID, VTK_BIT, -1, 77 })
  {
    source->SetScalarType(type);
    expect(source, ("ScalarType " + std::to_string(type) + " is no type of numbers").c_str());
  }
  source->SetScalarType(VTK_DOUBLE);
  source->SetWholeExtent(0, 2147483646, 0, 2147483646, 0, 2147483646);
  expect(source, "more samples than can be counted");
}

TEST(RegionSourceSettings, TheEndingsAreThoseOfTheFormats)
{
  std::istringstream endings(vtkHapticRegionSource::GetFileEndings());
  const std::map<std::string, std::string> formats = { { ".vtkhdf", "VTKHDF" },
    { ".hdf", "VTKHDF" }, { ".mhd", "MetaImage" }, { ".mha", "MetaImage" }, { ".nrrd", "NRRD" },
    { ".nhdr", "NRRD" }, { ".mgh", "FreeSurfer" }, { ".mgz", "FreeSurfer" }, { ".mnc", "MINC" },
    { ".tif", "TIFF" }, { ".tiff", "TIFF" }, { ".zarr", "Zarr" }, { ".zarr/", "Zarr" } };
  std::size_t count = 1; // counts ".zarr/", which is not listed separately
  for (std::string ending; endings >> ending; ++count)
  {
    EXPECT_EQ(formats.count(ending), 1U) << ending;
  }
  EXPECT_EQ(count, formats.size());
  for (const auto& [ending, format] : formats)
  {
    EXPECT_EQ(vtkHapticRegionSource::GetFileFormat(("a" + ending).c_str()), format) << ending;
  }
  EXPECT_EQ(vtkHapticRegionSource::GetFileFormat("a.abc"), "");
}

TEST(RegionSourceSettings, BeforeAnythingIsReadTheOutputIsAFewZerosInTheMiddle)
{
  const auto reads = std::make_shared<Reads>();
  const auto source = MakeSource(
    { 0, 999, 0, 999, 10, 1009 }, VTK_FLOAT, [](int, int, int) { return 5.0; }, reads);
  source->Update();
  vtkImageData* const image = source->GetOutput();
  EXPECT_EQ(image->GetNumberOfPoints(), 125) << "of a kernel of radius 2";
  EXPECT_EQ(image->GetExtent()[4], 507);
  EXPECT_EQ(image->GetScalarRange()[1], 0.0);
  EXPECT_EQ(image->GetFieldData()->GetArray("HapticWholeExtent")->GetComponent(5, 0), 1009.0);
  EXPECT_EQ(reads->Calls, 0);
}

TEST(RegionSourceSettings, ARegionCanBeReadAtAnyTime)
{
  const auto source =
    MakeSource(Long, VTK_INT, [](int i, int j, int k) { return i + 1000 * j + 1e6 * k; });
  source->SetOrigin(1.0, 2.0, 3.0);
  vtkNew<vtkImageData> image;
  const int region[6] = { -100, 2, 4, 6, 118, 400 };
  ASSERT_TRUE(source->ReadRegion(region, image));
  const Extent clipped = { -7, 2, 4, 6, 118, 119 };
  EXPECT_TRUE(std::equal(clipped.begin(), clipped.end(), image->GetExtent()));
  EXPECT_EQ(image->GetScalarComponentAsDouble(-3, 5, 119, 0), -3 + 5000 + 119e6);
  EXPECT_EQ(image->GetOrigin()[2], 3.0);
  const MessageLog log(source);
  const int outside[6] = { 700, 710, 4, 6, 118, 119 };
  EXPECT_FALSE(source->ReadRegion(outside, image));
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("no part of the volume"), std::string::npos);
}
