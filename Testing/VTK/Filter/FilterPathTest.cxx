// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the ticks of a path: one tick per point, or points with times that are resampled to the
 * servo's rate.
 */

#include "Rigs/ApiRig.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

using namespace apitest;

namespace
{
class FilterPath : public ApiTest
{
protected:
  vtkPolyData* RunOn(vtkPolyData* path, vtkIdType ticks)
  {
    this->Filter->SetPathData(path);
    return this->Run(ticks);
  }
  double TipZ(vtkIdType tick) { return Get(this->Filter->GetOutput(), "Tip", tick, 2); }
  double TimeOf(vtkIdType tick) { return Get(this->Filter->GetOutput(), "Time", tick); }
};
} // namespace

TEST_F(FilterPath, NoneIsAnEmptyOutputAndNoError)
{
  this->Filter->SetPathData(nullptr);
  vtkPolyData* const output = this->Run(0);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  this->RunOn(MakePath({}), 0);
  vtkNew<vtkPolyData> bare;
  this->RunOn(bare, 0);
}

TEST_F(FilterPath, OnePointIsOneTickWithoutForce)
{
  vtkPolyData* const output = this->RunOn(MakePath({ { 7, 7, 7 } }), 1);
  EXPECT_EQ(Get(output, "Force", 0, 2), 0.0);
  EXPECT_EQ(output->GetPoint(0)[2], 7.0);
  EXPECT_EQ(Get(output, "Time", 0), 0.0);
  this->RunOn(MakePath({ { 7, 7, 7 } }, { 3.5 }), 1);
  EXPECT_EQ(this->TimeOf(0), 3.5);
}

TEST_F(FilterPath, TicksAreNumberedByThePeriod)
{
  this->Filter->SetServoRate(500.0);
  vtkPolyData* const output = this->Run(51);
  for (vtkIdType tick = 0; tick < 51; ++tick)
  {
    EXPECT_DOUBLE_EQ(this->TimeOf(tick), 0.002 * static_cast<double>(tick));
  }
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  ASSERT_EQ(output->GetCell(0)->GetNumberOfPoints(), 51);
  EXPECT_EQ(output->GetCell(0)->GetPointId(50), 50);
}

TEST_F(FilterPath, PointsAreTheTicksWhateverTheCells)
{
  const auto kept = (this->Run(51), Keep(this->Filter));
  vtkNew<vtkCellArray> backwards;
  backwards->InsertNextCell(3);
  for (const vtkIdType point : { 50, 20, 0 })
  {
    backwards->InsertCellPoint(point);
  }
  this->Path->SetLines(backwards);
  EXPECT_TRUE(IsSame(this->RunOn(this->Path, 51), kept));
}

TEST_F(FilterPath, SegmentsThatContinueOneAnotherAreOnePath)
{
  const auto kept = (this->Run(51), Keep(this->Filter));
  vtkNew<vtkCellArray> segments;
  for (vtkIdType i = 0; i < 50; ++i)
  {
    segments->InsertNextCell({ i, i + 1 });
  }
  this->Path->SetLines(segments);
  EXPECT_TRUE(IsSame(this->RunOn(this->Path, 51), kept));

  // The segments may have any order and direction, and a line with a single point may be present.
  vtkNew<vtkCellArray> shuffled;
  for (vtkIdType i = 0; i < 50; ++i)
  {
    const vtkIdType from = 7 * i % 50;
    i % 3 == 0 ? shuffled->InsertNextCell({ from + 1, from })
               : shuffled->InsertNextCell({ from, from + 1 });
  }
  shuffled->InsertNextCell({ 3 });
  this->Path->SetLines(shuffled);
  EXPECT_TRUE(IsSame(this->RunOn(this->Path, 51), kept));

  vtkNew<vtkCellArray> vertices;
  for (const vtkIdType point : { 0, 20, 50 })
  {
    vertices->InsertNextCell({ point });
  }
  this->Path->SetLines(nullptr);
  this->Path->SetVerts(vertices);
  EXPECT_TRUE(IsSame(this->RunOn(this->Path, 51), kept));
}

TEST_F(FilterPath, SegmentsThatMeetInSpaceAreOnePath)
{
  // The path goes down, up again, and sideways. Each of its three lines has separate points, as in
  // appended data. The second line starts off by a rounding error of float.
  const auto path = MakePath(
    { { 7, 7, 5 }, { 7, 7, 9 }, { 7, 7, 9.0000005 }, { 7, 7, 5 }, { 7, 7, 5 }, { 9, 7, 5 } });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  lines->InsertNextCell({ 2, 3 });
  lines->InsertNextCell({ 4, 5 });
  path->SetLines(lines);
  this->RunOn(path, 6);
}

TEST_F(FilterPath, PointsAtTicksAreTakenAsTheyAre)
{
  const auto plain = (this->Run(51), Keep(this->Filter));
  const std::vector<Point> points = Line({ 7, 7, 5 }, { 7, 7, 10 }, 50);
  std::vector<double> sums;
  double sum = 0.0;
  std::vector<double> products;
  for (int i = 0; i <= 50; ++i)
  {
    products.push_back(0.001 * i);
    sums.push_back(sum); // times with the rounding errors of a clock that accumulates
    sum += 0.001;
  }
  EXPECT_TRUE(IsSame(this->RunOn(MakePath(points, products), 51), plain));
  EXPECT_TRUE(IsSame(this->RunOn(MakePath(points, sums), 51), plain));
}

TEST_F(FilterPath, BetweenPointsTheTipMovesEvenly)
{
  this->RunOn(MakePath({ { 7, 7, 5 }, { 7, 7, 6 }, { 7, 7, 10 } }, { 2.0, 2.005, 2.0255 }), 26);
  for (vtkIdType tick = 0; tick < 26; ++tick)
  {
    const double t = 0.001 * static_cast<double>(tick);
    EXPECT_DOUBLE_EQ(this->TimeOf(tick), 2.0 + t);
    const double z = t <= 0.005 ? 5.0 + 200.0 * t : 6.0 + 4.0 * (t - 0.005) / 0.0205;
    EXPECT_NEAR(this->TipZ(tick), z, 1e-9) << "tick " << tick;
  }
  // If points are denser than ticks, the tip passes some of the points between two ticks.
  this->Filter->SetServoRate(100.0);
  this->RunOn(
    this->Path = MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 3), { 0.0, 0.004, 0.016, 0.02 }), 3);
  EXPECT_NEAR(this->TipZ(1), 0.5 * (5.0 + 5.0 / 3.0 + 5.0 + 10.0 / 3.0), 1e-9);
  EXPECT_NEAR(this->TipZ(2), 10.0, 1e-12);
}

TEST_F(FilterPath, OfPointsAtTheSameTimeTheLastCounts)
{
  this->RunOn(MakePath({ { 7, 7, 5 }, { 7, 7, 6 }, { 7, 7, 8 }, { 7, 7, 9 }, { 7, 7, 10 } },
                { 0.0, 0.0, 0.0, 0.002, 0.002 }),
    3);
  EXPECT_EQ(this->TipZ(0), 8.0);
  EXPECT_NEAR(this->TipZ(1), 8.5, 1e-9);
  EXPECT_EQ(this->TipZ(2), 10.0);
}
