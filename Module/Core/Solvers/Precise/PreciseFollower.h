// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One tick of solver PRECISE (PreciseSolver.h).
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
  Vector3 Tip;      ///< the hand's tip, even where the solver has not reached it
  Vector3 Force;    ///< N
  double Stiffness; ///< N/m, without slack
  double Friction;
};

/** Moves the tip and, after it, the proxy. Changes all of the state except its proxy. */
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

  /** Takes over the surface to which the proxy was carried by a motion (m), for a moving volume. */
  void TakeOver(const Surface& there, const Vector3& motion) noexcept;
  /** Moves the tip straight to a position, and lets the proxy follow. */
  void Solve(const Vector3& tip) noexcept;
  /** Writes material, proxy and forces to the record. */
  void Write(TickRecord& record) const noexcept;
  /**
   * Writes the part of the force's change that comes from leaps of the proxy: neither the tip's
   * motion explains this part, nor the proxy's motion with the volume (`carried`, m).
   */
  void WriteLeap(const SpringBefore& before, double carried, TickRecord& record) const noexcept;
  bool IsUnfinished() const noexcept { return this->LooksAreSpent; }

private:
  /**
   * Returns the material at the proxy, if its surface or drag takes a part of the spring's force.
   */
  TouchedMaterial ComputeTouched(const Vector3& lag) const noexcept;
  /**
   * Samples the material at the proxy; `touched` has the same meaning as in
   * PreciseSurroundings::Look.
   */
  void LookAround(const Vector3& lag, const TouchedMaterial& touched) noexcept;
  /**
   * Takes over a change of the tissue at the proxy since the last tick, if no motion has caused the
   * change.
   */
  void Refresh(double lag) noexcept;
  /**
   * Moves the proxy until the law leaves it in place; returns false if the budget does not suffice.
   */
  bool Settle(const Vector3& tip) noexcept;
  /**
   * Returns the motion that the law demands at the proxy's point. `tipBefore` is null if the tip
   * stays.
   */
  Motion Plan(const Vector3& tip, const Vector3* tipBefore) noexcept;
  /** Records the kind of contact. */
  void Record(double voxels) noexcept;
  /** Lengthens a motion, if the material at its end still holds the spring. */
  void Lengthen(Motion& motion, double factor, const Vector3& tip) const noexcept;
  /** Learns StepPrediction from the ratio of a tick's displacement to its first motion. */
  void Learn(const Vector3& firstDisplacement, const Vector3& displacement, bool isJudged) noexcept;
  /** Makes a motion that is too short to be judged at its end. */
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
  std::optional<Vector3> Refreshed; ///< N, the force before the tip's motion, if something is felt
};

} // namespace VolumeHaptics

#endif
