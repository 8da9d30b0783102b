// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture with nested balls with blurred edges, and the results of proposals. An edge blurred by a
 * Gaussian of scale s is V1 + (V2 - V1) Phi(x/s), where Phi is the normal distribution: the closed
 * form of Kindlmann and Durkin, "Semi-automatic generation of transfer functions for direct volume
 * rendering", 1998. This file uses none of the project's kernels.
 */
#ifndef ProposalRig_h
#define ProposalRig_h

#include "Rigs/ApiRig.h"

#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkTable.h>

#include <cmath>
#include <random>

namespace proposaltest
{
using apitest::Point;

/// A ball around the middle of the image: a step of the value with a blurred edge.
struct Ball
{
  double Radius;
  double Step;
  double Width; // scale s of the edge
};

constexpr int Size = 80; // number of voxels of an image along an axis
constexpr double Middle = 0.5 * (Size - 1);

inline double Phi(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

/// Returns the value of the balls at voxel `x` of an image with `size` voxels along each axis.
inline double Value(const std::vector<Ball>& balls, const Point& x, int size = Size)
{
  const double middle = 0.5 * (size - 1);
  const double r = std::hypot(x[0] - middle, x[1] - middle, x[2] - middle);
  double value = 0.0;
  for (const Ball& ball : balls)
  {
    value += ball.Step * Phi((ball.Radius - r) / ball.Width);
  }
  return value;
}

constexpr double Range = 250.0;        // range of the values of the three materials
constexpr double Sigma = 0.02 * Range; // standard deviation of their noise

/// Returns the balls for three materials with the values 0, 100 and 250 and edges of these
/// widths.
inline std::vector<Ball> ThreeMaterials(double outer, double inner)
{
  return { { 34.0, 100.0, outer }, { 18.0, 150.0, inner } };
}

/// Normal noise with a fixed seed.
class Noise
{
public:
  explicit Noise(double sigma)
    : Sigma(sigma)
  {
  }
  double operator()() { return this->Sigma * this->Normal(this->Random); }

private:
  double Sigma;
  std::mt19937 Random{ 7 };
  std::normal_distribution<double> Normal;
};

/// A row of the table from vtkHapticProperty::GetProposedBoundaries().
struct Found
{
  double Low;
  double High;
  double Width;
  double Slope;
  double Fraction;
};

/// Returns the proposed boundaries, sorted by their lower value.
inline std::vector<Found> Boundaries(vtkHapticProperty* property)
{
  std::vector<Found> all;
  vtkTable* const table = property->GetProposedBoundaries();
  for (vtkIdType i = 0; table && i < table->GetNumberOfRows(); ++i)
  {
    const auto get = [&](const char* name)
    { return vtkDoubleArray::SafeDownCast(table->GetColumnByName(name))->GetValue(i); };
    all.push_back({ get("Low"), get("High"), get("Width"), get("Slope"), get("Share") });
  }
  std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.Low < b.Low; });
  return all;
}

/// Returns the scalar value at the n-th point of a function, and the function's value there.
inline std::array<double, 2> NodeOf(vtkPiecewiseFunction* function, int n)
{
  double node[4] = { std::nan(""), std::nan(""), 0.0, 0.0 };
  function->GetNodeValue(n, node);
  return { node[0], node[1] };
}

/// Tests proposals for three materials with noise, and for the head phantom.
class Proposal : public testing::Test
{
protected:
  /// Expects edges of these widths s. `areas` is the ratio of the outer ball's area to the inner
  /// ball's area.
  void ExpectMaterials(double outer, double inner, double areas, double areasError)
  {
    const std::vector<Found> found = Boundaries(this->Property);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].Low, 0.0, 0.02 * Range);
    EXPECT_NEAR(found[0].High, 100.0, 0.02 * Range);
    EXPECT_NEAR(found[1].Low, 100.0, 0.02 * Range);
    EXPECT_NEAR(found[1].High, 250.0, 0.02 * Range);
    EXPECT_NEAR(found[0].Width, outer, 0.05 * outer);
    EXPECT_NEAR(found[1].Width, inner, 0.05 * inner);
    EXPECT_NEAR(found[0].Fraction / found[1].Fraction, areas, areasError);
  }

  /// Expects that the distinctness starts above the noise, and ends below the slope of every edge.
  void ExpectDistinctness(double leastStep, double width)
  {
    // The integrals of G^2 and G'^2 determine how much white noise remains after the derivative of
    // a Gaussian of scale t, which widens an edge of width s to sqrt(s^2 + t^2).
    const double t = 0.5 * this->Property->GetProposedKernelRadius();
    const double noise = Sigma / (4.0 * std::pow(vtkMath::Pi(), 0.75) * std::pow(t, 2.5));
    const double arc = leastStep / (std::sqrt(2.0 * vtkMath::Pi()) * std::hypot(width, t));
    vtkPiecewiseFunction* const distinctness = this->Property->GetDistinctness();
    ASSERT_EQ(distinctness->GetSize(), 2);
    const auto start = NodeOf(distinctness, 0);
    const auto full = NodeOf(distinctness, 1);
    EXPECT_EQ(start[1], 0.0);
    EXPECT_EQ(full[1], 1.0);
    EXPECT_GE(start[0], 0.95 * std::max(3.4 * noise, 0.2 * arc));
    EXPECT_LT(start[0], full[0]);
    EXPECT_LE(full[0], 0.55 * arc);
    EXPECT_GE(full[0], 0.4 * arc);
  }

  /// Expects the tissues of the head phantom, whose numbers are in Data/phantom.py.
  void ExpectTissues()
  {
    vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
    EXPECT_EQ(strength->GetValue(-1000.0), 0.0); // air
    EXPECT_GT(strength->GetValue(40.0), 0.5);    // scalp, brain
    EXPECT_LT(strength->GetValue(40.0), 3.5);
    EXPECT_EQ(strength->GetValue(1200.0), 12.0); // skull
    EXPECT_EQ(this->Property->GetSurfaceSide(), vtkHapticProperty::HIGHER);
  }

  vtkNew<vtkHapticProperty> Property;
};
} // namespace proposaltest

#endif
