// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseSurroundings.h"

#include "Core/Math/RootBracket.h"
#include "Core/Solvers/Precise/FarSide.h"
#include "Core/Solvers/Precise/PreciseSolver.h"

namespace VolumeHaptics
{
namespace
{

/** Share of the lag by which a motion may go too far. */
constexpr double Tolerance = 2e-4;
/** A smaller part of a direction is rounding. */
constexpr double SmallPart = 1e-3;
/** Trials of the search that draws a motion back. */
constexpr int MostTrials = 10;
/** The largest distance (voxels) from a proxy to its level. */
constexpr double FarthestLevel = 0.25;
/** At an edge, V(x_p) may be this share of |V(x_s) - V(x_v)| below their mean. */
constexpr double EdgeTolerance = 1e-3;
/** The share of the edge's height over which a graded edge gains its strength. */
constexpr double EdgeWidth = 0.5;
/** N; how steeply it gains it at the beginning, per share of EdgeWidth. */
constexpr double EdgeStrength = 20.0;

/** 1 if the proxy is at or past the middle of an edge, 0 if it is before. */
double AtEdge(const MaterialPoint& point, double value, bool isDescending) noexcept
{
  const double above = value - 0.5 * (point.SurfaceValue + point.MediumValue);
  const double width = EdgeTolerance * std::abs(point.SurfaceValue - point.MediumValue);
  const double share = 1.0 + (isDescending ? -above : above) / std::max(width, 1e-300);
  return std::clamp(share, 0.0, 1.0);
}

/**
 * The strength of a graded edge of height h:
 *
 *   T' = min(T, EdgeStrength s/(1 - s)),   s = (V - middle)/(EdgeWidth h),
 *
 * and 0 before the middle: so the strength does not step if the middle wanders along a surface. If
 * h is less than the gradient's `rise` over the kernel radius, then the edge is elsewhere, and s
 * falls to 0.
 *
 * V is V(x_p) or the estimator's own value, the one that is farther inside: the latter carries less
 * noise, but in a sheet that is thinner than the kernel it does not reach the middle.
 */
double GradedStrength(
  const PrecisePoint& point, double value, double rise, bool isDescending) noexcept
{
  const double inside = isDescending ? std::min(value, point.Value) : std::max(value, point.Value);
  const double middle = 0.5 * (point.SurfaceValue + point.MediumValue);
  const double height = std::abs(point.SurfaceValue - point.MediumValue);
  const double above = isDescending ? middle - inside : inside - middle;
  const double past = std::clamp(above / std::max(EdgeWidth * height, 1e-300), 0.0, 1.0);
  const double share = past * std::clamp(2.0 * height / std::max(rise, 1e-300) - 1.0, 0.0, 1.0);
  const double edge = EdgeStrength * share;
  const double whole = point.SurfaceStrength * AtEdge(point, inside, isDescending);
  return std::min(whole, edge / std::max(1.0 - share, 1e-12));
}

} // namespace

void PassOn(PassiveSpring& spring, double stiffness, double lag) noexcept
{
  constexpr double least = HapticModel::MinimumStiffness;
  if (!(lag > 0.0))
  {
    spring.Relax(stiffness);
  }
  else if (stiffness > least && spring.Tissue > least)
  {
    spring.Pass(stiffness, lag);
  }
  else
  {
    // If nothing is felt, the spring has no energy to keep. Its slack stays.
    spring.Tissue = stiffness;
    spring.DropReserve();
  }
}

PrecisePoint PreciseSurroundings::Look(
  const Vector3& proxy, const Vector3& lag, const TouchedMaterial& touched, double voxels) noexcept
{
  const Vector3 index = this->Model.DeviceToIndex(proxy);
  return this->Look(
    proxy, Law::FindSurface(this->Model, this->Field, index, this->Labels), lag, touched, voxels);
}

PrecisePoint PreciseSurroundings::Look(const Vector3& proxy, Surface surface, const Vector3& lag,
  const TouchedMaterial& touched, double voxels) noexcept
{
  ++this->Looks;
  const Vector3 index = this->Model.DeviceToIndex(proxy);
  const bool isDescending = Law::Orient(this->Model, lag, surface);
  PrecisePoint point;
  // Before the values: their sampling hides the lookup's latency.
  const DistinctnessTable::Values distinct = Law::FindDistinctness(this->Model, surface);
  const ValuePair values =
    this->FindValues(index, surface, isDescending, distinct[0], touched, voxels, point);
  Law::SetMaterials(this->Model, index, surface, distinct, values, this->Labels, point);
  point.Value = surface.Value;
  const double slope = surface.GradientMagnitude * this->Model.WorldUnitsPerMeter;
  point.Slope = isDescending ? -slope : slope;
  if (this->Model.Baked->Settings.Alignment == ContactAlignment::Edge && !surface.IsWall &&
    point.SurfaceStrength > 0.0)
  {
    const double even = FarSide::FindEvenShare(point.Far);
    if (this->Model.Baked->Settings.Placement == MaterialPlacement::Kernel)
    {
      point.SurfaceStrength *= AtEdge(point, this->Field.Value(index), isDescending);
    }
    else if (even < 1.0)
    {
      const double edge =
        GradedStrength(point, this->Field.Value(index), this->FindRise(surface), isDescending);
      // An even ramp has no middle: it holds as with the kernel's values.
      MaterialPoint ramp;
      if (even > 0.0)
      {
        const ValuePair nearby = this->Field.Values(index, surface.Reach);
        Law::SetMaterials(this->Model, index, surface, distinct, nearby, this->Labels, ramp);
      }
      point.SurfaceStrength = edge + even * (ramp.SurfaceStrength - edge);
    }
  }
  return point;
}

double PreciseSurroundings::FindRise(const Surface& surface) const noexcept
{
  return surface.GradientMagnitude * this->Model.KernelLength * this->Model.WorldUnitsPerMeter;
}

ValuePair PreciseSurroundings::FindValues(const Vector3& index, const Surface& surface,
  bool isDescending, double distinctness, const TouchedMaterial& touched, double voxels,
  PrecisePoint& point) const noexcept
{
  const BakedVolume& baked = *this->Model.Baked;
  const double share = distinctness * surface.Fade;
  if (baked.Settings.Placement == MaterialPlacement::Kernel || surface.IsWall || share <= 0.0)
  {
    return this->Field.Values(index, surface.Reach);
  }
  const PrecisePoint* const before = touched.Point;
  const bool isAlike = before && Dot(before->Normal, surface.Normal) > 0.0;
  double lasts = FarSide::WalkInterval;
  if (isAlike && touched.IsSurface && voxels < before->FarLasts)
  {
    point.Far = before->Far;
    lasts = before->FarLasts - voxels;
  }
  else
  {
    const double rise = this->FindRise(surface);
    point.Far =
      FindFarSide(this->Field, index, surface.Reach, baked.Kernel.Radius, rise, isDescending);
    const double edge = share * (1.0 - FarSide::FindEvenShare(point.Far));
    if (edge < 1.0)
    {
      const ValuePair nearby = this->Field.Values(index, surface.Reach);
      point.Far.Ahead = nearby.Ahead + edge * (point.Far.Ahead - nearby.Ahead);
      point.Far.Behind = nearby.Behind + edge * (point.Far.Behind - nearby.Behind);
    }
  }
  if (FarSide::FindEvenShare(point.Far) >= 1.0)
  {
    point.FarLasts = lasts;
    return this->Field.Values(index, surface.Reach);
  }
  if (!isAlike || !IsSameEdge(*before, point.Far))
  {
    return { point.Far.Ahead, point.Far.Behind };
  }
  point.FarLasts = lasts;
  const ValuePair followed = FollowFarSide(*before, point.Far, voxels);
  return { touched.IsSurface ? followed.Ahead : point.Far.Ahead, followed.Behind };
}

bool PreciseSurroundings::CanGoOn() const noexcept
{
  return this->Looks + MostTrials + 2 <= MaximumLooks;
}

bool PreciseSurroundings::IsBeyond(const Vector3& a, const Vector3& b) const noexcept
{
  const Vector3 i = this->Model.DeviceToIndex(a);
  const Vector3 j = this->Model.DeviceToIndex(b);
  const VolumeView& view = this->Model.Baked->Field.GetView();
  const auto beyond = [&](double u, double v, int axis)
  {
    const double last = static_cast<double>(view.Border(axis));
    return (u < 0.0 && v < 0.0) || (u > last && v > last);
  };
  return beyond(i.X, j.X, 0) || beyond(i.Y, j.Y, 1) || beyond(i.Z, j.Z, 2);
}

bool PreciseSurroundings::IsOfLevel(const PrecisePoint& here, double level) const noexcept
{
  return !this->Model.Baked->HasOtherSurfaces ||
    std::abs(level - here.Value) * this->Model.MostStepsPerMeter <=
    FarthestLevel * std::abs(here.Slope);
}

double PreciseSurroundings::ToLevel(
  const PrecisePoint& here, double k, double level, const Vector3& lag) const noexcept
{
  const double most = FarthestLevel / this->Model.MostStepsPerMeter;
  const double push = Dot(lag, here.Normal);
  const double displacement = (level - here.Value) / here.Slope;
  // Not past the tip, and not so far out that the surface could not hold the spring.
  const double in = std::clamp(push, 0.0, most);
  const double out = std::clamp(here.SurfaceStrength / k - push, 0.0, most);
  return std::clamp(displacement, -out, in);
}

Arrival PreciseSurroundings::Arrive(
  const Departure& start, const Motion& motion, double share, const Vector3& tip) noexcept
{
  const Vector3 displacement = share * motion.Displacement;
  Arrival end = this->Try(start, motion, displacement, tip);
  const Remainder rest = this->Judge(motion, displacement, tip, end);
  const double tolerance = -Tolerance * Norm(tip - end.Proxy);
  if (rest.Normal < tolerance || rest.Tangent < tolerance)
  {
    end = this->DrawBack(start, motion, displacement, tip, end, rest);
  }
  return end;
}

Arrival PreciseSurroundings::Try(const Departure& start, const Motion& motion,
  const Vector3& displacement, const Vector3& tip) noexcept
{
  const Vector3 proxy = Law::StopAtCut(this->Model, start.Proxy, start.Proxy + displacement);
  const Vector3 lag = tip - proxy;
  // The point is made in place: copies of it would have to wait until it is in the cache.
  Arrival end{ proxy, this->Look(proxy, lag, start.Touched, this->Voxels(displacement)), 0.0,
    start.Spring };
  PassOn(end.Spring, end.There.Stiffness, Norm(lag));
  if (motion.IsHeld && end.There.Slope != 0.0)
  {
    const double back = this->ToLevel(end.There, end.Spring.GetEffective(), start.Level, lag);
    end.Proxy += back * end.There.Normal;
    end.CachedSampleDistance = this->Model.MostVoxelsPerMeter * std::abs(back);
    end.There.Value += end.There.Slope * back;
  }
  return end;
}

PreciseSurroundings::Remainder PreciseSurroundings::Judge(const Motion& motion,
  const Vector3& displacement, const Vector3& tip, const Arrival& end) const noexcept
{
  const PrecisePoint& there = end.There;
  const bool isFelt = Law::IsFelt(there);
  const double compliance = isFelt ? 1.0 / end.Spring.GetEffective() : 0.0;
  const SplitLag lag = Law::Split(tip - end.Proxy, there.Normal);
  const Vector3 direction = (1.0 / Norm(displacement)) * displacement;
  const double inward = Dot(direction, there.Normal);
  const Vector3 aside = direction - inward * there.Normal;
  const double across = Norm(aside);
  const double drag = there.Viscosity * compliance;
  const double holds = there.SurfaceStrength * compliance;
  const double grip = there.Friction * std::clamp(lag.Push, 0.0, holds);

  // The spring that surface and friction leave. There is no surface outward. The part of the spring
  // perpendicular to the motion is held in the same way.
  const bool goesIn = !motion.IsHeld && inward > SmallPart;
  const bool goesOut = !motion.IsHeld && inward < -SmallPart;
  const bool goesAcross = across > SmallPart;
  const double pull = Dot(lag.Tangent, aside);
  const double normal = goesIn ? lag.Push - holds : (goesOut ? std::max(0.0, -lag.Push) : 0.0);
  const double tangent = goesAcross ? (pull > 0.0 ? lag.Length : pull / across) - grip : 0.0;
  // If both parts are left, drag holds them together; if one went too far, it holds each by itself.
  const bool isWhole = normal >= 0.0 && tangent >= 0.0;
  const double total = std::sqrt(normal * normal + tangent * tangent) - drag;
  const bool saysNormal = goesIn || (goesOut && drag > 0.0);
  return { saysNormal ? (isWhole ? total : normal - drag * std::abs(inward)) : NoRoot,
    goesAcross ? (isWhole ? total : tangent - drag * across) : NoRoot, isWhole };
}

Arrival PreciseSurroundings::DrawBack(const Departure& start, const Motion& motion,
  const Vector3& displacement, const Vector3& tip, const Arrival& first,
  const Remainder& rest) noexcept
{
  const Vector3 normalPart =
    rest.IsWhole ? displacement : Dot(displacement, first.There.Normal) * first.There.Normal;
  const Vector3 tangentPart = displacement - normalPart;
  // By the law at its beginning, a motion ends with a remainder of 0.
  const auto along = [&](const Remainder& r)
  { return rest.IsWhole ? std::min(r.Normal, r.Tangent) : r.Normal; };
  RootBracket normal(Norm(normalPart), along(rest), this->Voxels(normalPart));
  RootBracket tangent(
    Norm(tangentPart), rest.IsWhole ? NoRoot : rest.Tangent, this->Voxels(tangentPart));
  Arrival end = first;
  for (int trial = 0; trial < MostTrials; ++trial)
  {
    const bool isLast = normal.IsNarrow() && tangent.IsNarrow();
    const Vector3 shorter = normal.Next(trial) * normalPart + tangent.Next(trial) * tangentPart;
    end = this->Try(start, motion, shorter, tip);
    const Remainder now = this->Judge(motion, displacement, tip, end);
    const double tolerance = Tolerance * Norm(tip - end.Proxy);
    const auto isDone = [&](const RootBracket& bracket, double value)
    { return bracket.IsNarrow() || std::abs(value) <= tolerance; };
    if (isLast || (isDone(normal, along(now)) && isDone(tangent, now.Tangent)))
    {
      return end;
    }
    normal.Narrow(along(now));
    tangent.Narrow(now.Tangent);
  }
  // The end at which the material holds.
  return this->Try(
    start, motion, normal.GetHigh() * normalPart + tangent.GetHigh() * tangentPart, tip);
}

} // namespace VolumeHaptics
