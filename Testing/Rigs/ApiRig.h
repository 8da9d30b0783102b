// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Runs a filter on a small volume with a path through it, and records the filter's messages. */
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

/// Records an object's errors and warnings, and suppresses their output.
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

/// Returns an image of n^3 voxels of 1 world unit, with its first sample at the origin. Its scalars
/// are named "Density".
vtkSmartPointer<vtkImageData> MakeImage(
  int n, int scalarType, const std::function<double(const Point&)>& value);

/// Returns an image with V = 100 z.
vtkSmartPointer<vtkImageData> MakeRamp(int n = 16, int scalarType = VTK_DOUBLE);

/// Returns a path with one point per tick. With `times` (s), the path has a point array "Time".
vtkSmartPointer<vtkPolyData> MakePath(
  const std::vector<Point>& points, const std::vector<double>& times = {});

/// Returns the points of a straight path from a to b, including both ends, in `steps` steps.
std::vector<Point> Line(const Point& a, const Point& b, int steps);

/// Replaces all points of the function by a single one, which makes it constant.
void SetConstant(vtkPiecewiseFunction* function, double value);

/// Returns an entry of a point array of the output. The test fails if the array does not exist.
double Get(vtkPolyData* output, const char* array, vtkIdType tick, int component = 0);

/// Returns whether the points, lines and point arrays of the first `ticks` ticks are bitwise equal.
/// -1 compares all ticks.
bool IsSame(vtkPolyData* a, vtkPolyData* b, vtkIdType ticks = -1);

/// Returns a copy of a filter's output that later updates do not change.
vtkSmartPointer<vtkPolyData> Keep(vtkVolumeHapticsFilter* filter);

/// Fixture with T1 of the specification: a path that pushes into the ramp from z = 5 mm to 10 mm in
/// 50 ticks.
class ApiTest : public testing::Test
{
protected:
  ApiTest();

  /// Updates the filter. Expects no message, and an output with `ticks` points. Returns the output.
  vtkPolyData* Run(vtkIdType ticks);
  /// Updates the filter. Expects one error that contains all these words, and an empty output.
  void ExpectError(const std::vector<std::string>& words);

  vtkSmartPointer<vtkImageData> Image = MakeRamp();
  vtkSmartPointer<vtkPolyData> Path = MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 50));
  vtkNew<vtkVolumeHapticsFilter> Filter;
  vtkHapticProperty* const Property = this->Filter->GetProperty();
  MessageLog Log{ this->Filter };
  /// Suppresses the error that VTK's executive adds when a filter fails.
  MessageLog ExecutiveLog;
};
} // namespace apitest

#endif
