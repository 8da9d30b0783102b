// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a needle without a device: the layers of case N1 with a spring of 500 N/m, the loss of
 * resistance, the lateral resistance, rotated data, orientations of paths, tracks, and invalid
 * settings.
 */

#include "Rigs/ApiRig.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticNeedle.h>
#include <vtkMatrix3x3.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>

#include <cmath>

using namespace apitest;

namespace
{
constexpr double Skin = 4.5; // mm, z of the skin

/// Layers of case N1, starting at the skin: thickness (mm), shaft friction (N/m), cutting force
/// (N).
constexpr double Layers[][3] = { { 3, 20, 0.3 }, { 12, 5, 0.1 }, { 20, 25, 0.3 }, { 3, 60, 0.8 },
  { 100, 0, 0 } };

int LabelAt(double depth)
{
  int label = depth < 0.0 ? 0 : 1;
  for (double end = Layers[0][0]; label > 0 && depth > end; ++label)
  {
    end += Layers[label][0];
  }
  return label;
}

/// Returns the friction (N) of the shaft between the skin and this depth (mm).
double ShaftAt(double depth)
{
  double sum = 0.0;
  double begin = 0.0;
  for (const auto& layer : Layers)
  {
    sum += 1e-3 * layer[1] * std::max(0.0, std::min(depth, begin + layer[0]) - begin);
    begin += layer[0];
  }
  return sum;
}

class FilterNeedle : public ApiTest
{
protected:
  FilterNeedle()
  {
    this->Filter->SetInputData(MakeStack([](int) { return 0.0; }));
    this->Filter->SetLabelData(MakeStack([](int k) { return LabelAt(k - Skin); }));
    this->Filter->SetGeometryFromLabels();
    this->Filter->SetLabelTable(this->Table);
    for (int label = 1; label <= 5; ++label)
    {
      this->Table->SetStiffness(label, 500.0);
      this->Table->SetSurfaceStrength(label, 0.0);
      this->Table->SetShaftFriction(label, Layers[label - 1][1]);
      this->Table->SetViscosity(label, Layers[label - 1][2]);
    }
    this->Filter->SetTool(this->Needle);
  }

  static vtkSmartPointer<vtkImageData> MakeStack(const std::function<double(int)>& value)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(16, 16, 56);
    image->AllocateScalars(VTK_SHORT, 1);
    for (int k = 0; k < 56; ++k)
    {
      for (int i = 0; i < 16 * 16; ++i)
      {
        image->GetPointData()->GetScalars()->SetComponent(256 * k + i, 0, value(k));
      }
    }
    return image;
  }

  /// Moves the needle between the given positions in steps of 1 / `steps` mm, and returns the
  /// trace.
  vtkPolyData* Follow(const std::vector<Point>& places, int steps = 100)
  {
    std::vector<Point> points;
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      const Point& a = places[i - 1];
      const Point& b = places[i];
      const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
      const std::vector<Point> part = Line(a, b, std::max(1, int(steps * length)));
      points.insert(points.end(), part.begin(), part.end());
    }
    this->Path = MakePath(points);
    this->Filter->SetPathData(this->Path);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  static double Number(vtkPolyData* track, const char* name)
  {
    return track->GetFieldData()->GetArray(name)->GetComponent(0, 0);
  }

  vtkNew<vtkHapticLabelTable> Table;
  vtkNew<vtkHapticNeedle> Needle;
};
} // namespace

TEST_F(FilterNeedle, FeelsLayersInAndOut)
{
  for (const int solver : { vtkVolumeHapticsFilter::PAPER, vtkVolumeHapticsFilter::PRECISE })
  {
    this->Filter->SetSolver(solver);
    vtkPolyData* const trace = this->Follow({ { 7, 7, 2 }, { 7, 7, 48 }, { 7, 7, 1 } });
    double lastDepth = 0.0;
    double loss = 0.0;
    int in = 0;
    int out = 0;
    for (vtkIdType i = 1; i < trace->GetNumberOfPoints(); ++i)
    {
      const double depth = Get(trace, "Depth", i);
      const double force = Get(trace, "Force", i, 2);
      if (depth > 0.0)
      {
        ASSERT_NEAR(depth, trace->GetPoint(i)[2] - Skin, 1e-3);
        ASSERT_EQ(Get(trace, "Label", i), LabelAt(depth));
        ASSERT_NEAR(Get(trace, "ShaftForce", i), ShaftAt(depth), 1e-5);
      }
      const double cutting = depth > 0.0 ? Layers[LabelAt(depth) - 1][2] : 0.0;
      // In the tick in which the tip reaches harder tissue, the force has not increased yet.
      const bool isSame = LabelAt(depth) == LabelAt(lastDepth);
      if (depth > lastDepth && isSame)
      {
        const double held = cutting + ShaftAt(depth);
        ASSERT_NEAR(-force, held, 0.01 * held + 1e-4) << depth;
        ++in;
      }
      else if (depth < lastDepth && depth > 0.0)
      {
        ASSERT_NEAR(force, ShaftAt(depth), 0.01 * ShaftAt(depth) + 1e-4) << depth;
        ++out;
      }
      loss = std::max(loss, force - Get(trace, "Force", i - 1, 2));
      lastDepth = depth;
    }
    EXPECT_GT(in, 3000);
    EXPECT_GT(out, 3000);
    EXPECT_NEAR(loss, 0.80, 0.02);
    EXPECT_EQ(Get(trace, "Depth", trace->GetNumberOfPoints() - 1), 0.0);
    // The expected work (J) consists of the shaft's friction, the cutting, and the losses where the
    // resistance R falls by 0.2 N and by 0.8 N.
    const double work = -Get(trace, "Energy", trace->GetNumberOfPoints() - 1);
    EXPECT_NEAR(work,
      12.30e-3 + 10.5e-3 + 0.68e-3 + 12.30e-3 + 2.0 * 0.8 * (48 - Skin - 41.6) * 1e-3, 0.01 * work);
  }
}

TEST_F(FilterNeedle, HoldsAcrossItsAxis)
{
  vtkPolyData* trace = this->Follow({ { 7, 7, 2 }, { 7, 7, 25 }, { 8, 7, 25 } });
  const vtkIdType last = trace->GetNumberOfPoints() - 1;
  EXPECT_NEAR(Get(trace, "Force", last, 0), -0.5, 0.005);
  EXPECT_NEAR(Get(trace, "FrictionForce", last), 0.5, 0.005);
  this->Needle->SetLateralStrength(0.2);
  trace = this->Follow({ { 7, 7, 2 }, { 7, 7, 25 }, { 8, 7, 25 } });
  EXPECT_NEAR(Get(trace, "Force", last, 0), -0.2, 0.002);
}

TEST_F(FilterNeedle, TurnsWithTheDataAndThePath)
{
  const std::vector<Point> way = { { 7, 7, 2 }, { 7, 7, 30 }, { 7.5, 7.2, 30 }, { 7, 7, 20 } };
  const auto upright = (this->Follow(way), Keep(this->Filter));
  // Permute the axes: z becomes x, x becomes y, and y becomes z.
  const double turn[9] = { 0, 0, 1, 1, 0, 0, 0, 1, 0 };
  for (const int port : { 0, 3 })
  {
    vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(port, 0))
      ->GetDirectionMatrix()
      ->DeepCopy(turn);
    this->Filter->GetInputDataObject(port, 0)->Modified();
  }
  std::vector<Point> turned;
  for (const Point& p : way)
  {
    turned.push_back({ p[2], p[0], p[1] });
  }
  vtkPolyData* const trace = this->Follow(turned);
  ASSERT_EQ(trace->GetNumberOfPoints(), upright->GetNumberOfPoints());
  double largest = 0.0;
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(
        largest, std::abs(Get(trace, "Force", i, (c + 1) % 3) - Get(upright, "Force", i, c)));
    }
  }
  EXPECT_LT(largest, 1e-6);
}

TEST_F(FilterNeedle, FollowsTheOrientationOfThePath)
{
  this->Table->SetSurfaceStrength(1, 1.0);
  this->Follow({ { 7, 7, 2 }, { 7, 7, 25 } });
  const vtkIdType n = this->Path->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName("Orientation");
  orientations->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < n; ++i)
  {
    // The stylus is rotated by 180 degrees about x, so that it points along +z, and tilted by 0.2
    // rad.
    orientations->InsertNextTuple4(std::sin(-0.1), std::cos(-0.1), 0.0, 0.0);
  }
  this->Path->GetPointData()->AddArray(orientations);
  this->Path->Modified();
  this->Filter->Update();
  vtkPolyData* const trace = this->Filter->GetOutput();
  EXPECT_GT(Get(trace, "Depth", n - 1), 10.0);
  EXPECT_NEAR(Get(trace, "Orientation", n - 1, 1), std::cos(0.1), 1e-12);
  EXPECT_NEAR(Get(trace, "Torque", n - 1, 0), 0.0, 0.0);
  EXPECT_NEAR(std::abs(Get(trace, "Normal", n - 1, 1)), std::sin(0.2), 1e-9);
  EXPECT_NEAR(Get(trace, "Normal", n - 1, 2), std::cos(0.2), 1e-9);
  vtkNew<vtkPolyData> track;
  ASSERT_TRUE(vtkHapticNeedle::MakeTrack(trace, track));
  EXPECT_NEAR(this->Number(track, "Angle"), 0.2 * 57.29577951, 0.2);
  // With the opposite orientation, the needle presses with its blunt end, which must not puncture.
  for (vtkIdType i = 0; i < n; ++i)
  {
    orientations->SetTuple4(i, 1.0, 0.0, 0.0, 0.0);
  }
  orientations->Modified();
  this->Path->Modified();
  this->Filter->Update();
  EXPECT_EQ(Get(this->Filter->GetOutput(), "Depth", n - 1), 0.0);
}

TEST_F(FilterNeedle, TellsWhatItHasPassed)
{
  this->Table->SetSurfaceStrength(1, 0.5);
  vtkPolyData* const trace = this->Follow({ { 7, 7, 2 }, { 7, 7, 44 }, { 7, 7, 30 } });
  vtkNew<vtkPolyData> track;
  ASSERT_TRUE(vtkHapticNeedle::MakeTrack(trace, track));
  ASSERT_EQ(track->GetNumberOfCells(), 4);
  const double lengths[] = { 3.0, 12.0, 20.0 };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(track->GetCellData()->GetArray("Label")->GetComponent(i, 0), i + 1);
    EXPECT_NEAR(track->GetCellData()->GetArray("Length")->GetComponent(i, 0), lengths[i], 0.1);
  }
  EXPECT_EQ(track->GetCellData()->GetArray("Label")->GetComponent(3, 0), 4);
  EXPECT_NEAR(track->GetPoint(0)[2], Skin, 0.05);
  EXPECT_NEAR(track->GetPoint(4)[2] - Skin, this->Number(track, "Depth"), 0.05);
  EXPECT_NEAR(this->Number(track, "Angle"), 0.0, 0.1);
}

/// Make the ligament forbidden. It must stop two of the three thrusts of the first insertion, and
/// the only thrust of the second insertion.
TEST_F(FilterNeedle, CountsWhatForbiddenTissueStops)
{
  this->Table->SetForbidden(4, true);
  vtkPolyData* const trace = this->Follow({ { 7, 7, 2 }, { 7, 7, 46 }, { 7, 7, 30 }, { 7, 7, 36 },
    { 7, 7, 30 }, { 7, 7, 46 }, { 7, 7, 1 }, { 7, 7, 46 } });
  vtkDataArray* const touches = trace->GetPointData()->GetArray("ForbiddenTouches");
  ASSERT_TRUE(touches);
  // Read the counts at the end of each move; the needle moves 0.01 mm per tick.
  const auto after = [touches](double way)
  { return touches->GetComponent(static_cast<vtkIdType>(100.0 * way) - 1, 0); };
  EXPECT_EQ(after(20.0), 0.0);
  EXPECT_EQ(after(44.0), 1.0);
  EXPECT_EQ(after(66.0), 1.0);
  EXPECT_EQ(after(88.0), 2.0);
  vtkNew<vtkPolyData> track;
  ASSERT_TRUE(vtkHapticNeedle::MakeTrack(trace, track));
  EXPECT_EQ(this->Number(track, "ForbiddenTouches"), 1.0);
  // A trace with only this array must have the same counts.
  vtkNew<vtkDoubleArray> all;
  all->DeepCopy(touches);
  this->Filter->SetTraceArrays("ForbiddenTouches");
  this->Filter->Update();
  vtkDataArray* const alone =
    this->Filter->GetOutput()->GetPointData()->GetArray("ForbiddenTouches");
  ASSERT_TRUE(alone);
  ASSERT_EQ(alone->GetNumberOfTuples(), all->GetNumberOfTuples());
  for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(alone->GetComponent(i, 0), all->GetComponent(i, 0)) << i;
  }
}

TEST_F(FilterNeedle, WritesNoTrackIntoTheTraceItself)
{
  vtkPolyData* const trace = this->Follow({ { 7, 7, 2 }, { 7, 7, 20 } });
  const vtkIdType points = trace->GetNumberOfPoints();
  const apitest::MessageLog log(trace);
  EXPECT_FALSE(vtkHapticNeedle::MakeTrack(trace, trace));
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("another one"), std::string::npos) << log.Errors[0];
  EXPECT_EQ(trace->GetNumberOfPoints(), points);
}

TEST_F(FilterNeedle, HasItsArraysOnlyWithATool)
{
  vtkPolyData* const trace = this->Follow({ { 7, 7, 2 }, { 7, 7, 10 } }, 10);
  for (const char* const name :
    { "Orientation", "Torque", "Depth", "ShaftForce", "ForbiddenTouches" })
  {
    EXPECT_TRUE(trace->GetPointData()->HasArray(name)) << name;
  }
  this->Filter->SetTraceArrays("Depth");
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
  this->Filter->SetTraceArrays("all");
  this->Filter->SetTool(nullptr);
  this->Filter->Update();
  EXPECT_FALSE(this->Filter->GetOutput()->GetPointData()->HasArray("Depth"));
}

TEST_F(FilterNeedle, TellsWhatCannotBeFelt)
{
  const auto refuse = [this](const std::vector<std::string>& words)
  {
    const MessageLog log(this->Filter);
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_EQ(log.Errors.size(), 1U);
    for (const std::string& word : words)
    {
      EXPECT_NE((log.Errors.empty() ? "" : log.Errors[0]).find(word), std::string::npos) << word;
    }
  };
  this->Follow({ { 7, 7, 2 }, { 7, 7, 10 } }, 10);
  this->Filter->SetMethodToForceField();
  refuse({ "vtkHapticNeedle", "SetMethodToProxy()" });
  this->Filter->SetMethodToProxy();
  this->Needle->GetShaftFriction()->AddPoint(10.0, -1.0);
  refuse({ "ShaftFriction", "-1", "GetShaftFriction()" });
  this->Needle->SetShaftFriction(nullptr);
  this->Needle->GetCuttingForce()->AddPoint(10.0, std::nan(""));
  refuse({ "CuttingForce", "GetCuttingForce()" });
  this->Needle->SetCuttingForce(nullptr);
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName("Orientation");
  orientations->SetNumberOfComponents(4);
  orientations->SetNumberOfTuples(this->Path->GetNumberOfPoints());
  orientations->FillValue(3.0);
  this->Path->GetPointData()->AddArray(orientations);
  this->Path->Modified();
  refuse({ "\"Orientation\"", "point 0", "unit quaternion" });
  // Without a tool, the filter must ignore the array "Orientation".
  this->Filter->SetTool(nullptr);
  this->Filter->Update();
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}
