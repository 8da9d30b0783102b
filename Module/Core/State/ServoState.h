// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state that a tick of the servo passes to the next one, in device space (metres, newtons)
 * except for LocalState.
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

/**
 * Limit of a tip's coordinates (m), so that their squares do not overflow. It is far beyond any
 * hand.
 */
constexpr double FarthestTip = 1e9;

/** The state from which the next tick starts. */
struct ServoState : ToolStates
{
  Vector3 Proxy;
  Vector3 PreviousTip;
  bool Enabled = false; ///< if false, the next tick puts the proxy on the tip, without a force
  PreciseState Precise;
  /**
   * Remainder of the force, which the hand feels in addition to the law's force. Only the law's
   * force moves the proxy.
   */
  ReleaseState Release;
  LocalState Local;
  PrimitiveMemory Primitives;
  /** Results of the last label lookups. They only make the next lookups faster. */
  LabelMemory Labels;
  /** Data time of the tick. If the volume moves, the caller advances it before each tick. */
  double DataTime = 0.0;
  ///@{
  /**
   * Orientation of the stylus in this tick, for tools. It is a unit quaternion if HasOrientation is
   * true. The caller sets both.
   */
  Quaternion Orientation;
  bool HasOrientation = false;
  ///@}
  /**
   * Number of finished requests of the hand with the tool, as this hand has last seen it
   * (BakedVolume::Others).
   */
  std::size_t OthersRequests = 0;
  bool IsSpinning = false; ///< whether the tool spins in this tick; the caller sets it
  ///@{
  /** Results of the last tick, for CarriedProxy.h. */
  double CarriedTo = 0.0;       ///< data time of the last tick
  double Stiffness = 0.0;       ///< stiffness k (N/m)
  double SurfaceStrength = 0.0; ///< surface strength T_N W_d (N)
  ///@}
};

} // namespace VolumeHaptics

#endif
