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
#include "Core/State/BurrState.h"
#include "Core/State/LocalState.h"
#include "Core/State/NeedleState.h"
#include "Core/State/PreciseState.h"
#include "Core/State/PrimitiveMemory.h"
#include "Core/State/ProxyRelease.h"
#include "Core/State/ShellState.h"
#include "Core/State/TickRecord.h"

namespace VolumeHaptics
{

/** No hand is farther away (m); squares of smaller distances do not overflow. */
constexpr double FarthestTip = 1e9;

/** The state from which the next tick goes on. */
struct ServoState
{
  Vector3 Proxy;
  Vector3 PreviousTip;
  bool Enabled = false; ///< if false, the next tick puts the proxy on the tip with no force
  PreciseState Precise;
  ReleaseState Release; ///< what the hand feels beside the law, whose proxy the state has
  LocalState Local;
  PrimitiveMemory Primitives;
  LabelMemory Labels; ///< only saves time
  /** The data time of the tick: the caller advances it, if the volume moves. */
  double DataTime = 0.0;
  ///@{
  /** Of the stylus in this tick, for tools; the caller sets it. A unit quaternion if valid. */
  Quaternion Orientation;
  bool HasOrientation = false;
  ///@}
  bool IsSpinning = false; ///< of a burr, in this tick; the caller sets it
  NeedleState Needle;
  ShellState Shell; ///< together with ToolMemory
  BurrState Burr;
  ///@{
  /** Of the last tick, for CarriedProxy.h. */
  double CarriedTo = 0.0;       ///< its data time
  double Stiffness = 0.0;       ///< N/m
  double SurfaceStrength = 0.0; ///< T_N W_d, N
  ///@}
};

} // namespace VolumeHaptics

#endif
