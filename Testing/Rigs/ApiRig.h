// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A filter on a small volume with a path through it, which records all its messages. */
#ifndef ApiRig_h
#define ApiRig_h

#include <gtest/gtest.h>

#include <vtkCallbackCommand.h>
#include <vtkHapticProperty.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkWeakPointer.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace apitest
{
using Point = std::array<double, 3>;

/// Collects the errors and warnings of an object, instead of printing them.
class MessageLog
{
public:
  explicit MessageLog(vtkObject* watched);
  ~MessageLog();
  MessageLog(const MessageLog&) = delete;
  MessageLog& operator=(const MessageLog&) = delete;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  vtkWeakPointer<vtkObject> Watched;
  vtkNew<vtkCallbackCommand> Command;
};

/// Returns an image of n^3 voxels of 1 world unit, beginning at the origin, with scalars named
/// "Density".
vtkSmartPointer<vtkImageData> MakeImage(
  int n, int scalarType, const std::function<double(const Point&)>& value);

/// Returns the ramp V = 100 z.
vtkSmartPointer<vtkImageData> MakeRamp(int n = 16, int scalarType = VTK_DOUBLE);

/// Returns a path with one point per tick, or with `times` (s) in a point array "Time".
vtkSmartPointer<vtkPolyData> MakePath(
  const std::vector<Point>& points, const std::vector<double>& times = {});

/// Returns a path from a to b, both included, in `steps` steps.
std::vector<Point> Line(const Point& a, const Point& b, int steps);

/// Makes a function constant: removes all points and adds one.
void SetConstant(vtkPiecewiseFunction* function, double value);

/// Returns an entry of an output's point array; fails the test if there is no such array.
double Get(vtkPolyData* output, const char* array, vtkIdType tick, int component = 0);

/// Returns whether points, lines and all point arrays of the first `ticks` ticks (-1: all) are
/// equal to the bit.
bool IsSame(vtkPolyData* a, vtkPolyData* b, vtkIdType ticks = -1);

/// Returns a copy of a filter's output that outlives the next update.
vtkSmartPointer<vtkPolyData> Keep(vtkVolumeHapticsFilter* filter);

/// The ramp, pushed 5 mm along z from z = 5 in 50 ticks: T1 of the specification.
class ApiTest : public testing::Test
{
protected:
  ApiTest();

  /// Updates, expecting no message and `ticks` points; returns the output.
  vtkPolyData* Run(vtkIdType ticks);
  /// Updates, expecting one error with all these words in it, and an empty output.
  void ExpectError(const std::vector<std::string>& words);

  vtkSmartPointer<vtkImageData> Image = MakeRamp();
  vtkSmartPointer<vtkPolyData> Path = MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 50));
  vtkNew<vtkVolumeHapticsFilter> Filter;
  vtkHapticProperty* const Property = this->Filter->GetProperty();
  MessageLog Log{ this->Filter };
  /// If a filter fails, VTK's executive also reports an error. It is ignored.
  MessageLog ExecutiveLog;
};
} // namespace apitest

#endif
