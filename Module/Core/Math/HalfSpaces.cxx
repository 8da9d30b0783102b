// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/HalfSpaces.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** Angle (rad) between two normals below which they count as equal. */
constexpr double SameDirection = 1e-6;
/** A point may miss a bound by this fraction of the distances. */
constexpr double Slack = 1e-12;
/** Determinant below which a system of normals counts as singular. */
constexpr double Singular = 1e-9;

double Excess(const HalfSpace& space, const Vector3& y) noexcept
{
  return Dot(space.Normal, y) - space.Bound;
}

/**
 * Computes the point nearest to `goal` that is on the planes of all `count` (1 to 3) half-spaces.
 * Returns false if there is no such point.
 */
bool Project(
  const HalfSpace* const* spaces, int count, const Vector3& goal, Vector3& point) noexcept
{
  const Vector3& a = spaces[0]->Normal;
  const double ra = -Excess(*spaces[0], goal);
  if (count == 1)
  {
    point = goal + ra * a;
    return true;
  }
  const Vector3& b = spaces[1]->Normal;
  const double rb = -Excess(*spaces[1], goal);
  const double ab = Dot(a, b);
  if (count == 2)
  {
    const double determinant = 1.0 - ab * ab;
    if (determinant < Singular * Singular)
    {
      return false;
    }
    point = goal + ((ra - ab * rb) / determinant) * a + ((rb - ab * ra) / determinant) * b;
    return true;
  }
  const Vector3& c = spaces[2]->Normal;
  const double rc = -Excess(*spaces[2], goal);
  const Vector3 bc = Cross(b, c);
  const double determinant = Dot(a, bc);
  if (std::abs(determinant) < Singular)
  {
    return false;
  }
  point = goal + (1.0 / determinant) * (ra * bc + rb * Cross(c, a) + rc * Cross(a, b));
  return true;
}

} // namespace

void HalfSpaces::Add(const HalfSpace& space) noexcept
{
  for (int i = 0; i < this->Count; ++i)
  {
    HalfSpace& known = this->Spaces[i];
    const Vector3 difference = known.Normal - space.Normal;
    if (Dot(difference, difference) < SameDirection * SameDirection)
    {
      known.Bound = std::max(known.Bound, space.Bound);
      return;
    }
  }
  if (this->Count < Most)
  {
    this->Spaces[this->Count++] = space;
  }
}

Vector3 HalfSpaces::Nearest(const Vector3& goal, const Vector3& fallback) const noexcept
{
  const HalfSpace* active[4];
  int count = 0;
  Vector3 point = goal;
  const double slack = Slack * (1.0 + Norm(goal) + Norm(fallback));
  // The point gets farther from the goal in each round, so no active set occurs twice.
  for (int round = 0; round < 4 * Most; ++round)
  {
    const HalfSpace* worst = nullptr;
    double most = slack;
    for (int i = 0; i < this->Count; ++i)
    {
      const double missing = -Excess(this->Spaces[i], point);
      if (missing > most)
      {
        most = missing;
        worst = &this->Spaces[i];
      }
    }
    if (!worst)
    {
      return point;
    }
    active[count++] = worst;
    // Among all active sets that contain the new bound, choose the nearest point that is in all
    // half-spaces found so far.
    int best = 0;
    double nearest = 0.0;
    Vector3 found;
    for (int set = 1 << (count - 1); set < 1 << count; ++set)
    {
      const HalfSpace* chosen[4] = {};
      int size = 0;
      for (int i = 0; i < count; ++i)
      {
        if (set >> i & 1)
        {
          chosen[size++] = active[i];
        }
      }
      Vector3 y;
      if (size > 3 || !Project(chosen, size, goal, y))
      {
        continue;
      }
      const bool isAllowed = std::all_of(active, active + count,
        [&](const HalfSpace* space) { return Excess(*space, y) >= -slack; });
      const double distance = Dot(y - goal, y - goal);
      if (isAllowed && (best == 0 || distance < nearest))
      {
        best = set;
        nearest = distance;
        found = y;
      }
    }
    if (best == 0)
    {
      return fallback;
    }
    int kept = 0;
    for (int i = 0; i < count; ++i)
    {
      if (best >> i & 1)
      {
        active[kept++] = active[i];
      }
    }
    count = kept;
    point = found;
  }
  return fallback;
}

} // namespace VolumeHaptics
