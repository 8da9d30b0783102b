// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arcs.h"

#include "Shapes.h"
#include "SmoothedVolume.h"

#include "vtkImageData.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace evaluation
{
namespace
{
constexpr double TickStep = 0.05;  // mm per tick: 50 mm/s
constexpr double Smoothing = 5.0;  // mm: scale of the smoothing of an arc's course
constexpr double Backing = 4.0;    // mm of tissue behind a surface
constexpr double Clearance = 2.0;  // mm of air behind a surface, seen from inside
constexpr double Leap = 0.5;       // mm: largest distance between neighbours of an arc
constexpr double Shortest = 30.0;  // mm, shorter arcs are discarded
constexpr double Above = 10.0;     // mm above the surface: start of the hand
constexpr double SearchStep = 0.5; // mm, along a ray

using ValueAt = std::function<double(double)>; // value by radius (mm)

/** Returns the distance (mm) from a position in a box to the box's border along a ray. */
double ComputeReach(const Vector3& from, const Vector3& way, const double* box)
{
  const double position[3] = { from.X, from.Y, from.Z };
  const double direction[3] = { way.X, way.Y, way.Z };
  double reach = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double wall = direction[axis] > 0.0 ? box[2 * axis + 1] : box[2 * axis];
    if (std::abs(direction[axis]) > 1e-9)
    {
      reach = std::min(reach, (wall - position[axis]) / direction[axis]);
    }
  }
  return reach;
}

/**
 * Returns the radius at which the value crosses a level, between a radius inside and one outside.
 */
double Bisect(const ValueAt& value, double level, double inside, double outside)
{
  for (int i = 0; i < 20; ++i)
  {
    const double between = 0.5 * (inside + outside);
    (value(between) < level ? outside : inside) = between;
  }
  return inside;
}

std::optional<double> FindOutermost(const ValueAt& value, double level, double reach)
{
  for (double radius = reach - SearchStep; radius > Backing; radius -= SearchStep)
  {
    if (value(radius) < level)
    {
      continue;
    }
    double below = radius;
    while (below > radius - Backing && value(below) >= level)
    {
      below -= SearchStep;
    }
    if (below <= radius - Backing)
    {
      return Bisect(value, level, radius, radius + SearchStep);
    }
    radius = below; // the layer is too thin
  }
  return {};
}

std::optional<double> FindFromInside(const ValueAt& value, double level, double reach)
{
  for (double radius = Backing; radius < reach - Clearance; radius += SearchStep)
  {
    double beyond = radius;
    while (beyond < radius + Clearance && value(beyond) < level)
    {
      beyond += SearchStep;
    }
    if (beyond >= radius + Clearance)
    {
      return Bisect(value, level, radius - SearchStep, radius);
    }
    radius = beyond;
  }
  return {};
}

/** Smooths values with a Gaussian; the end values are repeated beyond the ends. */
std::vector<double> Smooth(const std::vector<double>& values, double scale)
{
  const int reach = static_cast<int>(4.0 * scale);
  const int last = static_cast<int>(values.size()) - 1;
  std::vector<double> smooth(values.size());
  for (int i = 0; i <= last; ++i)
  {
    double sum = 0.0;
    double weights = 0.0;
    for (int j = -reach; j <= reach; ++j)
    {
      const double w = std::exp(-0.5 * j * j / (scale * scale));
      sum += w * values[std::clamp(i + j, 0, last)];
      weights += w;
    }
    smooth[i] = sum / weights;
  }
  return smooth;
}

/**
 * Makes an arc from a run of radii, without the ends, which can't be smoothed from both sides.
 * Returns nothing if the run is too short.
 */
std::optional<Arc> MakeArc(const std::vector<double>& radii, const std::vector<Vector3>& outs,
  const Vector3& middle, double beyond)
{
  const auto margin = static_cast<std::size_t>(2.0 * Smoothing / TickStep);
  if (static_cast<double>(radii.size()) * TickStep < Shortest + 4.0 * Smoothing)
  {
    return {};
  }
  const std::vector<double> course = Smooth(radii, Smoothing / TickStep);
  const auto tip = [&](std::size_t i, double depth)
  { return middle + (course[i] - depth) * outs[i]; };
  Arc arc;
  arc.Middle = middle;
  arc.Tips = { tip(margin, -Above) };
  MoveTo(arc.Tips, tip(margin, ArcDepth + beyond), TickStep);
  MoveTo(arc.Tips, tip(margin, ArcDepth), TickStep);
  arc.Pressed = arc.Tips.size();
  for (std::size_t i = margin; i < course.size() - margin; ++i)
  {
    arc.Tips.push_back(tip(i, ArcDepth));
  }
  return arc;
}

/** Searches one plane for arcs, and adds them. */
void FindArcsInPlane(const SmoothedVolume& smoothed, const double* box, const Course& course,
  const Vector3& middle, std::vector<Arc>& arcs)
{
  std::vector<double> radii;
  std::vector<Vector3> outs;
  const auto end = [&]()
  {
    if (const auto arc = MakeArc(radii, outs, middle, course.Beyond))
    {
      arcs.push_back(*arc);
    }
    radii.clear();
    outs.clear();
  };
  const double sector = course.LastAngle - course.FirstAngle;
  const int count = static_cast<int>(sector * course.Radius / TickStep);
  for (int i = 0; i < count; ++i)
  {
    const double angle = course.FirstAngle + sector * i / count;
    const Vector3 out = std::cos(angle) * course.Side + std::sin(angle) * course.Up;
    const double reach = ComputeReach(middle, out, box);
    const ValueAt value = [&](double radius) { return smoothed.Value(middle + radius * out); };
    const auto radius = course.IsSeenFromInside ? FindFromInside(value, course.Level, reach)
                                                : FindOutermost(value, course.Level, reach);
    if (!radius || (!radii.empty() && std::abs(*radius - radii.back()) > Leap))
    {
      end();
    }
    if (radius)
    {
      radii.push_back(*radius);
      outs.push_back(out);
    }
  }
  end();
}
} // namespace

Course AroundHead(vtkImageData* volume, double level, double beyond, const Effort& effort)
{
  double box[6];
  volume->GetBounds(box);
  Course course;
  course.Level = level;
  course.Beyond = beyond;
  const int heights = effort.Pick(2, 6);
  for (int height = 0; height < heights; ++height)
  {
    const double fraction = 0.6 + 0.25 * (height + 0.5) / heights;
    course.Middles.push_back(
      { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), box[4] + fraction * (box[5] - box[4]) });
  }
  return course;
}

std::vector<Arc> FindArcs(vtkImageData* volume, const Course& course)
{
  const SmoothedVolume smoothed(volume);
  std::vector<Arc> arcs;
  if (smoothed.IsValid())
  {
    double box[6];
    volume->GetBounds(box);
    for (const Vector3& middle : course.Middles)
    {
      FindArcsInPlane(smoothed, box, course, middle, arcs);
    }
  }
  return arcs;
}

} // namespace evaluation
