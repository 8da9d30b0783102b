// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state that a tick of the servo passes to the next one. All of it is in device space (metres,
 * newtons) except LocalState.
 */
#ifndef ServoState_h
#define ServoState_h

#include "Core/Math/Quaternion.h"
#include "Core/Model/LabelMemory.h"
#include "Core/State/LocalState.h"
#include "Core/State/PreciseState.h"
#include "Core/State/PrimitiveMemory.h"
#include "Core/State/ProxyRelease.h"
#include "Core/State/TickRecord.h"
#include "Core/State/ToolStates.h"

#include <cstddef>

namespace VolumeHaptics
{

/** Limit of a tip's coordinates (m), so that their squares do not overflow. No hand reaches it. */
constexpr double FarthestTip = 1e9;

/** The state from which the next tick starts. */
struct ServoState : ToolStates
{
  Vector3 Proxy;
  Vector3 PreviousTip;
  bool Enabled = false; ///< false: the next tick puts the proxy on the tip, without a force
  PreciseState Precise;
  /** Remainder of the force, felt in addition to the law's force; the law alone moves the proxy. */
  ReleaseState Release;
  LocalState Local;
  PrimitiveMemory Primitives;
  /** Results of the last label lookups, which only make the next lookups faster. */
  LabelMemory Labels;
  /** Data time of the tick. If the volume moves, the caller advances it before each tick. */
  double DataTime = 0.0;
  ///@{
  /**
   * Orientation of the stylus in this tick, for tools: a unit quaternion if HasOrientation is true.
   * The caller sets both.
   */
  Quaternion Orientation;
  bool HasOrientation = false;
  ///@}
  /** Number of requests that the hand with the tool had finished (BakedVolume::Others). */
  std::size_t OthersRequests = 0;
  bool IsSpinning = false; ///< whether the tool spins in this tick; the caller sets it
  ///@{
  /** Results of the last tick that CarriedProxy.h needs. */
  double CarriedTo = 0.0;       ///< data time of the last tick
  double Stiffness = 0.0;       ///< stiffness k (N/m)
  double SurfaceStrength = 0.0; ///< surface strength T_N W_d (N)
  ///@}
};

} // namespace VolumeHaptics

#endif
