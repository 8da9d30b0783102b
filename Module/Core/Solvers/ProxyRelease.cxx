// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/ProxyRelease.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** N: a smaller remainder ends at once. */
constexpr double LeastRemainder = 1e-3;

/** A remainder after a tick. */
Vector3 Fade(const HapticSettings& settings, const Vector3& force) noexcept
{
  const double length = Norm(force);
  const double period = settings.TickPeriod;
  const double fall =
    std::min(length * period / (settings.ReleaseTime + period), FastestRelease * period);
  return length - fall > LeastRemainder ? (1.0 - fall / length) * force : Vector3{};
}

/**
 * A remainder without the part along a step with which the hand would get something, if its next
 * step is as this one: by trapezoids, half of the work belongs to this step and half to the next.
 */
Vector3 MakePassive(const ReleaseState& before, const Vector3& force, const Vector3& step) noexcept
{
  const double work = Dot(force, step);
  const double rest = before.Absorbed - 0.5 * Dot(before.Force, step);
  if (!(work > 0.0) || rest >= work)
  {
    return force;
  }
  return force - ((work - std::max(rest, 0.0)) / Dot(step, step)) * step;
}

} // namespace

void ReleaseProxy(const HapticSettings& settings, const Vector3& step, ReleaseState& release,
  TickRecord& record) noexcept
{
  const bool leaps = record.Leap.X != 0.0 || record.Leap.Y != 0.0 || record.Leap.Z != 0.0;
  const bool remains = release.Stiffness > 0.0;
  if (!leaps && !remains)
  {
    return;
  }
  if (!(settings.ReleaseTime > 0.0))
  {
    release = ReleaseState{};
    return;
  }
  release.Stiffness = std::max(release.Stiffness, record.LeapStiffness);
  release.Absorbed += record.LeapEnergy;
  const Vector3 faded = Fade(settings, release.Force - record.Leap);
  const Vector3 force = MakePassive(release, faded, step);
  release.Absorbed -= 0.5 * Dot(release.Force + force, step);
  release.Force = force;
  if (Dot(force, force) == 0.0)
  {
    release = ReleaseState{};
    return;
  }
  record.Force += force;
  record.Stiffness = std::max(record.Stiffness, release.Stiffness);
  record.Proxy = record.Tip + (1.0 / record.Stiffness) * record.Force;
}

} // namespace VolumeHaptics
