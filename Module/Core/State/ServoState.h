// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state that a tick of the servo passes to the next one.
 *
 * Everything is in device space (metres, newtons) except LocalState.
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

namespace VolumeHaptics
{

/** The farthest tip (m) of any hand; squares of smaller distances do not overflow. */
constexpr double FarthestTip = 1e9;

/** The state from which the next tick goes on. */
struct ServoState : ToolStates
{
  Vector3 Proxy;
  Vector3 PreviousTip;
  bool Enabled = false; ///< if false, the next tick puts the proxy on the tip with no force
  PreciseState Precise;
  ReleaseState Release; ///< felt in addition to the law, which determines the proxy
  LocalState Local;
  PrimitiveMemory Primitives;
  LabelMemory Labels; ///< memory of label lookups, for speed only
  /** The data time of the tick: the caller advances it, if the volume moves. */
  double DataTime = 0.0;
  ///@{
  /**
   * The stylus's orientation in this tick, for tools: a unit quaternion if valid. The caller sets
   * it.
   */
  Quaternion Orientation;
  bool HasOrientation = false;
  ///@}
  bool IsSpinning = false; ///< whether the tool spins in this tick; the caller sets it
  ///@{
  /** The last tick sets these for CarriedProxy.h. */
  double CarriedTo = 0.0;       ///< data time of the last tick
  double Stiffness = 0.0;       ///< N/m
  double SurfaceStrength = 0.0; ///< T_N W_d, N
  ///@}
};

} // namespace VolumeHaptics

#endif
