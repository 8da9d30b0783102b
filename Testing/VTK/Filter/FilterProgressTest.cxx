// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that long paths report their progress, and can be aborted.
 */

#include "Rigs/ApiRig.h"

#include <algorithm>
#include <random>
#include <thread>

using namespace apitest;

namespace
{
constexpr int Ticks = 20001;

class FilterProgress : public ApiTest
{
protected:
  FilterProgress()
  {
    std::vector<Point> points = Line({ 7, 7, 5 }, { 9, 8, 10 }, (Ticks - 1) / 2);
    const std::vector<Point> back = Line({ 9, 8, 10 }, { 7, 7, 4 }, (Ticks - 1) / 2);
    points.insert(points.end(), back.begin() + 1, back.end());
    this->Filter->SetPathData(MakePath(points));
    SetConstant(this->Property->GetFriction(), 0.4);
    SetConstant(this->Property->GetViscosity(), 0.1);
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* share)
      {
        auto* const test = static_cast<FilterProgress*>(self);
        test->Shares.push_back(*static_cast<double*>(share));
        if (test->Shares.back() > test->AbortAt)
        {
          test->Filter->SetAbortExecute(1);
        }
      });
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }

  /** Lets the next update finish. Since VTK 9.3, the pipeline does not reset the abort flag. */
  void EndAborting()
  {
    this->AbortAt = 2.0;
    this->Filter->SetAbortExecute(0);
  }

  vtkNew<vtkCallbackCommand> Command;
  std::vector<double> Shares;
  double AbortAt = 2.0;
};
} // namespace

TEST_F(FilterProgress, RisesFromZeroToOne)
{
  this->Run(Ticks);
  EXPECT_GE(this->Shares.size(), 10U);
  EXPECT_LE(this->Shares.size(), 210U) << "not an event a tick";
  EXPECT_TRUE(std::is_sorted(this->Shares.begin(), this->Shares.end()));
  EXPECT_EQ(this->Shares.front(), 0.0);
  EXPECT_EQ(this->Shares.back(), 1.0);
}

TEST_F(FilterProgress, AbortKeepsTheTicksSoFar)
{
  const auto full = (this->Run(Ticks), Keep(this->Filter));
  this->AbortAt = 0.4;
  this->Filter->Modified();
  this->Filter->Update();
  vtkPolyData* const output = this->Filter->GetOutput();
  const vtkIdType ticks = output->GetNumberOfPoints();
  EXPECT_GE(ticks, Ticks * 4 / 10);
  EXPECT_LE(ticks, Ticks * 6 / 10);
  EXPECT_TRUE(this->Log.Errors.empty());
  EXPECT_TRUE(IsSame(output, full, ticks)) << "the part that ran is that of the full run";
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  EXPECT_EQ(output->GetCell(0)->GetNumberOfPoints(), ticks);

  this->EndAborting();
  this->Filter->Modified();
  EXPECT_TRUE(IsSame(this->Run(Ticks), full)) << "an abort leaves nothing behind";
}

TEST_F(FilterProgress, AMeshThatTakesLongCanBeAborted)
{
  // The values are random, so the isosurface passes through all of them, with several hundred
  // thousand triangles.
  std::mt19937 random(1);
  this->Filter->SetInputData(0,
    MakeImage(40, VTK_FLOAT, [&](const Point&) { return static_cast<double>(random() % 2001); }));
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(1000.0);
  this->AbortAt = -1.0;
  this->Filter->Update();
  EXPECT_EQ(this->Shares.front(), 0.0);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Log.Errors.empty());
  this->EndAborting();
  this->Filter->Modified();
  this->Run(Ticks);
}

TEST_F(FilterProgress, SameInputSameOutputToTheBit)
{
  for (const int estimator : { 0, 1, 2 })
  {
    this->Filter->SetGradientEstimator(estimator);
    const auto first = (this->Run(Ticks), Keep(this->Filter));
    this->Filter->Modified();
    EXPECT_TRUE(IsSame(this->Run(Ticks), first)) << "estimator " << estimator;
  }
}

TEST_F(FilterProgress, ThreadsDoNotDisturbEachOther)
{
  this->Run(Ticks);
  constexpr int threads = 4;
  std::vector<vtkSmartPointer<vtkVolumeHapticsFilter>> filters;
  for (int i = 0; i < threads; ++i)
  {
    filters.push_back(vtkSmartPointer<vtkVolumeHapticsFilter>::New());
    // Give each filter a separate pipeline with the same samples.
    vtkNew<vtkImageData> image;
    image->ShallowCopy(this->Image);
    vtkNew<vtkPolyData> path;
    path->ShallowCopy(this->Filter->GetInputDataObject(1, 0));
    filters.back()->SetInputDataObject(0, image);
    filters.back()->SetPathData(path);
    filters.back()->GetProperty()->DeepCopy(this->Property);
  }
  std::vector<std::thread> running;
  for (const auto& filter : filters)
  {
    running.emplace_back([&filter] { filter->Update(); });
  }
  for (std::thread& thread : running)
  {
    thread.join();
  }
  for (const auto& filter : filters)
  {
    EXPECT_TRUE(IsSame(filter->GetOutput(), this->Filter->GetOutput()));
  }
}
