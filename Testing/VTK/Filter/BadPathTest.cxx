// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Paths that make no sense: one error each, and recovery.
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

/// Eight points, and polylines of some of them.
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
  { "TwoLines",
    [] {
      return WithLines({ { 0, 1, 2, 3 }, { 4, 5, 6, 7 } });
    },
    { "tip path", "port 1", "2 lines", "one line at a time" } },
  { "TwoChains",
    [] {
      return WithLines({ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 4, 5 }, { 5, 6 }, { 6, 7 } });
    },
    { "tip path", "2 lines", "one line at a time" } },
  { "FourSegments",
    [] {
      return WithLines({ { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 } });
    },
    { "tip path", "4 lines" } },
  { "Fork",
    [] {
      return WithLines({ { 0, 1, 2 }, { 2, 3 }, { 2, 4, 5 } });
    },
    { "2 lines" } },
  { "Junction",
    [] {
      return WithLines({ { 0, 1, 2, 3 }, { 1, 4, 5 } });
    },
    { "2 lines" } },
  // The second line ends where the first begins, but is felt after it.
  { "SecondBeforeFirst",
    [] {
      return WithLines({ { 0, 1, 2, 3 }, { 4, 5, 6, 7, 0 } });
    },
    { "tip path", "port 1", "leap from point 3 to point 4", "vtkStripper" } },
  { "SecondEndsInSpaceWhereTheFirstBegins",
    []
    {
      const auto path = WithLines({ { 0, 1, 2 }, { 3, 4 } });
      path->GetPoints()->SetPoint(4, path->GetPoint(0));
      return path;
    },
    { "leap from point 2 to point 3" } },
  // A chain as cutters make it: 0, 2, 1, 3.
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
  // Two loops of a figure of eight, with one point for the middle.
  { "Eight",
    [] {
      return WithLines({ { 0, 1, 2, 0 }, { 0, 3, 4, 0 } });
    },
    { "leap from point 2 to point 3" } },
  // A star of six rays: every stroke takes two.
  { "Star",
    [] {
      return WithLines({ { 0, 1 }, { 0, 2 }, { 0, 3 }, { 0, 4 }, { 0, 5 }, { 0, 6 } });
    },
    { "3 lines" } },
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
