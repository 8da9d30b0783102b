// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the functions that ProposeFromImage() proposes. The volumes have edges that are known in
 * closed form; Data/phantom.py defines the tissues of the head phantom.
 */

#include "ProposalRig.h"

#include <vtkMatrix3x3.h>
#include <vtkXMLImageDataReader.h>

using namespace proposaltest;

namespace
{
constexpr double Areas = (34.0 * 34.0) / (18.0 * 18.0); // ratio of the balls' areas

struct Widths
{
  double Outer;
  double Inner;
};

class Edges
  : public Proposal
  , public testing::WithParamInterface<Widths>
{
};
} // namespace

TEST_P(Edges, ValuesAndWidthsAreFoundInNoise)
{
  const Widths& s = this->GetParam();
  Noise noise(Sigma);
  const auto image = apitest::MakeImage(Size, VTK_FLOAT,
    [&](const Point& x) { return Value(ThreeMaterials(s.Outer, s.Inner), x) + noise(); });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  this->ExpectMaterials(s.Outer, s.Inner, Areas, 0.6);
  this->ExpectDistinctness(100.0, s.Outer);
  EXPECT_GE(this->Property->GetProposedKernelRadius(), 2.0 * 0.95 * std::max(s.Outer, s.Inner));
  EXPECT_LE(this->Property->GetProposedKernelRadius(), 5);
}

TEST_P(Edges, AMultiplicativeBiasDoesLittle)
{
  const Widths& s = this->GetParam();
  Noise noise(Sigma);
  const auto image = apitest::MakeImage(Size, VTK_FLOAT,
    [&](const Point& x)
    {
      const double bias = 1.0 + 0.3 * (x[0] - Middle) / Middle;
      return bias * Value(ThreeMaterials(s.Outer, s.Inner), x) + noise();
    });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  this->ExpectMaterials(s.Outer, s.Inner, Areas, 0.6);
  this->ExpectDistinctness(85.0, s.Outer);
}

INSTANTIATE_TEST_SUITE_P(Proposal, Edges,
  testing::Values(Widths{ 1.0, 1.0 }, Widths{ 2.0, 1.0 }, Widths{ 1.0, 2.0 }, Widths{ 1.5, 1.5 }),
  [](const auto& test)
  {
    return "Outer" + std::to_string(std::lround(10 * test.param.Outer)) + "Inner" +
      std::to_string(std::lround(10 * test.param.Inner));
  });

TEST_F(Proposal, StrengthsAreInProportionAndTheInnermostIsTheStrongest)
{
  const auto image = apitest::MakeImage(
    Size, VTK_FLOAT, [](const Point& x) { return Value(ThreeMaterials(1.5, 1.5), x); });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  EXPECT_EQ(this->Property->GetSurfaceSide(), vtkHapticProperty::HIGHER);
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  EXPECT_EQ(strength->GetValue(0.0), 0.0);
  EXPECT_NEAR(strength->GetValue(100.0), 3.0 * 100.0 / 150.0, 0.02);
  EXPECT_EQ(strength->GetValue(250.0), 12.0);
  vtkPiecewiseFunction* const stiffness = this->Property->GetStiffness();
  for (const double value : { -1000.0, 0.0, 60.0, 100.0, 200.0, 250.0, 1000.0 })
  {
    EXPECT_DOUBLE_EQ(stiffness->GetValue(value), 500.0);
  }
  for (vtkPiecewiseFunction* function :
    { this->Property->GetFriction(), this->Property->GetViscosity() })
  {
    EXPECT_EQ(function->GetValue(0.0), 0.0);
    EXPECT_LT(1.1 * function->GetValue(100.0), function->GetValue(250.0));
    EXPECT_LE(function->GetValue(250.0), 0.5);
  }
}

// Steep functions make the force rough. So a step between two materials must extend over at least
// half of the interval between their values, and the function must be constant around each value.
TEST_F(Proposal, MaterialsAreConstantAndBlendsAreWide)
{
  const auto image = apitest::MakeImage(
    Size, VTK_FLOAT, [](const Point& x) { return Value(ThreeMaterials(1.5, 1.5), x); });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  EXPECT_EQ(strength->GetValue(-10.0), strength->GetValue(10.0));
  EXPECT_EQ(strength->GetValue(90.0), strength->GetValue(120.0));
  EXPECT_EQ(strength->GetValue(230.0), strength->GetValue(300.0));
  for (double value = 0.0; value < Range; value += 1.0)
  {
    const double change = std::abs(strength->GetValue(value + 1.0) - strength->GetValue(value));
    EXPECT_LE(change, value < 100.0 ? 2.05 / 50.0 : 10.1 / 75.0) << value;
  }
}

// Touched from outside, the balls must have their surfaces at the true positions, with the
// strengths of the functions.
TEST_F(Proposal, SurfacesAreFelt)
{
  Noise noise(Sigma);
  const auto image = apitest::MakeImage(
    Size, VTK_FLOAT, [&](const Point& x) { return Value(ThreeMaterials(1.0, 1.0), x) + noise(); });
  vtkNew<vtkVolumeHapticsFilter> filter;
  ASSERT_TRUE(filter->GetProperty()->ProposeFromImage(image));
  filter->SetKernelRadius(filter->GetProperty()->GetProposedKernelRadius());
  filter->SetInputData(0, image);
  filter->SetPathData(apitest::MakePath(
    apitest::Line({ Middle, Middle, 1.0 }, { Middle, Middle, Middle - 8.0 }, 4000)));
  filter->Update();
  vtkPolyData* const trace = filter->GetOutput();
  double before = 0.0; // force at the outer ball
  double after = 0.0;  // force at the inner ball: the tip ends 10 mm inside, where 500 N/m give 5 N
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    const double force = -apitest::Get(trace, "Force", i, 2);
    const double z = 1.0 + i * (Middle - 9.0) / 4000.0;
    before = z < Middle - 26.0 ? std::max(before, force) : before;
    after = std::max(after, force);
  }
  EXPECT_NEAR(before, 2.0, 0.3);
  EXPECT_GT(after, 4.5);
  EXPECT_NEAR(trace->GetPoint(trace->GetNumberOfPoints() - 1)[2], Middle - 18.0, 3.0);
}

TEST_F(Proposal, DarkInsideIsFeltTowardsLowerValues)
{
  const auto image = apitest::MakeImage(Size, VTK_SHORT,
    [](const Point& x) { return 1000.0 - 4.0 * Value(ThreeMaterials(1.5, 1.5), x); });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  EXPECT_EQ(this->Property->GetSurfaceSide(), vtkHapticProperty::LOWER);
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  EXPECT_EQ(strength->GetValue(1000.0), 0.0);
  EXPECT_NEAR(strength->GetValue(600.0), 2.0, 0.02);
  EXPECT_EQ(strength->GetValue(0.0), 12.0);
}

// In a hollow ball, the hand meets the inner surface towards lower values.
TEST_F(Proposal, DarkInsideBrightIsFeltFromBothSides)
{
  const auto image = apitest::MakeImage(Size, VTK_FLOAT,
    [](const Point& x) {
      return Value({ { 34.0, 250.0, 1.5 }, { 20.0, -130.0, 1.5 } }, x);
    });
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  EXPECT_EQ(this->Property->GetSurfaceSide(), vtkHapticProperty::BOTH);
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  EXPECT_EQ(strength->GetValue(0.0), 0.0);
  EXPECT_NEAR(strength->GetValue(250.0), 3.0, 1e-9);
  EXPECT_NEAR(strength->GetValue(120.0), 3.0 * 130.0 / 250.0, 0.02);
}

// Widths and slopes must be in world units, even in a volume that is rotated and stretched.
TEST_F(Proposal, WidthsAreInWorldUnits)
{
  const double spacing[3] = { 0.6, 0.8, 1.1 };
  const double c = std::cos(0.5), s = std::sin(0.5);
  const double rows[9] = { c, -s, 0, s, c, 0, 0, 0, 1 };
  const double width = 1.5;
  const auto image = apitest::MakeImage(Size, VTK_FLOAT,
    [&](const Point& x)
    {
      const double r = std::hypot(
        spacing[0] * (x[0] - Middle), spacing[1] * (x[1] - Middle), spacing[2] * (x[2] - Middle));
      return 100.0 * Phi((18.0 - r) / width);
    });
  image->SetSpacing(spacing);
  image->SetDirectionMatrix(rows);
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  const std::vector<Found> found = Boundaries(this->Property);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].Width, width, 0.05 * width);
  // The kernel radius must be about twice the width of the edge, because V(x_s) is read at this
  // distance.
  EXPECT_GE(1.1 * this->Property->GetProposedKernelRadius(), 2.0 * 0.95 * width);
}

TEST_F(Proposal, TheRadiusCountsVoxelsAcrossTheEdge)
{
  // A tube along thick slices must have the same edge as a tube in cubic voxels.
  constexpr double width = 0.9;
  int radius[2];
  for (int thick = 0; thick < 2; ++thick)
  {
    const auto image = apitest::MakeImage(Size, VTK_FLOAT,
      [&](const Point& x)
      {
        const double r = 0.5 * std::hypot(x[0] - Middle, x[1] - Middle);
        return 100.0 * Phi((10.0 - r) / width);
      });
    image->SetSpacing(0.5, 0.5, thick == 0 ? 0.5 : 5.0);
    ASSERT_TRUE(this->Property->ProposeFromImage(image));
    radius[thick] = this->Property->GetProposedKernelRadius();
  }
  EXPECT_EQ(radius[0], static_cast<int>(std::ceil(2.0 * width / 0.5)));
  EXPECT_EQ(radius[1], radius[0]);
}

TEST_F(Proposal, TheHeadPhantomsTissuesAreFound)
{
  vtkNew<vtkXMLImageDataReader> head;
  head->SetFileName(HEAD_PHANTOM);
  head->Update();
  ASSERT_TRUE(this->Property->ProposeFromImage(head->GetOutput()));
  this->ExpectTissues();
}

TEST_F(Proposal, CopiesKeepTheProposal)
{
  const auto image = apitest::MakeImage(
    Size, VTK_FLOAT, [](const Point& x) { return Value(ThreeMaterials(1.5, 1.5), x); });
  EXPECT_EQ(this->Property->GetProposedBoundaries(), nullptr);
  EXPECT_EQ(this->Property->GetProposedKernelRadius(), 0);
  ASSERT_TRUE(this->Property->ProposeFromImage(image));
  vtkNew<vtkHapticProperty> copy;
  copy->DeepCopy(this->Property);
  EXPECT_EQ(Boundaries(copy).size(), 2U);
  EXPECT_EQ(copy->GetProposedKernelRadius(), this->Property->GetProposedKernelRadius());
  EXPECT_EQ(copy->GetSurfaceStrength()->GetValue(250.0), 12.0);
}
