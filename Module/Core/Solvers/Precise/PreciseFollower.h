// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes a tick of solver PRECISE (PreciseSolver.h).
 */
#ifndef PreciseFollower_h
#define PreciseFollower_h

#include "Core/Law/MaterialLaw.h"
#include "Core/Solvers/Precise/PreciseSurroundings.h"
#include "Core/State/ServoState.h"

#include <algorithm>
#include <optional>

namespace VolumeHaptics
{

/** The spring after the last tick. */
struct SpringBefore
{
  explicit SpringBefore(const ServoState& state) noexcept
    : IsOfAnotherModel(state.Precise.CachedSampleDistance == PreciseState::Unknown)
    , Tip(IsOfAnotherModel ? state.Precise.ReachedTip : state.PreviousTip)
    , Force(state.Stiffness * (state.Proxy - state.Precise.ReachedTip))
    , Stiffness(std::max(state.Stiffness, state.Precise.Spring.Tissue))
    , Friction(state.Precise.Here.Friction)
  {
  }

  bool IsOfAnotherModel;
  Vector3 Tip;      ///< position of the hand's tip, even if the solver has not reached it
  Vector3 Force;    ///< force in N
  double Stiffness; ///< stiffness in N/m, without slack
  double Friction;
};

/** Moves the tip, and the proxy after it. Changes all of the state except state.Proxy. */
class PreciseFollower
{
public:
  PreciseFollower(const HapticModel& model, ServoState& state, TickMemory* memory) noexcept
    : Field(model, state.DataTime, state.Labels, memory)
    , IsTwoSided(model.Baked->Settings.Side == SurfaceSide::Both)
    , IsOfWalls(model.Baked->Settings.Geometry == SurfaceGeometry::Labels)
    , Proxy(state.Proxy)
    , State(state.Precise)
  {
  }

  /** Sets the surface to which the proxy was moved with the volume. `motion` (m) is that motion. */
  void TakeOver(const Surface& there, const Vector3& motion) noexcept;
  /** Moves the tip straight to a position, and the proxy by the law. */
  void Solve(const Vector3& tip) noexcept;
  /** Writes material, proxy and forces to the record. */
  void Write(TickRecord& record) const noexcept;
  /**
   * Writes the part of the force's change that comes from leaps of the proxy. Neither the tip's
   * motion nor the proxy's motion with the volume (`carried`, m) explains this part.
   */
  void WriteLeap(const SpringBefore& before, double carried, TickRecord& record) const noexcept;
  bool IsUnfinished() const noexcept { return this->LooksAreSpent; }

private:
  /**
   * Returns the material at the proxy if its surface or its drag holds a part of the spring's
   * force.
   */
  TouchedMaterial ComputeTouched(const Vector3& lag) const noexcept;
  /** Samples the material at the proxy. `touched` is as in PreciseSurroundings::Look. */
  void LookAround(const Vector3& lag, const TouchedMaterial& touched) noexcept;
  /**
   * Adopts a change of the tissue at the proxy since the last tick, if it was not caused by motion.
   * `lag` is in m.
   */
  void Refresh(double lag) noexcept;
  /**
   * Moves the proxy until the law no longer moves it. Returns false if the budget does not suffice.
   */
  bool Settle(const Vector3& tip) noexcept;
  /**
   * Returns the motion that the law requires at the proxy. `tipBefore` is null if the tip does not
   * move.
   */
  Motion Plan(const Vector3& tip, const Vector3* tipBefore) noexcept;
  /** Stores the kind of contact. `voxels` is the length of the motion. */
  void Record(double voxels) noexcept;
  /** Makes a motion longer if the material at its end still holds the spring. */
  void Lengthen(Motion& motion, double factor, const Vector3& tip) const noexcept;
  /** Learns StepPrediction from the ratio of a tick's displacement to its first motion. */
  void Learn(const Vector3& firstDisplacement, const Vector3& displacement, bool isJudged) noexcept;
  /** Performs a motion that is too short to be judged at its end. */
  void Creep(const Motion& motion, const Vector3& tip) noexcept;

  PreciseSurroundings Field;
  const bool IsTwoSided;
  const bool IsOfWalls;
  Vector3 Proxy;
  PreciseState& State;
  Balance Last{};
  bool Pushes = false;
  bool WentThrough = false;
  bool Slid = false;
  bool LooksAreSpent = false;
  std::optional<Vector3> Refreshed; ///< force (N) before the tip's motion; none if nothing is felt
};

} // namespace VolumeHaptics

#endif
