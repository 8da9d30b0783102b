// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How solver PRECISE moves the proxy of one tick, see PreciseSolver.h.
 */
#ifndef PreciseFollower_h
#define PreciseFollower_h

#include "Core/Solvers/Precise/PreciseMotion.h"

namespace VolumeHaptics
{

/** Takes a tip along, and the proxy after it; changes all of the state but its proxy. */
class Follower
{
public:
  Follower(const HapticModel& model, ServoState& state) noexcept
    : Field(model)
    , IsTwoSided(model.Settings.Side == SurfaceSide::Both)
    , Proxy(state.Proxy)
    , State(state.Precise)
  {
  }

  /** Takes the tip along a straight way, and the proxy after it. */
  void Follow(const Vector3& tip) noexcept;
  /** Place, proxy and forces. */
  void Write(TickRecord& record) const noexcept;
  bool IsUnfinished() const noexcept { return this->LooksAreSpent; }

private:
  void LookAround(const Vector3& lag) noexcept;
  /**
   * The tissue where the proxy has been since the last tick: whatever changed there, nobody moved.
   */
  void Refresh(double lag) noexcept;
  /** Moves the proxy until the law leaves it in place; false if the looks do not suffice. */
  bool Settle(const Vector3& tip) noexcept;
  /** What the law asks for, with the place where the proxy is. Null: the tip stays. */
  Motion Plan(const Vector3& tip, const Vector3* tipBefore) noexcept;
  /** What the tick's contact will be called. */
  void Note(double voxels) noexcept;
  /** Makes a motion longer, if the spring stays within what the place holds. */
  void Lengthen(Motion& motion, double factor, const Vector3& tip) const noexcept;
  /** How much longer a whole way was than its first motion asked for: the next will be alike. */
  void Learn(const Vector3& firstWay, const Vector3& way, bool isJudged) noexcept;
  /** A motion too short to be judged. */
  void Creep(const Motion& motion, const Vector3& tip) noexcept;

  Surroundings Field;
  const bool IsTwoSided;
  Vector3 Proxy;
  PreciseState& State;
  Balance Last{};
  bool Pushes = false;
  bool WentThrough = false;
  bool Slid = false;
  bool LooksAreSpent = false;
};

} // namespace VolumeHaptics

#endif
