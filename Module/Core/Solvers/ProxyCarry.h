// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The steps that move a proxy to a level. Used by CarriedProxy.cxx, and by the shorter code of the
 * solver Paper.
 */
#ifndef ProxyCarry_h
#define ProxyCarry_h

#include "Core/Law/MaterialLaw.h"
#include "Core/State/ServoState.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

/** The result of moving a proxy to a level. */
struct ProxyCarry
{
  Vector3 Proxy;     ///< position (m)
  double Away = 0.0; ///< length (m) of the motion along the normal
};

namespace Carrying
{
constexpr int MostSteps = 3;
/** Longest step (voxels). */
constexpr double LongestStep = 0.25;
/**
 * If a step s is at most this length (voxels), the level is reached. The remaining error is at most
 * s^2 / (2 sigma), for an edge of width sigma. A level that holds the proxy is the same in all
 * ticks, so the next tick corrects the error, and ShortStepToLevel suffices. For other levels,
 * errors would add up.
 */
constexpr double ShortStep = 0.01;
constexpr double ShortStepToLevel = 0.06;
/**
 * After a motion of at most this length (voxels), the surface is not read again, because normal and
 * gradient hardly change.
 */
constexpr double SameSurface = 0.06;

/**
 * Returns whether a surface holds the proxy, or could hold it, according to the last tick. `fade`
 * is the surface's Surface::Fade.
 */
inline bool IsSurfaceThere(const ServoState& state, double fade) noexcept
{
  return fade > 0.0 && state.SurfaceStrength > 0.0 &&
    state.Stiffness > HapticModel::MinimumStiffness;
}

inline bool IsSameSurface(const HapticModel& model, double away) noexcept
{
  return std::abs(away) * model.MostVoxelsPerMeter <= SameSurface;
}

/** Returns the energy (J) that a motion of the proxy adds to the spring. */
inline double ComputeWork(
  const ServoState& state, const Vector3& start, const Vector3& proxy) noexcept
{
  const Vector3 motion = proxy - start;
  const Vector3 lag = state.PreviousTip - start;
  return 0.5 * state.Stiffness * (Dot(motion, motion) - 2.0 * Dot(lag, motion));
}

/** Returns how much the estimator's value rises per metre along the gradient. */
inline double ComputeSlope(const HapticModel& model, double gradientMagnitude) noexcept
{
  return gradientMagnitude * model.WorldUnitsPerMeter;
}

/**
 * Returns the step (m) along the gradient over which the value rises by `rise`. `slope` is the rise
 * per metre. The step does not lead inward past the tip.
 */
inline double ComputeStep(const HapticModel& model, const Vector3& normal, double rise,
  double slope, const Vector3& lag, bool isHeld) noexcept
{
  const double longest = LongestStep / model.MostVoxelsPerMeter;
  const double wanted = rise / slope;
  const double step = std::isnan(wanted) ? 0.0 : std::clamp(wanted, -longest, longest);
  const bool isTwoSided = model.Baked->Settings.Side == SurfaceSide::Both;
  if (isTwoSided && !isHeld)
  {
    return step; // the surface may be touched from either side, so the tip does not limit the step
  }
  const double push = Dot(lag, normal);
  return Law::IsDescending(model, lag, normal) ? std::max(step, std::min(push, 0.0))
                                               : std::min(step, std::max(push, 0.0));
}

/**
 * Returns the slope of V, computed from its rise over the last step. If it differs from the
 * estimator's slope by more than a factor of four, for example where V is flat, returns the
 * estimator's slope.
 */
inline double ComputeSlopeOfValue(double estimated, double rise, double step) noexcept
{
  constexpr double most = 4.0;
  const double secant = rise / step;
  return secant > estimated / most && secant < most * estimated ? secant : estimated;
}

/**
 * Moves the proxy from state.Proxy along a normal to a level of V, by the secant method.
 * @param levels V before the volume's motion, and after it
 * @param findValue returns V at an index
 */
template <typename ValueFunction>
ProxyCarry SolveLevel(const HapticModel& model, const ServoState& state, const Vector3& normal,
  double gradientMagnitude, const FractionPair& levels, const ValueFunction& findValue) noexcept
{
  const double estimated = ComputeSlope(model, gradientMagnitude);
  ProxyCarry carry{ state.Proxy };
  double slope = estimated;
  double level = levels.Second;
  for (int i = 1;; ++i)
  {
    const Vector3 lag = state.PreviousTip - carry.Proxy;
    const double step = ComputeStep(model, normal, levels.First - level, slope, lag, false);
    carry.Proxy += step * normal;
    carry.Away += step;
    if (i == MostSteps || std::abs(step) * model.MostVoxelsPerMeter <= ShortStep)
    {
      return carry;
    }
    const double reached = findValue(model.DeviceToIndex(carry.Proxy));
    slope = ComputeSlopeOfValue(estimated, reached - level, step);
    level = reached;
  }
}
} // namespace Carrying

} // namespace VolumeHaptics

#endif
