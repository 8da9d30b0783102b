// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a burr without a device: B1 to B3 of the design from the trace alone, cavities touched with
 * the point, several paths, and invalid settings.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/TimeSource.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkHapticBurr.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticRemoval.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>

#include <cmath>

using namespace apitest;

namespace
{
constexpr double BurrPi = 3.14159265358979323846;
constexpr double BurrVoxel = 0.25; // mm, edge of a voxel

/// Solid tissue with the value 200 above z = Surface, in voxels of 0.25 mm.
class FilterBurr : public ApiTest
{
protected:
  static constexpr double Surface = 19.5 * BurrVoxel; // mm, z of the surface

  FilterBurr()
  {
    this->Image =
      MakeImage(64, VTK_UNSIGNED_CHAR, [](const Point& x) { return x[2] > 19.5 ? 200.0 : 0.0; });
    this->Image->SetSpacing(BurrVoxel, BurrVoxel, BurrVoxel);
    this->Filter->SetInputData(this->Image);
    this->Filter->SetMethodToProxy();
    this->Burr->SetRadius(3.0);
    this->Burr->SetSolidToAbove();
    this->Burr->SetContactValue(100.0);
    this->Filter->SetTool(this->Burr);
    SetConstant(this->Property->GetSurfaceStrength(), 1e4);
  }

  vtkPolyData* Follow(const std::vector<Point>& points)
  {
    this->Path = MakePath(points);
    this->Filter->SetPathData(this->Path);
    return this->Run(static_cast<vtkIdType>(points.size()));
  }
  /// Makes a path that plunges into the tissue to this depth (mm), and rests there for half of the
  /// ticks.
  static std::vector<Point> Plunge(double depth, int ticks, double x = 8.0, double y = 7.9)
  {
    const double z = Surface - 3.2;
    std::vector<Point> points = Line({ x, y, z }, { x, y, z + 0.2 + depth }, ticks / 2 - 1);
    points.insert(points.end(), static_cast<std::size_t>(ticks / 2), points.back());
    return points;
  }
  static double Sum(vtkPolyData* trace, const char* array)
  {
    double sum = 0.0;
    for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
    {
      sum += Get(trace, array, i);
    }
    return sum;
  }

  vtkNew<vtkHapticBurr> Burr;
};
} // namespace

/// The removal rate is Q = mu F v/U, with the force F of the trace. At the end, an amount of energy
/// smaller than a step's cost may be left over.
TEST_F(FilterBurr, RemovesByItsEnergy)
{
  SetConstant(this->Burr->GetSpecificEnergy(), 4.0);
  this->Burr->SetFriction(0.25);
  this->Burr->SetSpeed(30000.0);
  vtkPolyData* const trace = this->Follow(Plunge(4.0, 4000));
  const double rim = 2.0 * BurrPi * 3e-3 * 500.0; // m/s, speed of the burr's rim
  const double expected = 0.25 * rim * 1e-3 * Sum(trace, "NormalForce") / 4.0;
  EXPECT_GT(expected, 2.0) << "mm^3";
  EXPECT_NEAR(Sum(trace, "RemovedVolume"), expected, 0.01 * expected);
}

/// A label with its own energy U2 has the rate Q = mu F v/U2, regardless of U(V). U(V) applies in
/// labels without an energy.
TEST_F(FilterBurr, LabelsHaveAnEnergyOfTheirOwn)
{
  SetConstant(this->Burr->GetSpecificEnergy(), 4.0);
  this->Burr->SetFriction(0.25);
  this->Burr->SetSpeed(30000.0);
  const double rim = 2.0 * BurrPi * 3e-3 * 500.0; // m/s, speed of the burr's rim
  vtkNew<vtkHapticLabelTable> table;
  table->SetSpecificEnergy(2, 9.0);
  table->SetStiffness(7, 500.0);
  this->Filter->SetLabelTable(table);
  for (const int label : { 2, 7 })
  {
    const auto labels = MakeImage(64, VTK_SHORT, [label](const Point&) { return label; });
    labels->SetSpacing(this->Image->GetSpacing());
    this->Filter->SetLabelData(labels);
    vtkPolyData* const trace = this->Follow(Plunge(4.0, 10000));
    const double expected =
      0.25 * rim * 1e-3 * Sum(trace, "NormalForce") / (label == 2 ? 9.0 : 4.0);
    EXPECT_GT(expected, 2.0) << "mm^3";
    EXPECT_NEAR(Sum(trace, "RemovedVolume"), expected, 0.01 * expected) << label;
  }
}

/// A hole through several labels costs the sum of U over the removed samples, which the test
/// computes from the remaining fractions. The label image has a different spacing and origin.
TEST_F(FilterBurr, AHoleThroughSeveralLabelsCostsTheSumOfTheirEnergies)
{
  constexpr double spacing = 0.7; // mm, of the label image
  SetConstant(this->Burr->GetSpecificEnergy(), 0.8);
  this->Burr->SetFriction(0.25);
  this->Burr->SetSpeed(30000.0);
  const auto labels = MakeImage(40, VTK_SHORT,
    [](const Point& x) { return x[0] + 0.3 * x[1] < 15.2 ? 2.0 : (x[2] < 10.5 ? 7.0 : 3.0); });
  labels->SetSpacing(spacing, spacing, spacing);
  labels->SetOrigin(-0.4, -0.2, -1.3);
  vtkNew<vtkHapticLabelTable> table;
  table->SetSpecificEnergy(2, 0.3);
  table->SetSpecificEnergy(3, 2.4);
  this->Filter->SetLabelTable(table);
  this->Filter->SetLabelData(labels);
  vtkPolyData* const trace = this->Follow(Plunge(4.0, 4000));
  const double work = 0.25 * 2.0 * BurrPi * 3e-3 * 500.0 * 1e-3 * Sum(trace, "NormalForce"); // J
  ASSERT_TRUE(this->Filter->GetRemoval()->ReadTrace(trace));
  vtkNew<vtkImageData> shares;
  this->Filter->GetRemoval()->MakeShares(shares);
  const double energies[] = { 0.3, 2.4, 0.8 };
  double volumes[3] = {};
  for (vtkIdType i = 0; i < shares->GetNumberOfPoints(); ++i)
  {
    const double rho = shares->GetPointData()->GetScalars()->GetTuple1(i) / 255.0;
    double place[3];
    shares->GetPoint(i, place);
    if (rho == 1.0 || this->Image->GetPointData()->GetScalars()->GetTuple1(i) < 100.0)
    {
      continue;
    }
    int index[3];
    for (int a = 0; a < 3; ++a)
    {
      index[a] = static_cast<int>(std::lround((place[a] - labels->GetOrigin()[a]) / spacing));
    }
    const double label = labels->GetScalarComponentAsDouble(index[0], index[1], index[2], 0);
    // The removed volume of a voxel rises from none to all of it while the remaining fraction rho
    // falls from 7/12 to 5/12.
    volumes[label == 2.0 ? 0 : (label == 3.0 ? 1 : 2)] +=
      std::pow(BurrVoxel, 3) * (1.0 - std::clamp(6.0 * (rho - 0.5) + 0.5, 0.0, 1.0));
  }
  double expected = 0.0;
  for (int label = 0; label < 3; ++label)
  {
    EXPECT_GT(volumes[label], 0.2) << "mm^3 of label " << label;
    expected += volumes[label] * energies[label];
  }
  EXPECT_NEAR(work, expected, 0.02 * expected);
  EXPECT_NEAR(Sum(trace, "RemovedVolume"), volumes[0] + volumes[1] + volumes[2],
    1e-6 * (volumes[0] + volumes[1] + volumes[2]));
}

/// Q is inversely proportional to the energy: three times the energy removes a third of the volume
/// at the same force. A burr that does not spin removes nothing. The energy left over at the end is
/// small compared with that of the long stroke.
TEST_F(FilterBurr, DenseTissueIsRemovedMoreSlowly)
{
  double rates[2] = {};
  for (const double energy : { 20.0, 60.0 })
  {
    SetConstant(this->Burr->GetSpecificEnergy(), energy);
    vtkPolyData* const trace = this->Follow(Plunge(2.0, 16000));
    rates[energy > 40.0] = Sum(trace, "RemovedVolume") / Sum(trace, "NormalForce");
  }
  EXPECT_NEAR(rates[0] / rates[1], 3.0, 0.05);
  this->Burr->SetSpeed(0.0);
  EXPECT_EQ(Sum(this->Follow(Plunge(2.0, 1000)), "RemovedVolume"), 0.0);
}

/// Case B2: without the tool, the point touches the sides of the hole, which has the burr's radius
/// of 3 mm.
TEST_F(FilterBurr, ItsHoleIsFeltWithThePoint)
{
  SetConstant(this->Burr->GetSpecificEnergy(), 0.05);
  const std::vector<Point> plunge = Plunge(5.5, 5000);
  vtkPolyData* const trace = this->Follow(plunge);
  EXPECT_GT(trace->GetPoint(4999)[2] + 3.0 - Surface, 4.8) << "the depth of the hole";
  ASSERT_TRUE(this->Filter->GetRemoval()->IsEmpty()) << "paths leave the hand's volume alone";
  ASSERT_TRUE(this->Filter->GetRemoval()->ReadTrace(trace));
  EXPECT_FALSE(this->Filter->GetRemoval()->IsEmpty());
  this->Filter->SetTool(nullptr);
  SetConstant(this->Property->GetSurfaceStrength(), 1e4);
  vtkPiecewiseFunction* const distinctness = this->Property->GetDistinctness();
  distinctness->RemoveAllPoints();
  distinctness->AddPoint(80.0, 0.0);
  distinctness->AddPoint(400.0, 1.0);
  for (int i = 0; i < 12; ++i)
  {
    const double x = std::cos(BurrPi * i / 6.0);
    const double y = std::sin(BurrPi * i / 6.0);
    const Point axis{ 8.0, 7.9, Surface + 1.5 };
    vtkPolyData* const felt =
      this->Follow(Line(axis, { 8.0 + 3.6 * x, 7.9 + 3.6 * y, axis[2] }, 144));
    const double* const proxy = felt->GetPoint(144);
    EXPECT_NEAR(std::hypot(proxy[0] - 8.0, proxy[1] - 7.9), 3.0, 0.1 * BurrVoxel) << i;
    EXPECT_GT(Get(felt, "NormalForce", 144), 0.2);
    EXPECT_FALSE(felt->GetPointData()->HasArray("RemovedVolume"));
  }
}

TEST_F(FilterBurr, EachPathRemovesByItself)
{
  const std::vector<Point> left = Plunge(2.0, 600, 6.0);
  const std::vector<Point> right = Plunge(2.5, 700, 7.0);
  const vtkSmartPointer<vtkPolyData> first = (this->Follow(left), Keep(this->Filter));
  const vtkSmartPointer<vtkPolyData> second = (this->Follow(right), Keep(this->Filter));
  EXPECT_TRUE(first->GetFieldData()->HasArray("FinalShares"));
  std::vector<Point> all = left;
  all.insert(all.end(), right.begin(), right.end());
  this->Path = MakePath(all);
  vtkNew<vtkCellArray> lines;
  vtkIdType next = 0;
  for (const std::size_t size : { left.size(), right.size() })
  {
    lines->InsertNextCell(static_cast<int>(size));
    for (std::size_t i = 0; i < size; ++i)
    {
      lines->InsertCellPoint(next++);
    }
  }
  this->Path->SetLines(lines);
  this->Filter->SetPathData(this->Path);
  vtkPolyData* const both = this->Run(static_cast<vtkIdType>(all.size()));
  EXPECT_FALSE(both->GetFieldData()->HasArray("FinalShares")) << "whose would they be?";
  for (vtkIdType i = 0; i < both->GetNumberOfPoints(); ++i)
  {
    const bool isFirst = i < first->GetNumberOfPoints();
    vtkPolyData* const one = isFirst ? first : second;
    const vtkIdType tick = isFirst ? i : i - first->GetNumberOfPoints();
    for (const char* const array : { "RemovedVolume", "NormalForce", "Value" })
    {
      ASSERT_EQ(Get(both, array, i), Get(one, array, tick)) << array << " " << i;
    }
  }
  EXPECT_GT(Sum(second, "RemovedVolume"), 0.1);
}

TEST_F(FilterBurr, SpinsAsThePathSays)
{
  this->Follow(Plunge(2.0, 800));
  vtkNew<vtkDoubleArray> spinning;
  spinning->SetName("Spinning");
  for (int i = 0; i < 800; ++i)
  {
    spinning->InsertNextValue(i < 600 ? 0.0 : 1.0);
  }
  this->Path->GetPointData()->AddArray(spinning);
  this->Filter->SetPathData(this->Path);
  this->Filter->Modified();
  vtkPolyData* const trace = this->Run(800);
  for (vtkIdType i = 0; i < 600; ++i)
  {
    ASSERT_EQ(Get(trace, "RemovedVolume", i), 0.0);
  }
  EXPECT_GT(Get(trace, "NormalForce", 500), 0.1);
  EXPECT_GT(Sum(trace, "RemovedVolume"), 0.01);
  spinning->SetValue(5, 0.5);
  this->Filter->Modified();
  this->ExpectError({ "Spinning", "port 1", "1 or a 0" });
}

TEST_F(FilterBurr, WhatItCannotDoIsAnErrorWithItsCure)
{
  this->Follow(Plunge(0.5, 10));
  this->Burr->SetRadius(0.2);
  this->ExpectError({ "Radius", "vtkHapticBurr", "voxel", "SetRadius" });
  this->Burr->SetRadius(3.0);
  this->Burr->SetContactArea(0.0);
  this->ExpectError({ "ContactArea", "vtkHapticBurr", "SetContactArea" });
  this->Burr->SetContactArea(0.1);
  SetConstant(this->Burr->GetSpecificEnergy(), -1.0);
  this->ExpectError({ "SpecificEnergy", "vtkHapticBurr", "J/mm^3", "GetSpecificEnergy" });
  this->Burr->SetSpecificEnergy(nullptr);
  this->Burr->SetSolidToFromStrength();
  this->ExpectError({ "vtkHapticBurr", "solid", "SetContactValue" });
  this->Burr->SetSolidToAbove();
  this->Filter->SetMethodToForceField();
  this->ExpectError({ "vtkHapticBurr", "PROXY", "SetTool(nullptr)" });
  this->Filter->SetMethodToProxy();
  vtkNew<TimeSource> source;
  source->Steps = { 0.0, 1.0 };
  source->Make = [this](double) { return this->Image; };
  this->Filter->SetInputConnection(source->GetOutputPort());
  this->ExpectError({ "vtkHapticBurr", "volume that moves", "SetTimeUnitsPerSecond(0)" });
  this->Filter->SetTimeUnitsPerSecond(0.0);
  this->Run(10);
}
