// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/SurfaceProxy/SurfaceProxy.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/Math/HalfSpaces.h"
#include "Core/Model/SurfaceMesh.h"
#include "Core/State/ServoState.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Fractions of the radius: the distance within which the sphere touches a triangle, the distance
 * that it keeps from triangles, and the length below which a move counts as rest.
 */
constexpr double Margin = 3e-3;
constexpr double Distance = 1e-6;
constexpr double Still = 1e-5;
/**
 * After ManyPasses, a move of this length (radii) counts as rest, because in a valley the shadings
 * of both sides may move the sphere back and forth.
 */
constexpr double ShadedStill = 5e-3;
constexpr int ManyPasses = 8;
/** The radius shrinks at most to this fraction, even if a triangle is deeper in the sphere. */
constexpr double LeastLeft = 1e-3;
/** Longest move (radii). The triangles along it must not exceed the budget. */
constexpr double LongestMove = 64.0;
/** Cosine of the largest angle between a triangle's normal and its shading normal. */
constexpr double LeastCosine = 0.8;

/**
 * If the ratio of successive moves is within this range, all further moves are added up at once, as
 * a geometric series.
 */
constexpr double SlowRate = 0.2;
constexpr double SlowestRate = 0.9;

/**
 * Longest distance (radii) by which triangles move the sphere in one step, and the limit of these
 * steps.
 */
constexpr double LongestCarry = 0.25;
constexpr int MostCarries = 16;
/**
 * Distance (radii) by which one step moves a sphere out of a moving triangle that it overlaps.
 */
constexpr double Recovery = 0.01;

/**
 * The proxy's sphere. It moves towards a goal until triangles of the mesh stop it. Lengths are in
 * world units.
 */
class Sphere
{
public:
  /**
   * Places a sphere among the triangles.
   * @param fraction position of the triangles between their time step (0) and the next one (1)
   */
  Sphere(const HapticModel& model, const SurfaceMesh& mesh, double fraction,
    const Vector3& centre) noexcept
    : Model(model)
    , Mesh(mesh)
    , Fraction(fraction)
    , Radius(model.Baked->Settings.ProxyRadius)
    , IsShaded(model.Baked->Settings.ForceShading && this->Mesh.HasNormals())
    , Centre(centre)
  {
  }

  const Vector3& GetCentre() const noexcept { return this->Centre; }
  bool IsShading() const noexcept { return this->IsShaded; }
  bool IsTouching() const noexcept { return this->True.GetCount() > 0; }
  /** Returns whether visiting triangles has used up the tick's budget. */
  bool IsSpent() const noexcept { return this->Budget < 0; }

  /** Returns the point nearest to a goal that is in the half-spaces of all touched triangles. */
  Vector3 ComputeSubgoal(const Vector3& goal) noexcept
  {
    this->Touch();
    if (this->Nearest < (1.0 - Margin) * this->Radius)
    {
      // The sphere began in a triangle, or the mesh is new. Shrink the sphere until it only touches
      // the triangle.
      this->Radius = std::max(this->Nearest, LeastLeft * this->Radius);
      this->Touch();
    }
    const Vector3 shaded = this->IsShaded ? this->Shaded.Nearest(goal, goal) : goal;
    return this->True.Nearest(shaded, this->Centre);
  }

  /**
   * Moves the sphere up to the first triangle. If the displacement is long, uses only its first
   * part.
   */
  void Move(const Vector3& whole) noexcept
  {
    const Vector3 displacement = std::min(1.0, LongestMove * this->Radius / Norm(whole)) * whole;
    double first = Never;
    const bool isWhole = this->Mesh.VisitAlong(this->Centre, displacement, this->Radius,
      this->Budget,
      [&](std::int32_t i)
      {
        const Triangle triangle = this->Mesh.GetTriangle(i, this->Fraction);
        const double time = MeetingTime(triangle, this->Centre, displacement, this->Radius, first);
        if (time < first &&
          !this->Model.IsCutAway(
            NearestPoint(triangle, this->Centre + time * displacement).Position))
        {
          first = time;
        }
        return std::min(first, 1.0);
      });
    if (!isWhole)
    {
      return;
    }
    const double gap = Distance * this->Radius / Norm(displacement);
    this->Centre += (first <= 1.0 ? std::max(0.0, first - gap) : 1.0) * displacement;
  }

private:
  void Touch() noexcept
  {
    this->True.Clear();
    this->Shaded.Clear();
    this->Nearest = HUGE_VAL;
    this->Mesh.VisitNear(this->Centre, this->Radius * (1.0 + Margin), this->Budget,
      [&](std::int32_t i) { this->Touch(i); });
  }

  void Touch(std::int32_t i) noexcept
  {
    const TrianglePoint nearest =
      NearestPoint(this->Mesh.GetTriangle(i, this->Fraction), this->Centre);
    const Vector3 off = this->Centre - nearest.Position;
    const double distance = Norm(off);
    // A centre in a triangle's plane is on neither side of the triangle.
    if (!(distance <= this->Radius * (1.0 + Margin)) || distance == 0.0 ||
      this->Model.IsCutAway(nearest.Position))
    {
      return;
    }
    this->Nearest = std::min(this->Nearest, distance);
    const Vector3 normal = (1.0 / distance) * off;
    // Keep the sphere from going deeper, but do not push it out.
    const double overlap = this->Radius * (1.0 + Distance) - distance;
    const double missing = overlap > Margin * this->Radius ? 0.0 : overlap;
    this->True.Add({ normal, Dot(normal, this->Centre) + missing });
    if (this->IsShaded)
    {
      const Vector3 smooth = this->Mesh.GetNormal(i, nearest);
      const double length = std::copysign(Norm(smooth), Dot(smooth, normal));
      // At a sharp edge, the interpolated normal may belong to another face.
      const bool isSmooth = Dot(smooth, normal) / length > LeastCosine;
      const Vector3 shaded = isSmooth ? (1.0 / length) * smooth : normal;
      this->Shaded.Add({ shaded, Dot(shaded, this->Centre) + missing });
    }
  }

  const HapticModel& Model;
  const SurfaceMesh& Mesh;
  const double Fraction;
  double Radius; ///< radius; while the sphere overlaps a triangle, it is the triangle's distance
  const bool IsShaded;
  int Budget = MaximumVisits;
  Vector3 Centre;
  double Nearest = HUGE_VAL; ///< distance of the nearest triangle that the sphere touches
  HalfSpaces True;
  HalfSpaces Shaded;
};

/**
 * Returns the position to which triangles move a sphere that would otherwise rest. Approaching
 * triangles push it.
 */
Vector3 Carry(const MeshWay& way, double radius, const Vector3& from) noexcept
{
  Vector3 centre = from;
  const double longest = way.Mesh->GetLongestMotion() * std::abs(way.To - way.From);
  if (!(longest > 0.0))
  {
    return centre;
  }
  const int steps = static_cast<int>(
    std::clamp(std::ceil(longest / (LongestCarry * radius)), 1.0, double{ MostCarries }));
  const double reach = radius * (1.0 + Margin) + longest / steps;
  int budget = MaximumVisits;
  for (int step = 0; step < steps; ++step)
  {
    const double before = way.From + (way.To - way.From) * step / steps;
    const double after = way.From + (way.To - way.From) * (step + 1) / steps;
    HalfSpaces sides;
    double touched = (1.0 + Distance + Margin) * radius;
    Vector3 along;
    way.Mesh->VisitNear(centre, reach, budget,
      [&](std::int32_t i)
      {
        const TrianglePoint nearest = NearestPoint(way.Mesh->GetTriangle(i, before), centre);
        const Vector3 off = centre - nearest.Position;
        const double distance = Norm(off);
        if (!(distance <= reach) || distance == 0.0)
        {
          return;
        }
        const Triangle there = way.Mesh->GetTriangle(i, after);
        Vector3 place;
        for (int c = 0; c < 3; ++c)
        {
          place += nearest.Weight[c] * there.Corner[c];
        }
        const Vector3 normal = (1.0 / distance) * off;
        if (way.IsMaterial && distance < touched)
        {
          touched = distance;
          const Vector3 motion = place - nearest.Position;
          along = motion - Dot(motion, normal) * normal;
        }
        const double kept = std::min((1.0 + Distance) * radius, distance + Recovery * radius);
        const double bound = Dot(normal, place) + kept;
        if (Dot(normal, centre) < bound)
        {
          sides.Add({ normal, bound });
        }
      });
    const Vector3 goal = centre + along;
    centre = sides.Nearest(goal, goal);
  }
  return centre;
}

} // namespace

void StepSurfaceProxy(
  const HapticModel& model, ServoState& state, TickRecord& record, const MethodInput&) noexcept
{
  record.Proxy = record.Tip;
  if (!Law::ReadIsoMaterial(model, record) || !state.Enabled)
  {
    return;
  }
  const double k = record.Stiffness;
  const double scale = model.WorldUnitsPerMeter;
  const double radius = model.Baked->Settings.ProxyRadius;
  const Vector3 goal = model.DeviceToWorld(record.Tip);
  MeshWay ways[BakedVolume::MostMeshWays];
  const int count = model.Baked->CollectMeshWays(state.CarriedTo, state.DataTime, ways);
  const MeshWay& last = ways[count - 1];
  if (!last.Mesh)
  {
    return;
  }
  const Vector3 start = model.DeviceToWorld(state.Proxy);
  Vector3 centre = start;
  for (const MeshWay* way = ways; way != ways + count; ++way)
  {
    centre = way->Mesh ? Carry(*way, radius, centre) : centre;
  }
  const Vector3 lag = model.DeviceToWorld(state.PreviousTip) - start;
  const Vector3 carried = centre - start;
  record.WallWork = 0.5 * k * (Dot(carried, carried) - 2.0 * Dot(lag, carried)) / (scale * scale);
  Sphere sphere(model, *last.Mesh, last.To, centre);
  bool slides = false;
  Vector3 held = goal - sphere.GetCentre();
  double rest = 0.0;
  double lastExcess = 0.0;
  record.IsUnfinished = true;
  for (int pass = 0; pass < MaximumPasses; ++pass)
  {
    const Vector3 subgoal = sphere.ComputeSubgoal(goal);
    if (sphere.IsSpent())
    {
      break;
    }
    const Vector3 displacement = subgoal - sphere.GetCentre();
    held = goal - subgoal;
    rest = Norm(displacement);
    const double excess = rest - record.Friction * Norm(held);
    // A rate exists only while the sphere touches a triangle. Without contact it may fall towards
    // the tip.
    const double rate = sphere.IsTouching() && lastExcess > 0.0 ? excess / lastExcess : 0.0;
    const double still = sphere.IsShading() && pass >= ManyPasses ? ShadedStill : Still;
    if (excess <= still * radius)
    {
      record.IsUnfinished = false;
      break;
    }
    // With friction, long moves are not tried, because a move that is too long can't be undone.
    const bool isSlow = record.Friction == 0.0 && rate > SlowRate && rate < SlowestRate;
    sphere.Move((excess / rest / (isSlow ? 1.0 - rate : 1.0)) * displacement);
    slides = slides || sphere.IsTouching();
    lastExcess = sphere.IsTouching() ? (isSlow ? 0.0 : excess) : lastExcess;
  }
  if (!sphere.IsTouching() && !record.IsUnfinished)
  {
    return;
  }
  record.Proxy = model.WorldToDevice(sphere.GetCentre());
  record.Force = k * (record.Proxy - record.Tip);
  record.NormalForce = k * Norm(held) / scale;
  record.FrictionForce = k * rest / scale;
  if (record.NormalForce > Law::ForceEpsilon)
  {
    // The surfaces carry the part of the spring's force that friction does not carry.
    record.Normal = (1.0 / Norm(held)) * (Transpose(model.DeviceToWorldRotation) * held);
    record.Contact = slides ? ContactState::Sliding : ContactState::Sticking;
  }
}

bool IsOutsideSurface(const HapticModel& model, const Vector3& place, double time) noexcept
{
  const HapticSettings& settings = model.Baked->Settings;
  const double value = model.ValueAtDevice(place, time);
  const bool isLower = settings.Side == SurfaceSide::Lower;
  return !settings.HasIsoSurface ||
    (isLower ? value > settings.IsoValue : value < settings.IsoValue);
}

Vector3 EnterSurface(const HapticModel& model, const Vector3& place, double time) noexcept
{
  constexpr int steps = 12;
  if (IsOutsideSurface(model, place, time))
  {
    return place;
  }
  const double radius = 1.1 * model.Baked->Settings.ProxyRadius / model.WorldUnitsPerMeter;
  for (int step = 1; step <= steps; ++step)
  {
    const double distance = EntryDepth * model.KernelLength * step / steps;
    for (int i = 0; i < 27; ++i)
    {
      // The neighbours of the middle of a 3^3 cube give the directions.
      const Vector3 direction{ i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0 };
      const Vector3 unit = (1.0 / std::max(1.0, Norm(direction))) * direction;
      if (i != 13 && IsOutsideSurface(model, place + distance * unit, time))
      {
        return place + (distance + radius) * unit;
      }
    }
  }
  return place;
}

Vector3 FindSurfaceProxyReach(const HapticModel& model) noexcept
{
  const Vector3 perUnit = (1.0 / model.WorldUnitsPerMeter) * model.VoxelsPerMeter;
  return model.Baked->Settings.ProxyRadius * perUnit +
    Vector3{ ResidencySpare, ResidencySpare, ResidencySpare };
}

} // namespace VolumeHaptics
