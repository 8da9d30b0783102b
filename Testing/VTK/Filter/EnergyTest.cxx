// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the energy that the hand gains in a closed cycle. A proxy gives none, while a force field
 * can give energy (the paper's objection).
 */

#include "Rigs/ApiRig.h"

#include <cmath>

using namespace apitest;

namespace
{
class EnergyTest : public ApiTest
{
protected:
  /// Returns the accumulated energy (J) at the end of a path.
  double Spent(const std::vector<Point>& points)
  {
    const vtkSmartPointer<vtkPolyData> path = MakePath(points);
    this->Filter->SetPathData(path);
    const vtkIdType last = path->GetNumberOfPoints() - 1;
    return Get(this->Run(last + 1), "Energy", last);
  }
};

/// Makes a path of five turns on a circle with a radius of 3 mm, back to the start.
std::vector<Point> Turns(double direction)
{
  std::vector<Point> points;
  for (int i = 0; i <= 1000; ++i)
  {
    const double angle = direction * 2.0 * 3.14159265358979323846 * i / 200;
    points.push_back({ 7.5 + 3.0 * std::cos(angle), 7.5 + 3.0 * std::sin(angle), 7.5 });
  }
  return points;
}
} // namespace

TEST_F(EnergyTest, ASpringStoresWhatTheHandPutsIn)
{
  // A press of 3 mm at 500 N/m requires 1.5 N, which the surface can resist because its strength
  // T_N is 2 N.
  EXPECT_NEAR(this->Spent(Line({ 7, 7, 5 }, { 7, 7, 8 }, 30)), -0.5 * 500.0 * 0.003 * 0.003, 1e-9);
  std::vector<Point> cycle = Line({ 7, 7, 5 }, { 7, 7, 8 }, 30);
  const std::vector<Point> back = Line({ 7, 7, 8 }, { 7, 7, 5 }, 30);
  cycle.insert(cycle.end(), back.begin(), back.end());
  EXPECT_NEAR(this->Spent(cycle), 0.0, 1e-12);
}

TEST_F(EnergyTest, FrictionSpends)
{
  SetConstant(this->Property->GetFriction(), 0.5);
  std::vector<Point> cycle = Line({ 7, 7, 5 }, { 7, 7, 7 }, 20);
  for (const Point& corner : { Point{ 11, 7, 7 }, Point{ 7, 7, 7 }, Point{ 7, 7, 4 } })
  {
    const std::vector<Point> next = Line(cycle.back(), corner, 40);
    cycle.insert(cycle.end(), next.begin(), next.end());
  }
  EXPECT_LT(this->Spent(cycle), -1e-3);
}

TEST_F(EnergyTest, AForceFieldWhoseGradientIsNoneOfAFunctionCreatesAsMuchAsItSpends)
{
  // With coarse central differences, the forces along this ridge have a curl: turns in one
  // direction gain the energy that turns in the other direction lose.
  this->Filter->SetInputData(0,
    MakeImage(16, VTK_DOUBLE,
      [](const Point& x) { return 1000.0 * std::sin(1.9 * x[0]) * std::cos(1.3 * x[1] + x[0]); }));
  this->Filter->SetMethodToForceField();
  this->Filter->SetGradientEstimatorToCentralDifference();
  const double there = this->Spent(Turns(1.0));
  const double back = this->Spent(Turns(-1.0));
  EXPECT_GT(std::abs(there), 1e-6);
  EXPECT_NEAR(there, -back, 0.01 * std::abs(there)) << "but for the first tick";
  EXPECT_GT(std::max(there, back), 0.0) << "created out of nothing";
}
