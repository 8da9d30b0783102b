// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseMotion.h"

#include "Core/Math/Bracket.h"
#include "Core/Solvers/Precise/PreciseSolver.h"

namespace VolumeHaptics
{
namespace
{

/** Share of the spring that a motion may go too far. */
constexpr double Tolerance = 2e-4;
/** What is left of a direction's part after taking this off is rounding. */
constexpr double SmallPart = 1e-3;
/** To which share of itself a motion is drawn back at most; a thousandth of a voxel is less. */
constexpr int MostTrials = 10;
/** How far (voxels) a proxy is from its level at most. */
constexpr double FarthestLevel = 0.25;
/** V(x_p) may be this share of |V(x_s) - V(x_v)| below their mean at an edge. */
constexpr double EdgeTolerance = 1e-3;

/** 1 where the proxy is at or past the middle of an edge, 0 before. */
double AtEdge(const Place& place, double value, bool isDescending) noexcept
{
  const double above = value - 0.5 * (place.SurfaceValue + place.MediumValue);
  const double width = EdgeTolerance * std::abs(place.SurfaceValue - place.MediumValue);
  const double share = 1.0 + (isDescending ? -above : above) / std::max(width, 1e-300);
  return std::clamp(share, 0.0, 1.0);
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
    // Where nothing is felt the spring has no energy to keep. Its slack stays what it is.
    spring.Tissue = stiffness;
    spring.DropReserve();
  }
}

Spot Surroundings::Look(const Vector3& proxy, const Vector3& lag) noexcept
{
  ++this->Looks;
  const Vector3 index = this->Model.DeviceToIndex(proxy);
  Surface surface = Law::FindSurface(this->Model, index);
  const bool isDescending = Law::Orient(this->Model, lag, surface);
  Spot spot;
  Law::ReadMaterials(this->Model, index, surface, spot);
  spot.Value = surface.Value;
  const double slope = surface.GradientMagnitude * this->Model.WorldUnitsPerMeter;
  spot.Slope = isDescending ? -slope : slope;
  if (this->Model.Settings.Alignment == ContactAlignment::Edge && spot.SurfaceStrength > 0.0)
  {
    spot.SurfaceStrength *= AtEdge(spot, this->Model.Field.Value(index), isDescending);
  }
  return spot;
}

bool Surroundings::CanGoOn() const noexcept
{
  return this->Looks + MostTrials + 2 <= MaximumLooks;
}

bool Surroundings::IsBeyond(const Vector3& a, const Vector3& b) const noexcept
{
  const Vector3 i = this->Model.DeviceToIndex(a);
  const Vector3 j = this->Model.DeviceToIndex(b);
  const VolumeView& view = this->Model.Field.GetView();
  const auto beyond = [&](double u, double v, int axis)
  {
    const double last = static_cast<double>(view.Border(axis));
    return (u < 0.0 && v < 0.0) || (u > last && v > last);
  };
  return beyond(i.X, j.X, 0) || beyond(i.Y, j.Y, 1) || beyond(i.Z, j.Z, 2);
}

double Surroundings::ToLevel(
  const Spot& here, double k, double level, const Vector3& lag) const noexcept
{
  const double most = FarthestLevel / this->Model.MostVoxelsPerMeter;
  const double push = Dot(lag, here.Normal);
  const double way = (level - here.Value) / here.Slope;
  // Not past the tip, and not out to where the surface could not hold the spring.
  const double in = std::clamp(push, 0.0, most);
  const double out = std::clamp(here.SurfaceStrength / k - push, 0.0, most);
  return std::clamp(way, -out, in);
}

Arrival Surroundings::Arrive(
  const Departure& start, const Motion& motion, double share, const Vector3& tip) noexcept
{
  const Vector3 way = share * motion.Way;
  const Arrival end = this->Try(start, motion, way, tip);
  const Remainder rest = this->Judge(motion, way, tip, end);
  const double tolerance = -Tolerance * Norm(tip - end.Proxy);
  return rest.Normal < tolerance || rest.Tangent < tolerance
    ? this->DrawBack(start, motion, way, tip, end, rest)
    : end;
}

Arrival Surroundings::Try(
  const Departure& start, const Motion& motion, const Vector3& way, const Vector3& tip) noexcept
{
  Arrival end{ start.Proxy + way, {}, 0.0, start.Spring };
  const Vector3 lag = tip - end.Proxy;
  end.There = this->Look(end.Proxy, lag);
  PassOn(end.Spring, end.There.Stiffness, Norm(lag));
  if (motion.IsHeld && end.There.Slope != 0.0)
  {
    const double back = this->ToLevel(end.There, end.Spring.GetEffective(), start.Level, lag);
    end.Proxy += back * end.There.Normal;
    end.Stray = this->Model.MostVoxelsPerMeter * std::abs(back);
    end.There.Value += end.There.Slope * back;
  }
  return end;
}

Surroundings::Remainder Surroundings::Judge(
  const Motion& motion, const Vector3& way, const Vector3& tip, const Arrival& end) const noexcept
{
  const Spot& there = end.There;
  const bool isFelt = Law::IsFelt(there);
  const double compliance = isFelt ? 1.0 / end.Spring.GetEffective() : 0.0;
  const SplitLag lag = Law::Split(tip - end.Proxy, there.Normal);
  const Vector3 direction = (1.0 / Norm(way)) * way;
  const double inward = Dot(direction, there.Normal);
  const Vector3 aside = direction - inward * there.Normal;
  const double across = Norm(aside);
  const double drag = there.Viscosity * compliance;
  const double holds = there.SurfaceStrength * compliance;
  const double grip = there.Friction * std::clamp(lag.Push, 0.0, holds);

  // What surface and friction leave of the spring. Outward there is no surface; aside from its way
  // the spring is held just the same.
  const bool goesIn = !motion.IsHeld && inward > SmallPart;
  const bool goesOut = !motion.IsHeld && inward < -SmallPart;
  const bool goesAcross = across > SmallPart;
  const double pull = Dot(lag.Tangent, aside);
  const double normal = goesIn ? lag.Push - holds : (goesOut ? std::max(0.0, -lag.Push) : 0.0);
  const double tangent = goesAcross ? (pull > 0.0 ? lag.Length : pull / across) - grip : 0.0;
  // Drag holds both together where both are left, and each for itself where one is overdrawn.
  const bool isWhole = normal >= 0.0 && tangent >= 0.0;
  const double total = std::sqrt(normal * normal + tangent * tangent) - drag;
  const bool saysNormal = goesIn || (goesOut && drag > 0.0);
  return { saysNormal ? (isWhole ? total : normal - drag * std::abs(inward)) : Nothing,
    goesAcross ? (isWhole ? total : tangent - drag * across) : Nothing, isWhole };
}

Arrival Surroundings::DrawBack(const Departure& start, const Motion& motion, const Vector3& way,
  const Vector3& tip, const Arrival& first, const Remainder& rest) noexcept
{
  const Vector3 normalWay = rest.IsWhole ? way : Dot(way, first.There.Normal) * first.There.Normal;
  const Vector3 tangentWay = way - normalWay;
  // By the law of the place where it begins, a motion ends with a remainder of 0.
  const auto along = [&](const Remainder& r)
  { return rest.IsWhole ? std::min(r.Normal, r.Tangent) : r.Normal; };
  Bracket normal(Norm(normalWay), along(rest), this->Voxels(normalWay));
  Bracket tangent(
    Norm(tangentWay), rest.IsWhole ? Nothing : rest.Tangent, this->Voxels(tangentWay));
  Arrival end = first;
  for (int trial = 0; trial < MostTrials; ++trial)
  {
    const bool isLast = normal.IsNarrow() && tangent.IsNarrow();
    const Vector3 shorter = normal.Next(trial) * normalWay + tangent.Next(trial) * tangentWay;
    end = this->Try(start, motion, shorter, tip);
    const Remainder now = this->Judge(motion, way, tip, end);
    const double tolerance = Tolerance * Norm(tip - end.Proxy);
    const auto isDone = [&](const Bracket& bracket, double value)
    { return bracket.IsNarrow() || std::abs(value) <= tolerance; };
    if (isLast || (isDone(normal, along(now)) && isDone(tangent, now.Tangent)))
    {
      return end;
    }
    normal.Narrow(along(now));
    tangent.Narrow(now.Tangent);
  }
  // The side that holds.
  return this->Try(
    start, motion, normal.GetHigh() * normalWay + tangent.GetHigh() * tangentWay, tip);
}

} // namespace VolumeHaptics
