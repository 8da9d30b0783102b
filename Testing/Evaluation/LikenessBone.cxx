// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Likeness.h"
#include "Shapes.h"
#include "SmoothedVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <optional>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Length = 12.0;        // mm, of a stroke
constexpr double Step = 0.1;           // mm per tick
constexpr double PressStep = 0.02;     // mm per tick
constexpr double Depth = 1.5;          // mm below the surface
constexpr double LeastGradient = 40.0; // HU/mm, limit for distinct surfaces
constexpr double LongestJump = 0.5;    // mm of depth from one tick to the next

using Value = std::function<double(const Vector3&)>;

/**
 * Returns the distance (mm) along a direction at which the value first reaches a level, or nothing
 * if it is beyond the reach.
 */
std::optional<double> FindFirst(
  const Value& value, double level, const Vector3& from, const Vector3& way, double reach)
{
  constexpr double step = 0.5;
  for (double end = step; end < reach; end += step)
  {
    if (value(from + end * way) < level)
    {
      continue;
    }
    double low = end - step;
    double high = end;
    for (int i = 0; i < 30; ++i)
    {
      const double middle = 0.5 * (low + high);
      (value(from + middle * way) < level ? low : high) = middle;
    }
    return high;
  }
  return {};
}

/** Returns the parabola (a, b, c) that best fits heights that are one step apart. */
std::array<double, 3> FitParabola(const std::vector<double>& heights)
{
  double matrix[3][3] = {};
  double right[3] = {};
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    const double t = Step * static_cast<double>(i);
    const double powers[3] = { 1.0, t, t * t };
    for (int a = 0; a < 3; ++a)
    {
      right[a] += powers[a] * heights[i];
      for (int b = 0; b < 3; ++b)
      {
        matrix[a][b] += powers[a] * powers[b];
      }
    }
  }
  std::array<double, 3> solution;
  vtkMath::LinearSolve3x3(matrix, right, solution.data());
  return solution;
}

/**
 * Returns a stroke that presses in, and then follows the bone's overall course without its fine
 * relief.
 */
std::optional<Stroke> FindStroke(const SmoothedVolume& bone, const Value& value, double level,
  const Vector3& from, const Vector3& inward, double reach)
{
  const auto first = FindFirst(value, level, from, inward, reach);
  if (!first)
  {
    return {};
  }
  const Vector3 start = from + *first * inward;
  const Vector3 gradient = bone.Gradient(start);
  const Vector3 outward = (-1.0 / Norm(gradient)) * gradient;
  const Vector3 sideways = Cross(outward, { 0.0, 0.0, 1.0 });
  const Vector3 along = (1.0 / Norm(sideways)) * sideways;
  constexpr double above = 4.0;
  std::vector<double> heights;
  for (int i = 0; i <= static_cast<int>(Length / Step); ++i)
  {
    const Vector3 over = start + (Step * i) * along + above * outward;
    const auto depth = FindFirst(value, level, over, -1.0 * outward, 3.0 * above);
    if (!depth || Norm(bone.Gradient(over - *depth * outward)) < LeastGradient ||
      (i > 0 && std::abs(above - *depth - heights.back()) > LongestJump))
    {
      return {};
    }
    heights.push_back(above - *depth);
  }
  const auto [a, b, c] = FitParabola(heights);
  Stroke stroke{ start, outward, { start }, 0 };
  MoveTo(stroke.Tips, start + (a - Depth) * outward, PressStep);
  stroke.Pressed = stroke.Tips.size();
  for (std::size_t i = 1; i < heights.size(); ++i)
  {
    const double t = Step * static_cast<double>(i);
    stroke.Tips.push_back(start + t * along + (a + b * t + c * t * t - Depth) * outward);
  }
  return stroke;
}

/**
 * Returns strokes from directions that are spread evenly over the upper half (Fibonacci's lattice).
 */
std::vector<Stroke> FindStrokes(
  const SmoothedVolume& bone, const Value& value, double level, const double* bounds, int count)
{
  const Vector3 middle = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double radius =
    0.5 * Norm({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i)
  {
    const double up = 0.9 * (i + 0.5) / count;
    const double around = 2.399963229728653 * i;
    const double flat = std::sqrt(1.0 - up * up);
    const Vector3 out = { flat * std::cos(around), flat * std::sin(around), up };
    const auto stroke = FindStroke(bone, value, level, middle + radius * out, -1.0 * out, radius);
    if (stroke)
    {
      strokes.push_back(*stroke);
    }
  }
  return strokes;
}
} // namespace

std::vector<Subject> MakeBone(
  vtkImageData* volume, double isoValue, const Effort& effort, std::string& error)
{
  if (!volume || !volume->GetPointData()->GetScalars())
  {
    error = "There is no volume to stroke: name one with --volume.";
    return {};
  }
  double range[2];
  volume->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  if (!(isoValue > range[0] && isoValue < range[1]))
  {
    error = "The volume has no surface at the value " + Number(isoValue) +
      ": its scalars go from " + Number(range[0]) + " to " + Number(range[1]) +
      ". Name a volume in Hounsfield units with --volume.";
    return {};
  }
  const SmoothedVolume smoothed(volume);
  if (!smoothed.IsValid())
  {
    error = "The volume can't be touched: see the error above.";
    return {};
  }
  const int directions = effort.Pick(20, 200);
  std::vector<Subject> subjects;
  for (const bool isSmoothed : { false, true })
  {
    const Value value = [&](const Vector3& x)
    { return isSmoothed ? smoothed.Value(x) : smoothed.RawValue(x); };
    auto strokes = FindStrokes(smoothed, value, isoValue, volume->GetBounds(), directions);
    const std::string name = (isSmoothed ? "smoothed bone (" : "bone (") +
      std::to_string(strokes.size()) + " of " + std::to_string(directions) + " strokes)";
    subjects.push_back({ name,
      std::make_unique<Scene>(
        volume, isoValue, isSmoothed ? smoothed.ComputeSurface(isoValue).Get() : nullptr),
      std::move(strokes), isSmoothed ? smoothed.Off(isoValue) : smoothed.RawOff(isoValue) });
  }
  return subjects;
}

} // namespace evaluation
