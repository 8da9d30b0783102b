// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that an invalid path causes one error, and that the filter works again with the next path.
 */

#include "Rigs/ApiRig.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <limits>

using namespace apitest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Inf = std::numeric_limits<double>::infinity();

const std::vector<Point> Three = { { 7, 7, 5 }, { 7, 7, 6 }, { 7, 7, 7 } };

struct BadPath
{
  const char* Name;
  std::function<vtkSmartPointer<vtkPolyData>()> Make;
  std::vector<std::string> Words;
};

vtkSmartPointer<vtkPolyData> WithTimeArray(int components, int tuples)
{
  auto path = MakePath(Three);
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  times->SetNumberOfComponents(components);
  times->SetNumberOfTuples(tuples);
  times->Fill(0.0);
  path->GetPointData()->AddArray(times);
  return path;
}

/// Makes eight points, and polylines that connect some of them by index.
vtkSmartPointer<vtkPolyData> WithLines(const std::vector<std::vector<vtkIdType>>& lines)
{
  auto path = MakePath({ { 7, 7, 5 }, { 7, 7, 6 }, { 7, 7, 7 }, { 7, 7, 8 }, { 4, 4, 5 },
    { 4, 4, 6 }, { 4, 4, 7 }, { 4, 4, 8 } });
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
  }
  path->SetLines(cells);
  return path;
}

void AddTimes(vtkPolyData* path, const std::vector<double>& times)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Time");
  for (const double time : times)
  {
    array->InsertNextValue(time);
  }
  path->GetPointData()->AddArray(array);
}

const BadPath BadPaths[] = {
  { "NaN",
    [] {
      return MakePath({ { 7, 7, 5 }, { 7, NaN, 6 } });
    },
    { "tip path", "NaN", "point 1", "Replace or remove" } },
  { "Infinite",
    [] {
      return MakePath({ { -Inf, 7, 5 }, { 7, 7, 6 } });
    },
    { "tip path", "infinite", "point 0", "Replace or remove" } },
  { "TimeDecreasing",
    [] {
      return MakePath(Three, { 0.0, 0.002, 0.001 });
    },
    { "tip path", "\"Time\"", "decreases", "point 2", "Sort" } },
  { "TimeNaN",
    [] {
      return MakePath(Three, { 0.0, NaN, 0.002 });
    },
    { "tip path", "\"Time\"", "not finite", "point 1" } },
  { "TimeInfinite",
    [] {
      return MakePath(Three, { 0.0, 0.001, Inf });
    },
    { "tip path", "\"Time\"", "not finite", "point 2" } },
  { "TimeVectors", [] { return WithTimeArray(3, 3); },
    { "tip path", "\"Time\"", "3 component", "one number of seconds a point" } },
  { "TimeTooShort", [] { return WithTimeArray(1, 2); },
    { "tip path", "\"Time\"", "2 tuples", "3 points" } },
  { "TimeInMicroseconds",
    [] {
      return MakePath(Three, { 0.0, 1e6, 1e9 });
    },
    { "tip path", "\"Time\"", "ticks", "seconds" } },
  { "PointThatIsNot",
    [] {
      return WithLines({ { 0, 1, 2, 3 }, { 4, 5, 6, 8 } });
    },
    { "Line 1 of the tip path", "port 1", "point 8", "there are 8 points" } },
  { "SecondLineIsNaN",
    []
    {
      const auto path = WithLines({ { 0, 1, 2, 3 }, { 4, 5, 6, 7 } });
      path->GetPoints()->SetPoint(6, 0.0, NaN, 0.0);
      return path;
    },
    { "tip path", "NaN", "point 6", "Replace or remove" } },
  { "TimeOfTheSecondLineDecreases",
    []
    {
      const auto path = WithLines({ { 0, 1, 2, 3 }, { 4, 5, 7, 6 } });
      AddTimes(path, { 5, 6, 7, 8, 0, 1, 2, 3 });
      return path;
    },
    { "tip path", "\"Time\"", "decreases from 3 s to 2 s at point 6", "Sort" } },
  { "TicksOfAllLines",
    []
    {
      const auto path = WithLines({ { 0, 1, 2 }, { 4, 5, 6 } });
      AddTimes(path, { 0, 1, 6e4, 0, 0, 1, 6e4, 0 });
      return path;
    },
    { "tip path", "1.2e+08 ticks", "seconds" } },
  { "RecordingOfTwoLines",
    []
    {
      const auto path = WithLines({ { 0, 1, 2, 3 }, { 4, 5, 6, 7 } });
      vtkNew<vtkDoubleArray> tips;
      tips->SetName("DeviceTip");
      tips->SetNumberOfComponents(3);
      tips->SetNumberOfTuples(8);
      tips->Fill(0.0);
      path->GetPointData()->AddArray(tips);
      return path;
    },
    { "recording", "DeviceTip", "2 lines", "one recording at a time" } },
  // Cutters produce such chains of segments, in which the points are in the order 0, 2, 1, 3.
  { "OutOfOrder",
    [] {
      return WithLines({ { 0, 2 }, { 2, 1 }, { 1, 3 } });
    },
    { "leap from point 0 to point 1" } },
  { "LineOutOfOrder",
    [] {
      return WithLines({ { 0, 2, 1, 3 } });
    },
    { "leap from point 0 to point 1" } },
};

class BadPathTest
  : public ApiTest
  , public testing::WithParamInterface<BadPath>
{
};
} // namespace

TEST_P(BadPathTest, GivesOneErrorAndRecovers)
{
  this->Run(51);
  this->Filter->SetPathData(this->GetParam().Make());
  this->ExpectError(this->GetParam().Words);
  this->Filter->SetPathData(this->Path);
  this->Run(51);
}

INSTANTIATE_TEST_SUITE_P(All, BadPathTest, testing::ValuesIn(BadPaths),
  [](const auto& info) { return std::string(info.param.Name); });
