// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Presses.h"

#include "Shapes.h"

#include "Core/Model/HapticModel.h"

#include <algorithm>
#include <optional>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Far = 40.0;          // mm: path through air
constexpr double Deep = 5.0;          // mm, but at least LeastVoxels
constexpr double LeastVoxels = 3.0;   // voxels: reaches two voxels behind a surface
constexpr double PressStep = 0.1;     // mm per tick
constexpr double LeastCosine = 0.707; // between a ray and the normal
constexpr double RayStep = 0.25;      // voxels between samples along a ray
constexpr double Persistence = 0.75;  // voxels: least thickness of a surface
constexpr double FarAstray = 2.0;     // voxels from the isosurface
constexpr double LeastBehind = 0.25;  // mm behind an edge: FeltForce of a spring of 400 N/m

/** A ray through the volume, in world coordinates. */
struct Ray
{
  Vector3 Start;
  Vector3 Way;   ///< unit
  double Length; ///< length of the part that may be in the volume
  double Unit;   ///< length of a voxel along the ray
  Vector3 At(double t) const { return this->Start + t * this->Way; }
};

/** The place where a ray meets the surface. */
struct Meeting
{
  double At;      ///< position along the ray
  double Start;   ///< along the ray: the hand's start, in front of everything visible
  Vector3 Normal; ///< unit, inwards
};

/** Returns point i of a sequence that fills the unit cube evenly (Roberts' R3). */
Vector3 PointOf(int i)
{
  const auto part = [i](double a) { return std::fmod(0.5 + a * (i + 1), 1.0); };
  return { part(0.8191725134), part(0.6710436067), part(0.5497004779) };
}

double ComputeUnit(const PressedVolume& volume, const Vector3& way)
{
  const Vector3& v = volume.Voxel;
  return 1.0 / Norm({ way.X / v.X, way.Y / v.Y, way.Z / v.Z });
}

/**
 * Returns ray i of `count` rays in evenly spread directions. Each ray passes the middle within a
 * third of the box.
 */
Ray MakeRay(const PressedVolume& volume, int i, int count)
{
  const double z = 1.0 - 2.0 * (i + 0.5) / count;
  const double angle = 2.399963229728653 * i; // the golden angle
  const double r = std::sqrt(1.0 - z * z);
  const Vector3 way = { r * std::cos(angle), r * std::sin(angle), z };
  const auto& b = volume.Box;
  const Vector3 size = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  const Vector3 fraction = PointOf(i) - Vector3{ 0.5, 0.5, 0.5 };
  const Vector3 by = volume.Middle +
    (2.0 / 3.0) * Vector3{ fraction.X * size.X, fraction.Y * size.Y, fraction.Z * size.Z };
  const double reach = Norm(size);
  return { by - reach * way, way, 2.0 * reach, ComputeUnit(volume, way) };
}

/** Returns the smoothed value at a position; nothing outside of the volume. */
std::optional<double> ValueAt(const PressedVolume& volume, const Vector3& world)
{
  const Vector3 index = volume.Shape->DeviceToIndex(0.001 * volume.Scale * world);
  if (!volume.Shape->Baked->Field.IsInside(index))
  {
    return {};
  }
  return volume.Shape->Baked->Field.Gradient(index).Value;
}

/**
 * Returns whether the nearest position in the volume is solid. A body at the border is assumed to
 * continue beyond it.
 */
bool IsSolidBeyond(const PressedVolume& volume, const Vector3& world)
{
  const auto& field = volume.Shape->Baked->Field;
  const Vector3 index = volume.Shape->DeviceToIndex(0.001 * volume.Scale * world);
  return field.Gradient(field.Nearest(index)).Value >= volume.Level;
}

std::optional<Meeting> FindMeeting(const PressedVolume& volume, const Ray& ray)
{
  const double step = RayStep * ray.Unit;
  const auto isIn = [&](double t)
  {
    const auto value = ValueAt(volume, ray.At(t));
    return value && *value >= volume.Level;
  };
  double entry = 0.0;
  while (entry < ray.Length && !ValueAt(volume, ray.At(entry)))
  {
    entry += step;
  }
  double t = entry;
  for (double since = -1.0; t < ray.Length; t += step)
  {
    since = !isIn(t) ? -1.0 : since < 0.0 ? t : since;
    if (since >= 0.0 && t - since >= Persistence * ray.Unit)
    {
      t = since;
      break;
    }
  }
  if (t >= ray.Length || t - entry < ray.Unit)
  {
    return {};
  }
  double out = t - step;
  for (int i = 0; i < 20; ++i)
  {
    const double between = 0.5 * (out + t);
    (isIn(between) ? t : out) = between;
  }
  const double start = std::max(0.0, std::min(t - Far / volume.Scale, entry - ray.Unit));
  for (double at = start; at < entry; at += step)
  {
    if (IsSolidBeyond(volume, ray.At(at)))
    {
      return {};
    }
  }
  const auto inwards = ComputeInwards(volume, volume.Scale * ray.At(t));
  if (!inwards || Dot(*inwards, ray.Way) < LeastCosine)
  {
    return {};
  }
  return Meeting{ t, start, *inwards };
}

/**
 * Returns the position along the ray at which half of the opacity is reached, or nothing if the ray
 * meets no opacity.
 */
std::optional<double> MeasureHalfOpacity(const PressedVolume& volume, const Ray& ray)
{
  const double step = RayStep * ray.Unit;
  std::vector<double> opacity; // in front of the end of each step
  double depth = 0.0;
  for (double t = 0.5 * step; t < ray.Length; t += step)
  {
    depth += volume.Extinction(ray.At(t)) * step;
    opacity.push_back(1.0 - std::exp(-depth));
  }
  if (opacity.empty() || opacity.back() <= 0.0)
  {
    return {};
  }
  const double half = 0.5 * opacity.back();
  const auto at = std::lower_bound(opacity.begin(), opacity.end(), half);
  const double before = at == opacity.begin() ? 0.0 : *(at - 1);
  return step *
    (static_cast<double>(at - opacity.begin()) + (half - before) / std::max(*at - before, 1e-300));
}

/**
 * Returns whether the isosurface of a level is more than FarAstray away from a position (m in the
 * hand's space).
 */
bool IsAstray(const HapticModel& structures, double level, const Vector3& place)
{
  constexpr double step = 0.25;
  const int reach = static_cast<int>(FarAstray / step);
  const auto& field = structures.Baked->Field;
  const Vector3 index = structures.DeviceToIndex(place);
  bool isIn = false;
  bool isOut = false;
  for (int k = -reach; k <= reach; ++k)
  {
    for (int j = -reach; j <= reach; ++j)
    {
      for (int i = -reach; i <= reach; ++i)
      {
        const Vector3 offset = step * Vector3{ double(i), double(j), double(k) };
        if (Norm(offset) <= FarAstray && field.IsInside(index + offset))
        {
          const bool isAbove = field.Value(index + offset) >= level;
          isIn = isIn || isAbove;
          isOut = isOut || !isAbove;
        }
      }
    }
  }
  return !isIn || !isOut;
}

/**
 * Returns how far (mm along the normal) a press is behind the middle of an edge. Behind the middle,
 * the second derivative along the gradient of the smoothed values is negative (Marr and Hildreth,
 * Proceedings of the Royal Society B 207, 1980).
 */
double MeasureBehindEdge(const PressedVolume& volume, const Ray& ray, double from, double deep)
{
  constexpr double step = 0.05; // mm
  const HapticModel& shape = *volume.Shape;
  double run = 0.0;
  double deepest = 0.0;
  for (double t = from; t <= deep; t += step)
  {
    const Vector3 at = volume.Scale * ray.At(t / volume.Scale);
    const auto inwards = ComputeInwards(volume, at);
    if (!inwards)
    {
      continue;
    }
    const Vector3 index = shape.DeviceToIndex(0.001 * at);
    const Vector3 along = shape.DeviceToIndex(0.001 * (at + *inwards)) - index;
    const Vector3 voxel = (1.0 / Norm(along)) * along;
    const auto value = [&](const Vector3& i) { return shape.Baked->Field.Gradient(i).Value; };
    const double bend = value(index + voxel) + value(index - voxel) - 2.0 * value(index);
    run = bend < 0.0 ? run + step * Dot(*inwards, ray.Way) : 0.0;
    deepest = std::max(deepest, run);
  }
  return deepest;
}

void Press(const PressedVolume& volume, const Ray& ray, const Meeting& met, Presses& found)
{
  const Vector3 surface = volume.Scale * ray.At(met.At); // mm in the hand's space
  const double voxel = volume.Scale * ray.Unit;
  const double deep = std::max(Deep, LeastVoxels * voxel);
  Path tips = { volume.Scale * ray.At(met.Start) };
  MoveTo(tips, surface + deep * ray.Way, PressStep);
  const std::size_t pressed = tips.size();
  MoveTo(tips, surface - deep * ray.Way, PressStep);
  const Trace trace = Play(*volume.Model, tips);
  const auto findFirst = [&](double force)
  {
    const auto end = trace.begin() + static_cast<std::ptrdiff_t>(std::min(pressed, trace.size()));
    const auto at = std::find_if(
      trace.begin(), end, [=](const TickRecord& tick) { return Norm(tick.Force) >= force; });
    return at == end ? std::nullopt : std::optional<Vector3>(ProxyOf(*at));
  };
  const std::optional<Vector3> felt = findFirst(FeltForce);
  const std::optional<Vector3> touched = findFirst(TouchedForce);
  ++found.Count;
  const auto half = MeasureHalfOpacity(volume, ray);
  const Vector3 seen = half ? volume.Scale * ray.At(*half) : Vector3{};
  if (half && touched)
  {
    found.OffSeenTouched.push_back(Dot(seen - *touched, ray.Way) / voxel);
  }
  for (std::size_t i = 0; i < trace.size(); ++i)
  {
    if (i > 0)
    {
      found.LargestStep = std::max(found.LargestStep, Norm(trace[i].Force - trace[i - 1].Force));
    }
  }
  if (!felt)
  {
    ++found.Unfelt;
    found.UnfeltThoughSeen += half && *half <= met.At + FarAstray * ray.Unit ? 1 : 0;
    const double at = volume.Scale * met.At;
    found.UnfeltBehindEdge +=
      MeasureBehindEdge(volume, ray, at - voxel, at + deep) >= LeastBehind ? 1 : 0;
    return;
  }
  // Outside of the volume, values are those of its border: there is drag, but no surface.
  if (!volume.Shape->Baked->Field.IsInside(volume.Shape->DeviceToIndex(0.001 * *felt)))
  {
    return;
  }
  found.OffSurface.push_back(Dot(*felt - surface, met.Normal) / voxel);
  if (IsAstray(*volume.Structures, volume.Level, 0.001 * *felt))
  {
    ++found.Astray;
    found.AstrayOfHeld += IsAstray(*volume.Held, volume.HeldLevel, 0.001 * *felt) ? 1 : 0;
  }
  if (half)
  {
    found.OffSeen.push_back(Dot(seen - *felt, ray.Way) / voxel);
    const auto inwards = ComputeInwards(volume, seen);
    if (inwards && Dot(*inwards, ray.Way) >= LeastCosine)
    {
      found.OffSeenStraight.push_back(found.OffSeen.back());
    }
  }
}
} // namespace

Presses PressFromAllSides(const PressedVolume& volume, int rays)
{
  Presses found;
  for (int i = 0; i < rays; ++i)
  {
    const Ray ray = MakeRay(volume, i, rays);
    if (const auto met = FindMeeting(volume, ray))
    {
      Press(volume, ray, *met, found);
    }
  }
  return found;
}

Steps WalkAtRandom(const PressedVolume& pressed, int walks, double stiffest)
{
  constexpr int length = 3000;     // ticks of a walk at full speed
  constexpr double usual = 400.0;  // N/m, walks are slower in stiffer material
  constexpr double release = 0.25; // N, largest step of a release
  constexpr double noLeap = 0.02;  // N, beyond the change by the step (Documentation/method.md)
  const double pace = std::min(1.0, usual / std::max(stiffest, 1.0));
  Steps found;
  const auto& b = pressed.Box;
  const double sizes[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  for (int walk = 0; walk < walks; ++walk)
  {
    Path tips;
    for (int tick = 0; tick < length / pace; ++tick)
    {
      double x[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        // Limit the speed of each of the two oscillations to 0.13 m/s along each axis.
        const double swing = 0.25 * sizes[axis];
        const double fast = 130.0 / (pressed.Scale * swing);
        const double slow = fast * (0.3 + 0.08 * std::fmod(0.618 * (3 * walk + axis), 1.0));
        x[axis] = b[2 * axis] + 0.5 * sizes[axis] +
          swing *
            (std::sin(1e-3 * pace * fast * tick + walk + 2.0 * axis) +
              std::sin(1e-3 * pace * slow * tick + 1.7 * walk + axis));
      }
      tips.push_back(pressed.Scale * Vector3{ x[0], x[1], x[2] });
    }
    const Trace trace = Play(*pressed.Model, tips);
    for (std::size_t i = 1; i < trace.size(); ++i)
    {
      const TickRecord& before = trace[i - 1];
      const TickRecord& now = trace[i];
      const double step = Norm(now.Force - before.Force);
      const double own = std::max(before.Stiffness, now.Stiffness) *
        std::hypot(1.0, std::max(before.Friction, now.Friction)) * Norm(now.Tip - before.Tip);
      found.Largest = std::max(found.Largest, step);
      found.Beyond = std::max(found.Beyond, step - std::max(release, own + noLeap));
      found.BeyondSpring = std::max(found.BeyondSpring,
        step - std::max(before.Stiffness, now.Stiffness) * Norm(now.Tip - before.Tip));
    }
  }
  return found;
}

std::optional<Vector3> ComputeInwards(const PressedVolume& volume, const Vector3& at)
{
  const Vector3 index = volume.Shape->DeviceToIndex(0.001 * at);
  const Vector3 gradient =
    volume.Shape->GradientToDevice * volume.Shape->Baked->Field.Gradient(index).Gradient;
  const double size = Norm(gradient);
  return size > 0.0 ? std::optional<Vector3>((1.0 / size) * gradient) : std::nullopt;
}

std::optional<double> MeasureSeenBehind(
  const PressedVolume& volume, const Vector3& felt, const Vector3& way)
{
  constexpr double before = 10.0; // mm from the eye to the place
  constexpr double reach = 50.0;  // mm that the eye sees
  const double scale = 1.0 / volume.Scale;
  const Ray ray{ scale * (felt - before * way), way, scale * reach, ComputeUnit(volume, way) };
  const auto half = MeasureHalfOpacity(volume, ray);
  return half ? std::optional<double>((*half - scale * before) / ray.Unit) : std::nullopt;
}

double FindLargest(std::vector<double> values, double fraction)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::transform(
    values.begin(), values.end(), values.begin(), [](double value) { return std::abs(value); });
  const auto at = values.begin() +
    static_cast<std::ptrdiff_t>(
      std::floor(fraction * static_cast<double>(values.size() - 1) + 0.5));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double ComputeMedian(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

} // namespace evaluation
