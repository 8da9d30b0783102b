// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/State/ProxyRelease.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** A remainder below this force (N) is dropped. */
constexpr double LeastRemainder = 1e-3;

/** Returns the remainder after it has faded for one tick. */
Vector3 Fade(const HapticSettings& settings, const Vector3& force) noexcept
{
  const double length = Norm(force);
  const double period = settings.TickPeriod;
  const double fall =
    std::min(length * period / (settings.ReleaseTime + period), FastestRelease * period);
  return length - fall > LeastRemainder ? (1.0 - fall / length) * force : Vector3{};
}

/**
 * Computes the largest fraction s of `way`, the change of the force `held`, that the saved energy
 * can pay for: a s^2 + b s <= 2 k Saved. This holds for s = 0.
 */
double ComputePaidFraction(
  const ReleaseState& release, const Vector3& way, const Vector3& twiceMean) noexcept
{
  const double a = Dot(way, way);
  const double b = Dot(way, twiceMean);
  const double saved = 2.0 * release.Stiffness * release.Saved;
  if (a + b <= saved)
  {
    return 1.0;
  }
  const double fraction = (std::sqrt(b * b + 4.0 * a * saved) - b) / (2.0 * a);
  return fraction > 0.0 ? std::min(fraction, 1.0) : 0.0; // 0 for NaN
}

} // namespace

void ReleaseProxy(const HapticSettings& settings, const Vector3& step, ReleaseState& release,
  TickRecord& record) noexcept
{
  if (!(record.LeapStiffness > 0.0) && !(release.Stiffness > 0.0))
  {
    return;
  }
  if (!record.MayLeap || !(settings.ReleaseTime > 0.0))
  {
    release = ReleaseState{};
    return;
  }
  const double k = release.Stiffness = std::max(release.Stiffness, record.LeapStiffness);
  const Vector3 before = record.ForceBefore + release.Force;
  const Vector3 held = before - k * step;
  const Vector3 faded = Fade(settings, release.Force - record.Leap);
  const Vector3 change = record.Force + faded - before;
  const double most = std::max(FastestChange * settings.TickPeriod, k * Norm(step));
  const double size = Norm(change);
  const Vector3 way = before + (size > most ? most / size : 1.0) * change - held;
  release.Saved += record.WallWork > 0.0 ? record.WallWork : 0.0; // the wall pays for its push
  const double fraction = ComputePaidFraction(release, way, before + held);
  if (fraction == 1.0 && size <= most && Dot(faded, faded) == 0.0)
  {
    release = ReleaseState{};
    return;
  }
  const Vector3 force = held + fraction * way;
  const double cost = fraction * Dot(way, before + force) / (2.0 * k);
  release.Saved = std::max(0.0, release.Saved - cost);
  release.Force = force - record.Force;
  record.Force = force;
  record.Stiffness = std::max(record.Stiffness, k);
  record.Proxy = record.Tip + (1.0 / record.Stiffness) * force;
}

} // namespace VolumeHaptics
