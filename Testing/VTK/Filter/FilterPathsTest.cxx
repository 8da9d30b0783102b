// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that several lines are several paths, each with bitwise the same trace as alone. "Alone" is
 * a polydata with only the points of one line, in the line's order.
 */

#include "Rigs/ApiRig.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace apitest;

namespace
{
using Lines = std::vector<std::vector<vtkIdType>>;

class FilterPaths : public ApiTest
{
protected:
  FilterPaths()
  {
    // The surfaces are curved everywhere, so every number of a trace depends on the earlier ticks.
    this->Image = MakeImage(24, VTK_SHORT,
      [](const Point& x)
      { return std::round(900.0 * std::sin(0.5 * x[0]) * std::cos(0.4 * x[1]) + 60.0 * x[2]); });
    this->Filter->SetInputDataObject(0, this->Image);
    SetConstant(this->Property->GetFriction(), 0.3);
    SetConstant(this->Property->GetViscosity(), 0.05);
  }

  static void SetLines(vtkPolyData* path, const Lines& lines)
  {
    vtkNew<vtkCellArray> cells;
    for (const auto& line : lines)
    {
      cells->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
    }
    path->SetLines(cells);
  }

  /// Returns the trace of a path with only the points in `line`.
  vtkSmartPointer<vtkPolyData> FeelAlone(vtkPolyData* path, const std::vector<vtkIdType>& line)
  {
    std::vector<Point> points;
    std::vector<double> times;
    vtkDataArray* const all = path->GetPointData()->GetArray("Time");
    for (const vtkIdType id : line)
    {
      points.emplace_back();
      path->GetPoint(id, points.back().data());
      if (all)
      {
        times.push_back(all->GetComponent(id, 0));
      }
    }
    this->Filter->SetPathData(MakePath(points, times));
    this->Filter->Update();
    return Keep(this->Filter);
  }

  /// Expects that a line of a trace equals another trace, including all arrays.
  static testing::AssertionResult IsLine(vtkPolyData* trace, vtkIdType line, vtkPolyData* alone)
  {
    vtkNew<vtkIdList> ids;
    trace->GetLines()->GetCellAtId(line, ids);
    if (ids->GetNumberOfIds() != alone->GetNumberOfPoints())
    {
      return testing::AssertionFailure() << "line " << line << " has " << ids->GetNumberOfIds()
                                         << " ticks, alone " << alone->GetNumberOfPoints();
    }
    const auto differ = [&](vtkDataArray* together, vtkDataArray* apart)
    {
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        for (int c = 0; c < apart->GetNumberOfComponents(); ++c)
        {
          if (together->GetComponent(ids->GetId(i), c) != apart->GetComponent(i, c))
          {
            return true;
          }
        }
      }
      return false;
    };
    if (ids->GetNumberOfIds() > 0 &&
      differ(trace->GetPoints()->GetData(), alone->GetPoints()->GetData()))
    {
      return testing::AssertionFailure() << "the proxy of line " << line << " differs";
    }
    for (int a = 0; a < alone->GetPointData()->GetNumberOfArrays(); ++a)
    {
      const char* const name = alone->GetPointData()->GetArrayName(a);
      vtkDataArray* const found = trace->GetPointData()->GetArray(name);
      if (!found || differ(found, alone->GetPointData()->GetArray(a)))
      {
        return testing::AssertionFailure() << name << " of line " << line << " differs";
      }
    }
    return testing::AssertionSuccess();
  }

  /// Expects that the lines of one path result in the same traces as each line alone.
  void ExpectAsAlone(vtkPolyData* path, const Lines& lines)
  {
    SetLines(path, lines);
    this->Filter->SetPathData(path);
    this->Filter->Update();
    const auto together = Keep(this->Filter);
    ASSERT_TRUE(this->Log.Errors.empty()) << this->Log.Errors.front();
    ASSERT_EQ(together->GetNumberOfLines(), static_cast<vtkIdType>(lines.size()));
    vtkIdType ticks = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      const auto alone = this->FeelAlone(path, lines[i]);
      ticks += alone->GetNumberOfPoints();
      ASSERT_TRUE(IsLine(together, static_cast<vtkIdType>(i), alone));
    }
    EXPECT_EQ(together->GetNumberOfPoints(), ticks);
  }

  /// Makes random walks with steps of up to 0.5 mm along each axis. `lines` receives the point ids
  /// of each walk, at most `most` per walk.
  vtkSmartPointer<vtkPolyData> Wander(int paths, int most, bool isTimed, Lines& lines)
  {
    std::mt19937 random(4711);
    const auto draw = [&random](double low, double high)
    { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
    std::vector<Point> points;
    std::vector<double> times;
    for (int i = 0; i < paths; ++i)
    {
      lines.emplace_back();
      Point x = { draw(4, 19), draw(4, 19), draw(4, 19) };
      double time = draw(-5.0, 5.0);
      const int size = 3 + static_cast<int>(draw(0, most - 3));
      const Point way = { draw(-0.4, 0.4), draw(-0.4, 0.4), draw(-0.4, 0.4) };
      for (int k = 0; k < size; ++k)
      {
        lines.back().push_back(static_cast<vtkIdType>(points.size()));
        points.push_back(x);
        times.push_back(time);
        time += draw(0.0, 0.004);
        for (int c = 0; c < 3; ++c)
        {
          x[c] = std::clamp(x[c] + way[c] + draw(-0.1, 0.1), 0.0, 23.0);
        }
      }
    }
    return MakePath(points, isTimed ? times : std::vector<double>());
  }
};
} // namespace

TEST_F(FilterPaths, AThousandAreAsEachAlone)
{
  Lines lines;
  const auto path = this->Wander(1000, 60, false, lines);
  this->ExpectAsAlone(path, lines);
  for (const char* array : { "Contact", "FrictionForce" })
  {
    double range[2];
    this->Filter->GetOutput()->GetPointData()->GetArray(array)->GetRange(range);
    EXPECT_GT(range[1], 0.0) << "the last path is in contact with nothing";
  }
}

TEST_F(FilterPaths, TimesAreThoseOfEach)
{
  Lines lines;
  const auto path = this->Wander(100, 60, true, lines);
  this->ExpectAsAlone(path, lines);
}

TEST_F(FilterPaths, WithEveryMethodAndManyThreads)
{
  for (const char* method : { "proxy", "paper", "force-field", "surface-proxy", "local-surface" })
  {
    SCOPED_TRACE(method);
    Lines lines;
    const auto path = this->Wander(40, 3000, false, lines);
    this->Filter->SetMethodByName(method);
    this->Filter->SetIsoValue(300.0);
    this->ExpectAsAlone(path, lines);
  }
}

TEST_F(FilterPaths, TheNumberOfThreadsChangesNothing)
{
  Lines lines;
  const auto path = this->Wander(200, 2000, false, lines);
  SetLines(path, lines);
  this->Filter->SetPathData(path);
  this->Filter->Update();
  const auto parallel = Keep(this->Filter);
  const std::string before = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
  this->Filter->Modified();
  this->Filter->Update();
  vtkSMPTools::SetBackend(before.c_str());
  EXPECT_TRUE(IsSame(this->Filter->GetOutput(), parallel));
}

TEST_F(FilterPaths, MaySharePointsAndHaveThemInAnyOrder)
{
  std::vector<Point> points = Line({ 7, 7, 5 }, { 7, 7, 10 }, 50);
  const auto path = MakePath(points);
  std::vector<vtkIdType> all(51);
  std::iota(all.begin(), all.end(), 0);
  const std::vector<vtkIdType> back(all.rbegin(), all.rend());
  const std::vector<vtkIdType> half(all.begin(), all.begin() + 26);
  const std::vector<vtkIdType> rest(all.begin() + 25, all.end());
  // The third line starts at the end of the second line, but with a new proxy.
  this->ExpectAsAlone(path, { all, half, rest, back, { 3, 17, 3, 17 } });
}

TEST_F(FilterPaths, WithoutPointsOrOfOne)
{
  const auto path = MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 50));
  this->ExpectAsAlone(path, { { 0, 1, 2, 3 }, {}, { 9 }, { 9 }, { 20, 21, 22 }, {} });
  this->ExpectAsAlone(path, { { 4 }, { 5 } });
  this->ExpectAsAlone(path, { {}, {} });
  this->ExpectAsAlone(path, { { 4, 5, 6 }, {} });
}

TEST_F(FilterPaths, SegmentsThatContinueOneAnotherAreOne)
{
  const auto path = MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 50));
  SetLines(path, { { 0, 1 }, { 1, 2 }, { 10, 12 }, { 12, 11 }, { 30, 31 } });
  this->Filter->SetPathData(path);
  this->Filter->Update();
  const auto trace = Keep(this->Filter);
  ASSERT_EQ(trace->GetNumberOfLines(), 3);
  EXPECT_TRUE(IsLine(trace, 0, this->FeelAlone(path, { 0, 1, 2 })));
  EXPECT_TRUE(IsLine(trace, 1, this->FeelAlone(path, { 10, 12, 11 })));
  EXPECT_TRUE(IsLine(trace, 2, this->FeelAlone(path, { 30, 31 })));
  // Three rays share a point, and each ray starts with a new proxy.
  this->ExpectAsAlone(path, { { 0, 1 }, { 0, 5 }, { 0, 9 } });
}

TEST_F(FilterPaths, PointsOfNoLineAndOtherCellsAreNotFelt)
{
  const auto path = MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 50));
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 40 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 41, 42, 43, 44 });
  path->SetVerts(vertices);
  path->SetStrips(strips);
  this->ExpectAsAlone(path, { { 0, 1, 2, 3 }, { 10, 11, 12 } });
}

TEST_F(FilterPaths, EachBeginsWithTheProxyOnTheTip)
{
  // One path starts in free space, the other deep inside the ramp. In both, the force must start at
  // 0.
  const auto path = MakePath(
    { { 7, 7, 2 }, { 7, 7, 2.1 }, { 7, 7, 2.2 }, { 7, 7, 20 }, { 7, 7, 20.1 }, { 7, 7, 20.2 } });
  SetLines(path, { { 0, 1, 2 }, { 3, 4, 5 } });
  this->Filter->SetPathData(path);
  vtkPolyData* const trace = this->Run(6);
  for (const vtkIdType first : { 0, 3 })
  {
    EXPECT_EQ(trace->GetPoint(first)[2], path->GetPoint(first)[2]);
    EXPECT_EQ(Get(trace, "Force", first, 2), 0.0);
    EXPECT_EQ(Get(trace, "Energy", first), 0.0);
    EXPECT_EQ(Get(trace, "Time", first), 0.0);
    EXPECT_EQ(Get(trace, "Time", first + 2), 0.002);
  }
}

TEST_F(FilterPaths, ProgressRisesAndAnAbortCutsEachShort)
{
  Lines lines;
  std::vector<Point> points;
  constexpr vtkIdType size = 20001;
  for (int i = 0; i < 12; ++i)
  {
    const auto one = Line({ 5.0 + i, 7, 5 }, { 5.0 + i, 9, 15 }, size - 1);
    lines.emplace_back(size);
    std::iota(lines.back().begin(), lines.back().end(), static_cast<vtkIdType>(points.size()));
    points.insert(points.end(), one.begin(), one.end());
  }
  const auto path = MakePath(points);
  SetLines(path, lines);
  this->Filter->SetPathData(path);
  const auto full = (this->Filter->Update(), Keep(this->Filter));

  struct Watch
  {
    vtkVolumeHapticsFilter* Filter;
    std::vector<double> Shares;
  } watch{ this->Filter, {} };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* share)
    {
      auto* const to = static_cast<Watch*>(data);
      to->Shares.push_back(*static_cast<double*>(share));
      if (to->Shares.back() > 0.3)
      {
        to->Filter->SetAbortExecute(1);
      }
    });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, command);
  this->Filter->Modified();
  this->Filter->Update();
  EXPECT_TRUE(this->Log.Errors.empty());
  EXPECT_TRUE(std::is_sorted(watch.Shares.begin(), watch.Shares.end()));
  EXPECT_GE(watch.Shares.size(), 3U);
  vtkPolyData* const cut = this->Filter->GetOutput();
  ASSERT_EQ(cut->GetNumberOfLines(), 12);
  EXPECT_GT(cut->GetNumberOfPoints(), 12 * size / 4);
  EXPECT_LT(cut->GetNumberOfPoints(), 12 * size * 3 / 4);
  vtkIdType next = 0;
  for (vtkIdType i = 0; i < 12; ++i)
  {
    vtkNew<vtkIdList> ids;
    cut->GetLines()->GetCellAtId(i, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k, ++next)
    {
      ASSERT_EQ(ids->GetId(k), next);
      for (const char* array : { "Time", "Force", "Contact", "Energy" })
      {
        vtkDataArray* const there = full->GetPointData()->GetArray(array);
        ASSERT_EQ(Get(cut, array, next), there->GetComponent(i * size + k, 0)) << array;
      }
      ASSERT_EQ(cut->GetPoint(next)[2], full->GetPoint(i * size + k)[2]);
    }
  }
  EXPECT_EQ(next, cut->GetNumberOfPoints());
}

TEST_F(FilterPaths, LabelsAreThoseOfEach)
{
  this->Filter->SetLabelData(
    MakeImage(24, VTK_UNSIGNED_CHAR, [](const Point& x) { return x[0] < 12.0 ? 3.0 : 7.0; }));
  Lines lines;
  const auto path = this->Wander(30, 60, false, lines);
  this->ExpectAsAlone(path, lines);
  EXPECT_NE(this->Filter->GetOutput()->GetPointData()->GetArray("Label"), nullptr);
}
