// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Single motions of solver PRECISE, see PreciseSolver.h: what a place is like, and where a motion
 * ends.
 */
#ifndef PreciseMotion_h
#define PreciseMotion_h

#include "Core/Solvers/ServoState.h"

namespace VolumeHaptics
{

/** What the law asks for. */
struct Motion
{
  Vector3 Way;         ///< m
  bool IsHeld = false; ///< by a surface: the proxy keeps its level
  bool IsFree = false; ///< nothing holds it
};

/** Where a motion begins. */
struct Departure
{
  Vector3 Proxy;
  PassiveSpring Spring;
  double Level; ///< where the motion is held
};

/** Where it ends. */
struct Arrival
{
  Vector3 Proxy;
  Spot There;
  double Stray; ///< voxels by which the proxy lies off the place that was looked up, at most
  PassiveSpring Spring;
};

/** The spring goes on to tissue of another stiffness (N/m), with the tip `lag` (m) away. */
void PassOn(PassiveSpring& spring, double stiffness, double lag) noexcept;

/**
 * The way of a proxy (m) while the tip makes a step that takes the spring from one lag (m) to
 * another, by the law of one place: second order in the step where friction and drag hold all
 * directions alike. What the law says of the last lag alone is `plain`.
 */
Vector3 MoveAlong(const Spot& here, double k, const Vector3& lagBefore, const Vector3& lag,
  const Vector3& plain) noexcept;

/** The volume around a proxy, and how often it was looked at. */
class Surroundings
{
public:
  explicit Surroundings(const HapticModel& model) noexcept
    : Model(model)
  {
  }

  /** The place at a proxy. With two-sided surfaces the normal goes with the spring. */
  Spot Look(const Vector3& proxy, const Vector3& lag) noexcept;
  /** Whether the looks suffice for another motion. */
  bool CanGoOn() const noexcept;

  /** The length of a way (m) in voxels. */
  double Voxels(const Vector3& way) const noexcept
  {
    return Norm(this->Model.DeviceToIndex.Linear * way);
  }

  /** How many voxels a metre is, at most. */
  double GetVoxelsPerMeter() const noexcept { return this->Model.MostVoxelsPerMeter; }

  /** Whether both positions lie beyond the same face of the volume. */
  bool IsBeyond(const Vector3& a, const Vector3& b) const noexcept;

  /**
   * The way (m) along the normal from a place to a level, as far as the spring's balance lets it.
   */
  double ToLevel(const Spot& here, double k, double level, const Vector3& lag) const noexcept;

  /** Goes a share of a motion, or less: no farther than the places on the way let it. */
  Arrival Arrive(
    const Departure& start, const Motion& motion, double share, const Vector3& tip) noexcept;

private:
  /** Spring (m) that is left along a motion's parts; less than 0: it went too far. */
  struct Remainder
  {
    double Normal;
    double Tangent;
    bool IsWhole; ///< both are the same, of the motion as a whole
  };

  Arrival Try(
    const Departure& start, const Motion& motion, const Vector3& way, const Vector3& tip) noexcept;
  Remainder Judge(const Motion& motion, const Vector3& way, const Vector3& tip,
    const Arrival& end) const noexcept;
  Arrival DrawBack(const Departure& start, const Motion& motion, const Vector3& way,
    const Vector3& tip, const Arrival& end, const Remainder& rest) noexcept;

  const HapticModel& Model;
  int Looks = 0;
};

} // namespace VolumeHaptics

#endif
