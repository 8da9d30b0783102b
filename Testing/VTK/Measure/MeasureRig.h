// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture for a list of measurements whose messages are recorded, with comparisons of lists. */
#ifndef MeasureRig_h
#define MeasureRig_h

#include "Rigs/ApiRig.h"
#include "Rigs/TemporaryFolder.h"

#include <vtkDoubleArray.h>
#include <vtkHapticMeasurements.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace measuretest
{
using namespace apitest;

inline std::string File(const std::string& name)
{
  return TemporaryPath(name);
}

inline std::string WriteTextFile(const std::string& name, const std::string& text)
{
  std::ofstream(File(name), std::ios::binary) << text;
  return File(name);
}

/// Makes touched points 1 ms apart, each with a force along z and a value.
inline vtkSmartPointer<vtkPolyData> MakeFelt(const std::vector<Point>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  vtkNew<vtkDoubleArray> forces;
  forces->SetName("Force");
  forces->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> values;
  values->SetName("SurfaceValue");
  for (const Point& position : positions)
  {
    const auto i = static_cast<double>(points->GetNumberOfPoints());
    points->InsertNextPoint(position.data());
    times->InsertNextValue(1.0 + 0.001 * i);
    forces->InsertNextTuple3(0.1 * i, -0.2, 1.0 / 3.0);
    values->InsertNextValue(53.0 + i);
  }
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->GetPointData()->AddArray(times);
  shape->GetPointData()->AddArray(forces);
  shape->GetPointData()->AddArray(values);
  return shape;
}

inline void ExpectSameArray(vtkPolyData* a, vtkPolyData* b, const char* name)
{
  vtkDataArray* const first = a->GetPointData()->GetArray(name);
  vtkDataArray* const second = b->GetPointData()->GetArray(name);
  ASSERT_EQ(first == nullptr, second == nullptr) << name;
  for (vtkIdType i = 0; first && i < first->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < first->GetNumberOfComponents(); ++c)
    {
      const double x = first->GetComponent(i, c);
      const double y = second->GetComponent(i, c);
      EXPECT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << name << " " << x << " " << y;
    }
  }
}

/// Expects two lists with bitwise identical names, kinds, values, points, cells and arrays of
/// touched points.
inline void ExpectSame(vtkHapticMeasurements* a, vtkHapticMeasurements* b)
{
  ASSERT_EQ(a->GetNumberOfMeasurements(), b->GetNumberOfMeasurements());
  for (vtkIdType i = 0; i < a->GetNumberOfMeasurements(); ++i)
  {
    SCOPED_TRACE(a->GetText(i));
    EXPECT_EQ(a->GetName(i), b->GetName(i));
    EXPECT_EQ(a->GetKind(i), b->GetKind(i));
    EXPECT_EQ(a->GetText(i), b->GetText(i));
    vtkNew<vtkPolyData> first;
    vtkNew<vtkPolyData> second;
    a->GetShape(i, first);
    b->GetShape(i, second);
    ASSERT_EQ(first->GetNumberOfCells(), second->GetNumberOfCells());
    if (a->GetKind(i) == vtkHapticMeasurements::AREA)
    {
      // Compare the corners by position, because a format may number them in another order.
      for (vtkIdType cell = 0; cell < first->GetNumberOfCells(); ++cell)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          double x[3];
          double y[3];
          first->GetPoint(first->GetCell(cell)->GetPointId(corner), x);
          second->GetPoint(second->GetCell(cell)->GetPointId(corner), y);
          EXPECT_TRUE(std::equal(x, x + 3, y)) << "cell " << cell;
        }
      }
      EXPECT_EQ(first->GetNumberOfPoints(), second->GetNumberOfPoints());
      continue;
    }
    EXPECT_TRUE(IsSame(first, second));
    for (const char* const name : { "Time", "Force", "SurfaceValue" })
    {
      ExpectSameArray(first, second, name);
    }
  }
}

class MeasureTest : public testing::Test
{
protected:
  /// Expects one error that contains all these words.
  void ExpectError(const std::vector<std::string>& words)
  {
    ASSERT_EQ(this->Log.Errors.size(), 1u);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->Log.Errors[0].find(word), std::string::npos)
        << word << " in " << this->Log.Errors[0];
    }
    this->Log.Errors.clear();
  }
  ~MeasureTest() override
  {
    EXPECT_TRUE(this->Log.Errors.empty()) << this->Log.Errors[0];
    EXPECT_TRUE(this->Log.Warnings.empty()) << this->Log.Warnings[0];
  }

  vtkNew<vtkHapticMeasurements> List;
  MessageLog Log{ this->List };
};
} // namespace measuretest

#endif
