// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests images for ProposeFromImage(): every scalar type, any unit, components, NaN, and images
 * without a proposal.
 */

#include "ProposalRig.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <limits>

using namespace proposaltest;

namespace
{
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

constexpr int Small = 48; // number of voxels of an image along an axis

/// Returns the value 0, 40 or 100 at a voxel, blurred at the edges and rounded.
double Rounded(const Point& x)
{
  return std::round(Value({ { 20.0, 40.0, 1.5 }, { 11.0, 60.0, 1.5 } }, x, Small));
}

class ProposalInput : public testing::Test
{
protected:
  /// Expects the materials of both balls in this unit, within a fraction `tolerance` of the range.
  void ExpectBalls(double unit, double tolerance)
  {
    const std::vector<Found> found = Boundaries(this->Property);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].Low, 0.0, tolerance * 100.0 * unit);
    EXPECT_NEAR(found[0].High, 40.0 * unit, tolerance * 100.0 * unit);
    EXPECT_NEAR(found[1].Low, 40.0 * unit, tolerance * 100.0 * unit);
    EXPECT_NEAR(found[1].High, 100.0 * unit, tolerance * 100.0 * unit);
  }

  vtkNew<vtkHapticProperty> Property;
};

class ProposalTypes
  : public ProposalInput
  , public testing::WithParamInterface<int>
{
};

struct Useless
{
  const char* Name;
  std::function<vtkSmartPointer<vtkImageData>()> Make;
  std::vector<std::string> Words;
};

vtkSmartPointer<vtkImageData> MakeFlat(int x, int y, int z)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x, y, z);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* const values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  values->SetName("Density");
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, static_cast<float>(i % 2));
  }
  return image;
}

const Useless UselessImages[] = {
  { "None", [] { return nullptr; }, { "image", "vtkImageData" } },
  { "NoScalars",
    []
    {
      auto image = vtkSmartPointer<vtkImageData>::New();
      image->SetDimensions(8, 8, 8);
      return image;
    },
    { "input image", "point scalars", "SetActiveScalars" } },
  { "Empty",
    []
    {
      auto image = vtkSmartPointer<vtkImageData>::New();
      image->GetPointData()->SetScalars(vtkSmartPointer<vtkFloatArray>::New());
      return image;
    },
    { "input image", "empty" } },
  { "TwoVoxels", [] { return MakeFlat(2, 1, 1); }, { "2 x 1 x 1", "points" } },
  { "OneSlice", [] { return MakeFlat(64, 64, 1); }, { "64 x 64 x 1", "points" } },
  { "ThinSlab", [] { return MakeFlat(64, 64, 3); }, { "64 x 64 x 3", "at least 5 points" } },
  { "Constant", [] { return apitest::MakeImage(16, VTK_SHORT, [](const Point&) { return 7.0; }); },
    { "\"Density\"", "7 everywhere", "another array" } },
  { "NothingFinite",
    [] { return apitest::MakeImage(16, VTK_FLOAT, [](const Point&) { return Missing; }); },
    { "\"Density\"", "no finite value" } },
  { "PureNoise",
    []
    {
      Noise noise(20.0);
      return apitest::MakeImage(64, VTK_SHORT, [&](const Point&) { return std::round(noise()); });
    },
    { "\"Density\"", "noise", "vtkImageGaussianSmooth" } },
  { "NoEdge", [] { return apitest::MakeRamp(48); }, { "\"Density\"", "edge", "by hand" } },
  // The edge is too wide for a proposal. Rounding to float adds a little noise to the image.
  { "WideEdge",
    []
    {
      return apitest::MakeImage(64, VTK_FLOAT,
        [](const Point& x) {
          return Value({ { 16.0, 1000.0, 8.0 } }, x, 64);
        });
    },
    { "\"Density\"", "edge", "little noise", "vtkImageResample" } },
};

class ProposalRefusal
  : public ProposalInput
  , public testing::WithParamInterface<Useless>
{
};

std::string TypeName(const testing::TestParamInfo<int>& test)
{
  std::string name = vtkImageScalarTypeNameMacro(test.param);
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name;
}
} // namespace

TEST_P(ProposalTypes, AreAllTheSame)
{
  ASSERT_TRUE(
    this->Property->ProposeFromImage(apitest::MakeImage(Small, this->GetParam(), Rounded)));
  this->ExpectBalls(1.0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(ProposalInput, ProposalTypes,
  testing::Values(VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
    VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
    VTK_FLOAT, VTK_DOUBLE),
  TypeName);

TEST_P(ProposalRefusal, NamesTheInputAndChangesNothing)
{
  this->Property->ApplyPreset("MRI");
  const vtkMTimeType before = this->Property->GetMTime();
  const apitest::MessageLog log(this->Property);
  EXPECT_FALSE(this->Property->ProposeFromImage(this->GetParam().Make()));
  ASSERT_EQ(log.Errors.size(), 1U);
  for (const std::string& word : this->GetParam().Words)
  {
    EXPECT_NE(log.Errors[0].find(word), std::string::npos) << word << " in: " << log.Errors[0];
  }
  EXPECT_EQ(this->Property->GetMTime(), before);
  EXPECT_EQ(this->Property->GetProposedBoundaries(), nullptr);
}

INSTANTIATE_TEST_SUITE_P(ProposalInput, ProposalRefusal, testing::ValuesIn(UselessImages),
  [](const auto& test) { return test.param.Name; });

// Results in the unit of the values must scale with this unit.
TEST_F(ProposalInput, UnitsDoNotMatter)
{
  vtkNew<vtkHapticProperty> other;
  Noise noise(1.0);
  Noise again(1.0);
  const double unit = 1.0 / 4096.0;
  ASSERT_TRUE(this->Property->ProposeFromImage(apitest::MakeImage(
    Small, VTK_DOUBLE, [&](const Point& x) { return unit * (Rounded(x) + noise()); })));
  this->ExpectBalls(unit, 0.02);
  ASSERT_TRUE(other->ProposeFromImage(
    apitest::MakeImage(Small, VTK_DOUBLE, [&](const Point& x) { return Rounded(x) + again(); })));
  for (vtkPiecewiseFunction* (vtkHapticProperty::*get)() :
    { &vtkHapticProperty::GetSurfaceStrength, &vtkHapticProperty::GetDistinctness })
  {
    vtkPiecewiseFunction* const mine = (this->Property.Get()->*get)();
    vtkPiecewiseFunction* const theirs = (other.Get()->*get)();
    ASSERT_EQ(mine->GetSize(), theirs->GetSize());
    for (int i = 0; i < mine->GetSize(); ++i)
    {
      EXPECT_NEAR(NodeOf(mine, i)[0], unit * NodeOf(theirs, i)[0], 1e-9);
      EXPECT_NEAR(NodeOf(mine, i)[1], NodeOf(theirs, i)[1], 1e-9);
    }
  }
  EXPECT_EQ(this->Property->GetProposedKernelRadius(), other->GetProposedKernelRadius());
}

TEST_F(ProposalInput, TheComponentOfThePropertyCounts)
{
  const auto single = apitest::MakeImage(Small, VTK_FLOAT, Rounded);
  vtkNew<vtkFloatArray> pair;
  pair->SetName("Pair");
  pair->SetNumberOfComponents(2);
  pair->SetNumberOfTuples(single->GetNumberOfPoints());
  pair->FillComponent(0, 5.0);
  pair->CopyComponent(1, single->GetPointData()->GetScalars(), 0);
  single->GetPointData()->SetScalars(pair);
  this->Property->SetComponent(1);
  ASSERT_TRUE(this->Property->ProposeFromImage(single));
  this->ExpectBalls(1.0, 0.02);
  const apitest::MessageLog log(this->Property);
  this->Property->SetComponent(2);
  EXPECT_FALSE(this->Property->ProposeFromImage(single));
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("component 2"), std::string::npos);
}

TEST_F(ProposalInput, MissingSamplesAreLeftOut)
{
  const auto image = apitest::MakeImage(Small, VTK_FLOAT,
    [](const Point& x)
    {
      if (x[0] < 20.0 && x[1] < 20.0)
      {
        return Missing;
      }
      return x[2] == 40.0 && x[0] == 30.0 ? std::numeric_limits<double>::infinity() : Rounded(x);
    });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  this->ExpectBalls(1.0, 0.02);
}

TEST_F(ProposalInput, OneEnormousSampleHidesNoEdges)
{
  const auto image = apitest::MakeImage(Small, VTK_FLOAT, Rounded);
  for (const double enormous : { std::numeric_limits<double>::infinity(), 1e38, -1e38 })
  {
    SCOPED_TRACE(enormous);
    image->SetScalarComponentFromDouble(2, 3, 4, 0, enormous);
    image->Modified();
    ASSERT_TRUE(this->Property->ProposeFromImage(image));
    this->ExpectBalls(1.0, 0.02);
  }
}

// Labels and masks have edges without blur.
TEST_F(ProposalInput, StepsAreEdges)
{
  const auto image = apitest::MakeImage(Small, VTK_UNSIGNED_CHAR,
    [](const Point& x) {
      return Value({ { 16.0, 1.0, 1e-9 } }, x, Small) > 0.5 ? 1.0 : 0.0;
    });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  const std::vector<Found> found = Boundaries(this->Property);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].Low, 0.0, 0.02);
  EXPECT_NEAR(found[0].High, 1.0, 0.02);
  EXPECT_LT(found[0].Width, 0.5);
  EXPECT_EQ(this->Property->GetProposedKernelRadius(), 2);
  EXPECT_EQ(this->Property->GetSurfaceStrength()->GetValue(1.0), 12.0);
}

// Any number of threads must read the same voxels in the same order.
TEST_F(ProposalInput, RepetitionsAgreeToTheBit)
{
  Noise noise(1.0);
  const auto image =
    apitest::MakeImage(Small, VTK_FLOAT, [&](const Point& x) { return Rounded(x) + noise(); });
  vtkNew<vtkHapticProperty> other;
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  ASSERT_TRUE(other->ProposeFromImage(image));
  vtkPiecewiseFunction* const mine = this->Property->GetSurfaceStrength();
  vtkPiecewiseFunction* const theirs = other->GetSurfaceStrength();
  ASSERT_EQ(mine->GetSize(), theirs->GetSize());
  for (int i = 0; i < mine->GetSize(); ++i)
  {
    EXPECT_EQ(NodeOf(mine, i), NodeOf(theirs, i));
  }
}
