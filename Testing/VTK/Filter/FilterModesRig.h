// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fixture with a filter that has modes, on an image with 24 voxels along each axis.
 */
#ifndef FilterModesRig_h
#define FilterModesRig_h

#include "Rigs/ApiRig.h"

#include <vtkDoubleArray.h>
#include <vtkHapticMode.h>
#include <vtkPointData.h>

#include <cmath>

namespace modestest
{
using namespace apitest;

inline constexpr double SpringOf = 500.0;  // N/m, coupling stiffness
inline constexpr double SpringPerMm = 0.5; // N/mm, coupling stiffness
inline constexpr double Middle = 11.5;     // index of the centre of 24 voxels

class FilterModes : public ApiTest
{
protected:
  FilterModes()
  {
    this->Image = MakeImage(24, VTK_DOUBLE, [](const Point& p) { return 100.0 * p[2]; });
    this->Filter->SetInputData(this->Image);
    this->Filter->SetMethodToPrimitives();
  }

  template <typename F>
  vtkSmartPointer<vtkDoubleArray> AddArray(const char* name, int components, F&& f)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->Image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
    {
      Point p;
      this->Image->GetPoint(i, p.data());
      f(p, array->GetPointer(components * i));
    }
    this->Image->GetPointData()->AddArray(array);
    return array;
  }
  /// Adds the flow v = (x - 11.5), rotated by 90 degrees about z, whose lines are circles.
  void AddCircles()
  {
    this->AddArray("flow", 3,
      [](const Point& p, double* v)
      {
        v[0] = Middle - p[1];
        v[1] = p[0] - Middle;
        v[2] = 0.0;
      });
  }

  void Follow(const std::vector<Point>& points) { this->Filter->SetPathData(MakePath(points)); }

  /// Returns an array's vector at the last tick.
  static Point Last(vtkPolyData* trace, const char* array)
  {
    const vtkIdType tick = trace->GetNumberOfPoints() - 1;
    return { Get(trace, array, tick, 0), Get(trace, array, tick, 1), Get(trace, array, tick, 2) };
  }
  static Point LastProxy(vtkPolyData* trace)
  {
    Point p;
    trace->GetPoint(trace->GetNumberOfPoints() - 1, p.data());
    return p;
  }
  static void ExpectNear(const Point& a, const Point& b, double tolerance)
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
    }
  }
};

inline vtkSmartPointer<vtkHapticMode> NewMode(int kind, const char* array = "")
{
  auto mode = vtkSmartPointer<vtkHapticMode>::New();
  mode->SetKind(kind);
  mode->SetArrayName(array);
  return mode;
}
} // namespace modestest

#endif
