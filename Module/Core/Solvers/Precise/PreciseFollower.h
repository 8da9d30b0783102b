// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes a tick of the solver Precise (PreciseSolver.h).
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

/** The spring at the end of the last tick. */
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
  Vector3 Tip;      ///< position of the hand's tip, even if the solver has not got that far
  Vector3 Force;    ///< force (N)
  double Stiffness; ///< stiffness (N/m), without slack
  double Friction;
};

/** Moves the tip, and then the proxy. Changes the whole state except state.Proxy. */
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

  /**
   * Sets the surface to which the volume has carried the proxy. `motion` (m) is the proxy's motion.
   */
  void TakeOver(const Surface& there, const Vector3& motion) noexcept;
  /** Moves the tip straight to a position, and the proxy according to the law. */
  void Solve(const Vector3& tip) noexcept;
  /** Writes material, proxy and forces to the record. */
  void Write(TickRecord& record) const noexcept;
  /**
   * Writes the part of the force's change that is due to leaps of the proxy, that is, neither to
   * the tip's motion nor to the proxy's motion with the volume (`carried`, m).
   */
  void WriteLeap(const SpringBefore& before, double carried, TickRecord& record) const noexcept;
  bool IsUnfinished() const noexcept { return this->LooksAreSpent; }

private:
  /**
   * Returns the material at the proxy if its surface or its drag carries a part of the spring's
   * force.
   */
  TouchedMaterial ComputeTouched(const Vector3& lag) const noexcept;
  /** Samples the material at the proxy. `touched` is the same as in PreciseSurroundings::Look(). */
  void LookAround(const Vector3& lag, const TouchedMaterial& touched) noexcept;
  /**
   * Takes over a change of the tissue at the proxy since the last tick, unless a motion caused it.
   * `lag` is in m.
   */
  void Refresh(double lag) noexcept;
  /**
   * Moves the proxy until the law no longer moves it. Returns false if the budget is too small.
   */
  bool Settle(const Vector3& tip) noexcept;
  /**
   * Returns the motion that the law requires at the proxy. `tipBefore` is null if the tip does not
   * move.
   */
  Motion Plan(const Vector3& tip, const Vector3* tipBefore) noexcept;
  /** Records the kind of contact. `voxels` is the length of the motion. */
  void Record(double voxels) noexcept;
  /** Lengthens a motion if the material at its end still holds the spring. */
  void Lengthen(Motion& motion, double factor, const Vector3& tip) const noexcept;
  /** Updates StepPrediction from the ratio of a tick's displacement to its first motion. */
  void Learn(const Vector3& firstDisplacement, const Vector3& displacement, bool isJudged) noexcept;
  /** Performs a motion that is too short to be checked at its end. */
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
