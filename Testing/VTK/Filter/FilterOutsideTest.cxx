// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that a ball with unmeasured surroundings has bitwise the same forces as the same ball in
 * air: as an image, as regions that a filter cuts out or a source reads, and as time steps. The
 * force on a local surface of this ball is its stiffness times the depth.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/TimeSource.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkHapticRegionFilter.h>
#include <vtkHapticRegionSource.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>

using namespace apitest;

namespace
{
constexpr int Size = 40;
constexpr double Air = -1000.0;
constexpr double Tissue = 60.0;
constexpr double Radius = 10.0;
// samples are valid up to this distance (mm), less than a kernel's reach beyond the surface
constexpr double Measured = 12.5;
const Point Centre{ 19.5, 19.5, 19.5 };
const double NaN = std::nan("");
constexpr double Infinity = std::numeric_limits<double>::infinity();

double DistanceOf(const Point& p)
{
  return std::hypot(p[0] - Centre[0], p[1] - Centre[1], p[2] - Centre[2]);
}

/// Returns the value of the ball at `p`, increased by `shift`. The edge is two voxels wide.
double BallAt(const Point& p, double shift = 0.0)
{
  const double share = std::clamp(0.5 * (Radius + 1.0 - DistanceOf(p)), 0.0, 1.0);
  return Air + share * (Tissue - Air) + shift;
}

struct Case
{
  const char* Name;
  int Type;
  double Bad;
  double Shift = 0.0;
  const char* Told = "is taken for \"missing\"";
};
void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.Name;
}

/// Makes the ball. Beyond the distance `measured` (mm), samples are invalid if `isMasked`, and air
/// otherwise.
vtkSmartPointer<vtkImageData> MakeBall(const Case& c, bool isMasked, double measured = Measured)
{
  return MakeImage(Size, c.Type,
    [&](const Point& p)
    { return isMasked && DistanceOf(p) > measured ? c.Bad : BallAt(p, c.Shift); });
}

/// Makes a path from outside the ball to 2.5 mm below its surface, and then along the surface.
vtkSmartPointer<vtkPolyData> MakePress()
{
  std::vector<Point> path = Line({ 20, 19, 36 }, { 20, 19, 27 }, 90);
  const std::vector<Point> along = Line({ 20, 19, 27 }, { 24, 19, 26 }, 60);
  path.insert(path.end(), along.begin(), along.end());
  return MakePath(path);
}

class FilterOutside
  : public ApiTest
  , public testing::WithParamInterface<Case>
{
protected:
  FilterOutside()
  {
    this->Filter->SetPathData(MakePress());
    SetConstant(this->Property->GetStiffness(), 500.0);
    SetConstant(this->Property->GetFriction(), 0.2);
    this->Property->GetSurfaceStrength()->RemoveAllPoints();
    this->Property->GetSurfaceStrength()->AddPoint(Air, 0.0);
    this->Property->GetSurfaceStrength()->AddPoint(Tissue, 5.0);
  }
  vtkSmartPointer<vtkPolyData> Feel(vtkImageData* image)
  {
    this->Filter->SetInputData(image);
    this->Filter->Update();
    return Keep(this->Filter);
  }
  static double MostForce(vtkPolyData* trace)
  {
    return trace->GetPointData()->GetArray("Force")->GetMaxNorm();
  }
};
} // namespace

TEST_P(FilterOutside, IsFeltAsAir)
{
  const auto masked = MakeBall(this->GetParam(), true);
  const auto air = MakeBall(this->GetParam(), false);
  for (const char* method : { "proxy", "paper", "local-surface", "surface-proxy" })
  {
    ASSERT_TRUE(this->Filter->SetMethodByName(method));
    this->Filter->SetIsoValue(0.5 * (Air + Tissue) + this->GetParam().Shift);
    const auto expected = this->Feel(air);
    const auto felt = this->Feel(masked);
    EXPECT_GT(MostForce(expected), 0.5) << method;
    EXPECT_TRUE(IsSame(felt, expected)) << method;
  }
  ASSERT_EQ(this->Log.Warnings.size(), 1U) << "once for an array, not for each bake";
  EXPECT_NE(this->Log.Warnings[0].find(this->GetParam().Told), std::string::npos)
    << this->Log.Warnings[0];
  std::ostringstream value;
  value << "felt as " << Air + this->GetParam().Shift << ".";
  EXPECT_NE(this->Log.Warnings[0].find(value.str()), std::string::npos) << this->Log.Warnings[0];
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_P(FilterOutside, IsTheForceOfTheBall)
{
  ASSERT_TRUE(this->Filter->SetMethodByName("local-surface"));
  this->Filter->SetIsoValue(0.5 * (Air + Tissue) + this->GetParam().Shift);
  SetConstant(this->Property->GetFriction(), 0.0);
  const auto felt = this->Feel(MakeBall(this->GetParam(), true));
  const auto press = MakePress();
  for (vtkIdType tick = 30; tick < 90; ++tick)
  {
    Point tip;
    press->GetPoint(tick, tip.data());
    const double depth = std::max(0.0, Radius - DistanceOf(tip));
    // With a radius of 10 voxels, the ball's trilinear surface is off by about 0.1 voxel.
    EXPECT_NEAR(Get(felt, "NormalForce", tick), 0.5 * depth, 0.06) << tick;
  }
}

TEST_P(FilterOutside, OfARegionIsThatOfTheWhole)
{
  vtkSmartPointer<vtkPolyData> regions[2];
  for (const bool isMasked : { false, true })
  {
    vtkNew<vtkHapticRegionFilter> crop;
    crop->SetInputData(MakeBall(this->GetParam(), isMasked));
    crop->SetRegion(3, 36, 3, 36, 5, 39);
    this->Filter->SetInputConnection(crop->GetOutputPort());
    this->Filter->Update();
    regions[isMasked ? 1 : 0] = Keep(this->Filter);
    EXPECT_EQ(this->Log.Warnings.size(), isMasked ? 1U : 0U);
  }
  this->Log.Warnings.clear();
  EXPECT_GT(MostForce(regions[0]), 0.3);
  EXPECT_TRUE(IsSame(regions[1], regions[0]));
  const auto expected = this->Feel(MakeBall(this->GetParam(), false));

  vtkNew<vtkHapticRegionSource> source;
  MessageLog sourceLog{ source };
  source->SetWholeExtent(0, Size - 1, 0, Size - 1, 0, Size - 1);
  source->SetScalarType(this->GetParam().Type);
  source->SetReader(
    [image = MakeBall(this->GetParam(), true)](const int box[6], void* samples)
    {
      auto* to = static_cast<char*>(samples);
      for (int k = box[4]; k <= box[5]; ++k)
      {
        for (int j = box[2]; j <= box[3]; ++j)
        {
          const std::size_t size =
            static_cast<std::size_t>(image->GetScalarSize()) * (box[1] - box[0] + 1);
          std::memcpy(to, image->GetScalarPointer(box[0], j, k), size);
          to += size;
        }
      }
      return true;
    });
  this->Filter->SetInputConnection(source->GetOutputPort());
  this->Filter->Update();
  EXPECT_TRUE(IsSame(Keep(this->Filter), expected));
  EXPECT_EQ(this->Log.Warnings.size(), 1U) << "of a path, the filter";
  EXPECT_TRUE(sourceLog.Warnings.empty());
  // A region that an application reads has the file's samples, and must have the same forces as a
  // region in the pipeline.
  vtkNew<vtkImageData> read;
  const int part[6] = { 3, 36, 3, 36, 5, 39 };
  ASSERT_TRUE(source->ReadRegion(part, read));
  const double corner = read->GetScalarComponentAsDouble(3, 3, 39, 0);
  const double bad = this->GetParam().Bad;
  EXPECT_TRUE(
    std::isnan(bad) ? std::isnan(corner) : corner == bad || corner == static_cast<float>(bad))
    << corner;
  EXPECT_TRUE(IsSame(this->Feel(read), regions[0]));
  // The coarse image, which replaces late samples, must not contain invalid values.
  ASSERT_TRUE(source->MakeCoarseImage(1000));
  double range[2];
  source->GetCoarseImage()->GetPointData()->GetScalars()->GetRange(range);
  EXPECT_EQ(range[0], Air + this->GetParam().Shift);
  EXPECT_LE(range[1], Tissue + this->GetParam().Shift);
}

TEST_P(FilterOutside, ProposesFunctionsOfTheBall)
{
  vtkNew<vtkHapticProperty> ofAir;
  vtkNew<vtkHapticProperty> ofMasked;
  ASSERT_TRUE(ofAir->ProposeFromImage(MakeBall(this->GetParam(), false)));
  // Invalid samples are left out, so valid samples must cover the whole edge of the ball.
  const double measured = Measured + 4.0;
  ASSERT_TRUE(ofMasked->ProposeFromImage(MakeBall(this->GetParam(), true, measured)));
  ASSERT_EQ(ofMasked->GetSurfaceStrength()->GetSize(), ofAir->GetSurfaceStrength()->GetSize());
  for (int i = 0; i < ofAir->GetSurfaceStrength()->GetSize(); ++i)
  {
    double expected[4];
    double found[4];
    ofAir->GetSurfaceStrength()->GetNodeValue(i, expected);
    ofMasked->GetSurfaceStrength()->GetNodeValue(i, found);
    EXPECT_NEAR(found[0], expected[0], 5.0); // tolerance in a range of 1060 HU
    EXPECT_NEAR(found[1], expected[1], 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Values, FilterOutside,
  testing::Values(Case{ "NaN", VTK_FLOAT, NaN, 0.0, "samples that are no numbers" },
    Case{ "NegativeInfinity", VTK_DOUBLE, -Infinity, 0.0, "samples that are no numbers" },
    Case{ "Minus9999", VTK_FLOAT, -9999.0 }, Case{ "Minus9999Short", VTK_SHORT, -9999.0 },
    Case{ "Minus99999", VTK_INT, -99999.0 }, Case{ "LeastShort", VTK_SHORT, -32768.0 },
    Case{ "LeastInt", VTK_INT, -2147483648.0 }, Case{ "Float1e37", VTK_FLOAT, 1e37 },
    Case{ "Double1e20", VTK_DOUBLE, 1e20 }, Case{ "NetCDF", VTK_FLOAT, 9.969209968386869e36 },
    Case{ "LargestDouble", VTK_DOUBLE, std::numeric_limits<double>::max() },
    Case{ "LeastFloat", VTK_FLOAT, -static_cast<double>(std::numeric_limits<float>::max()) },
    Case{ "CTWithoutSign", VTK_UNSIGNED_SHORT, 63536.0, 1024.0 }),
  [](const auto& info) { return info.param.Name; });

namespace
{
class FilterMeasured : public FilterOutside
{
};
} // namespace

// Values that scanners write, or that may have been measured, must be used unchanged.
TEST_P(FilterMeasured, IsFeltAsItIs)
{
  const auto image = MakeBall(this->GetParam(), true);
  const auto felt = this->Feel(image);
  EXPECT_TRUE(this->Log.Warnings.empty());
  // The tip starts outside the measured part.
  EXPECT_EQ(Get(felt, "Value", 0), image->GetScalarComponentAsDouble(0, 0, 0, 0));
}
INSTANTIATE_TEST_SUITE_P(Values, FilterMeasured,
  testing::Values(Case{ "Air", VTK_SHORT, -1024.0 }, Case{ "PaddingOfGE", VTK_SHORT, -2000.0 },
    Case{ "PaddingOfRescaledCT", VTK_SHORT, -3024.0 },
    Case{ "Zero", VTK_UNSIGNED_SHORT, 0.0, 1024.0 },
    Case{ "LargestShort", VTK_UNSIGNED_SHORT, 65535.0, 1024.0 }),
  [](const auto& info) { return info.param.Name; });

// The values of this potential extend down to -9999 without a gap of a tenth of the range, so -9999
// must count as measured.
TEST_F(FilterMeasured, ANumberThatOthersComeCloseToIsOne)
{
  const auto image = MakeImage(
    Size, VTK_FLOAT, [](const Point& p) { return -9999.0 + 10.0 * (p[0] + p[1] + p[2]); });
  const auto felt = this->Feel(image);
  EXPECT_TRUE(this->Log.Warnings.empty());
  EXPECT_NEAR(Get(felt, "Value", 0), -9999.0 + 10.0 * 75.0, 1e-3);
}

// A masked map that was resampled onto a larger grid has zeros around its NaN, so its corners do
// not indicate missing samples.
TEST_F(FilterMeasured, ManyHolesAreTold)
{
  const auto image = MakeBall({ "", VTK_FLOAT, NaN }, true);
  for (int corner = 0; corner < 8; ++corner)
  {
    const int last = Size - 1;
    image->SetScalarComponentFromDouble(
      corner & 1 ? last : 0, corner & 2 ? last : 0, corner & 4 ? last : 0, 0, 0.0);
  }
  this->Feel(image);
  this->Feel(image);
  vtkNew<vtkHapticRegionFilter> crop;
  crop->SetInputData(image);
  crop->SetRegion(3, 36, 3, 36, 5, 39);
  this->Filter->SetInputConnection(crop->GetOutputPort());
  this->Filter->Update();
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  // 87.2 % of the 64000 samples are beyond a radius of 12.5: 1 - 4/3 pi 12.5^3 / 40^3.
  EXPECT_NE(
    this->Log.Warnings[0].find("no numbers (87 %), and none in a corner"), std::string::npos)
    << this->Log.Warnings[0];
}

// A single invalid voxel in the middle is a hole in the data rather than the outside.
TEST_F(FilterMeasured, OneBadVoxelIsNoOutside)
{
  for (const double bad : { NaN, Infinity })
  {
    const auto image = MakeBall({ "", VTK_FLOAT, Air }, false);
    const auto expected = this->Feel(image);
    // No kernel on the path reaches the voxel at (6, 6, 6).
    image->SetScalarComponentFromDouble(6, 6, 6, 0, bad);
    image->Modified();
    EXPECT_TRUE(IsSame(this->Feel(image), expected)) << bad;
    EXPECT_TRUE(this->Log.Warnings.empty());
  }
}

// A number that programs write for missing values, and that is far from all other values, must
// count as missing, even inside the volume. Otherwise, a range up to 1e38 would hide all edges.
TEST_F(FilterMeasured, OneEnormousVoxelIsOutside)
{
  for (const double bad : { 1e38, -1e37, 1e20 })
  {
    const auto image = MakeBall({ "", VTK_FLOAT, Air }, false);
    const auto expected = this->Feel(image);
    image->SetScalarComponentFromDouble(6, 6, 6, 0, bad);
    image->Modified();
    EXPECT_TRUE(IsSame(this->Feel(image), expected)) << bad;
    ASSERT_EQ(this->Log.Warnings.size(), 1U) << bad;
    EXPECT_NE(this->Log.Warnings[0].find("is taken for \"missing\": all such samples are outside"),
      std::string::npos)
      << this->Log.Warnings[0];
    this->Log.Warnings.clear();
  }
}

TEST_F(FilterMeasured, OneVoxelDoesNotHideHounsfieldUnits)
{
  std::mt19937 random(51);
  std::normal_distribution<double> noise(0.0, 15.0);
  for (const double shift : { 0.0, 1000.0, 1024.0, 32768.0 })
  {
    // Programs add the shift so that no value is negative.
    const double least = shift > 0.0 ? 0.0 : -2000.0;
    const auto image = MakeImage(Size, VTK_FLOAT,
      [&](const Point& p) { return std::max(least, BallAt(p, shift) + noise(random)); });
    for (const double bad : { NaN, Infinity, -Infinity, 1e38, -1e38 })
    {
      SCOPED_TRACE(bad);
      image->SetScalarComponentFromDouble(6, 6, 6, 0, bad);
      image->Modified();
      ASSERT_TRUE(this->Property->ApplyPreset("CT contrast"));
      this->Log.Warnings.clear();
      EXPECT_GT(MostForce(this->Feel(image)), 0.5);
      EXPECT_EQ(this->Property->GetFoundShift(), -shift);
      for (const std::string& warning : this->Log.Warnings)
      {
        EXPECT_EQ(warning.find("can't be a CT"), std::string::npos) << warning;
      }
      // A region of the volume must have the same shift.
      vtkNew<vtkHapticRegionFilter> crop;
      crop->SetInputData(image);
      crop->SetRegion(3, 36, 3, 36, 5, 39);
      this->Filter->SetInputConnection(crop->GetOutputPort());
      this->Filter->Update();
      EXPECT_EQ(this->Property->GetFoundShift(), -shift) << "of a region";
    }
  }
}

TEST_F(FilterMeasured, VectorsAndLabelsAreReadAsTheyAre)
{
  const auto image = MakeBall({ "", VTK_FLOAT, -9999.0 }, true);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Field");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(image->GetNumberOfPoints());
  for (int c = 0; c < 3; ++c)
  {
    vectors->CopyComponent(c, image->GetPointData()->GetScalars(), 0);
  }
  vtkNew<vtkImageData> field;
  field->CopyStructure(image);
  field->GetPointData()->SetScalars(vectors);
  EXPECT_EQ(Get(this->Feel(field), "Value", 0), -9999.0);
  EXPECT_TRUE(this->Log.Warnings.empty());

  this->Property->ScalarsAreLabelsOn();
  const auto labels = MakeImage(
    Size, VTK_SHORT, [](const Point& p) { return DistanceOf(p) > Measured ? -32768.0 : 1.0; });
  EXPECT_EQ(Get(this->Feel(labels), "Value", 0), -32768.0);
  vtkNew<vtkHapticRegionFilter> crop;
  MessageLog cropLog{ crop };
  crop->SetInputData(labels);
  crop->SetRegion(3, 36, 3, 36, 5, 39);
  this->Filter->SetInputConnection(crop->GetOutputPort());
  this->Filter->Update();
  EXPECT_EQ(Get(Keep(this->Filter), "Value", 0), -32768.0);
  EXPECT_TRUE(this->Log.Warnings.empty());
  EXPECT_TRUE(cropLog.Warnings.empty());
}

// Invalid samples must be filled in the same way in time steps of a source and in components of an
// array. Samples outside have a constant value.
TEST_F(FilterMeasured, TimeStepsAreFilledAlike)
{
  const auto wallAt = [](const Point& p, double wall, bool isMasked)
  {
    const bool isOutside = std::hypot(p[1] - 19.5, p[2] - 19.5) > 8.0;
    return !isOutside ? std::clamp(500.0 * (wall + 1.0 - p[0]), 0.0, 1000.0) : isMasked ? NaN : 0.0;
  };
  this->Filter->SetMaterialPlacementToKernel();
  SetConstant(this->Property->GetStiffness(), 500.0);
  SetConstant(this->Property->GetFriction(), 0.0);
  this->Property->GetSurfaceStrength()->RemoveAllPoints();
  this->Property->GetSurfaceStrength()->AddPoint(0.0, 3.0);
  // close enough to the border that kernels reach unmeasured samples
  const Point rest{ 15.0, 19.5, 13.0 };
  this->Filter->SetPathData(MakePath({ rest, rest }, { 0.0, 1.0 }));
  this->Filter->SetTimeUnitsPerSecond(4.0);
  vtkSmartPointer<vtkPolyData> traces[2];
  for (const bool isMasked : { false, true })
  {
    vtkNew<TimeSource> source;
    source->Steps = { 0.0, 1.0, 2.0, 3.0, 4.0 };
    source->Make = [=](double time)
    {
      return MakeImage(
        Size, VTK_FLOAT, [=](const Point& p) { return wallAt(p, 13.0 + time, isMasked); });
    };
    this->Filter->SetInputConnection(source->GetOutputPort());
    this->Filter->Update();
    traces[isMasked ? 1 : 0] = Keep(this->Filter);
  }
  EXPECT_GT(MostForce(traces[0]), 0.5) << "the wall has come to 17";
  EXPECT_TRUE(IsSame(traces[1], traces[0]));

  vtkNew<vtkImageData> frames;
  frames->SetDimensions(Size, Size, Size);
  frames->AllocateScalars(VTK_FLOAT, 5);
  for (vtkIdType i = 0; i < frames->GetNumberOfPoints(); ++i)
  {
    Point p;
    frames->GetPoint(i, p.data());
    for (int c = 0; c < 5; ++c)
    {
      frames->GetPointData()->GetScalars()->SetComponent(i, c, wallAt(p, 13.0 + c, true));
    }
  }
  this->Filter->SetInputData(frames);
  this->Filter->SetFramesToComponents();
  this->Filter->Update();
  EXPECT_TRUE(IsSame(Keep(this->Filter), traces[1]));
  EXPECT_EQ(this->Log.Errors.size(), 0U);
}
