// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a tick of the servo leaves: the state that the next tick goes on from, and the record of
 * what it found and did.
 *
 * Everything is in device space (metres, newtons), but for LocalState.
 */
#ifndef ServoState_h
#define ServoState_h

#include "Core/Solvers/LocalSurface/LocalSurface.h"
#include "Core/Solvers/MaterialLaw.h"
#include "Core/Solvers/PassiveSpring.h"

#include <cstdint>
#include <limits>

namespace VolumeHaptics
{

enum class ContactState : std::uint8_t
{
  Free = 0,       ///< no surface holds the proxy
  Sticking = 1,   ///< a surface holds it, friction too
  Sliding = 2,    ///< it slides over a surface
  Penetrating = 3 ///< it is pushed through a surface
};

/** A place as PRECISE sees it. */
struct Spot : Place
{
  double Value = 0.0; ///< the estimator's own
  double Slope = 0.0; ///< of Value along the normal, per metre; 0 without a gradient
};

/** What only PRECISE keeps from tick to tick. */
struct PreciseState
{
  static constexpr double Unknown = std::numeric_limits<double>::max();

  Vector3 ReachedTip;  ///< where the tip was when the solver's budget was spent; else the tip
  double Level = 0.0;  ///< the estimator's value on the surface that holds the proxy
  bool IsHeld = false; ///< whether Level means anything
  PassiveSpring Spring;
  double Gain = 1.0;      ///< by which a tick's way was longer than what its beginning asked for
  Spot Here;              ///< the place where the proxy was when it was last looked up
  double Stray = Unknown; ///< by how many voxels, at most, the proxy has left it since
};

/** What LOCAL_SURFACE keeps from tick to tick; in the world. */
struct LocalState
{
  LocalSurface Surface;
  Vector3 Place;            ///< of the proxy on it
  bool IsHeld = false;      ///< whether Place means anything
  Vector3 Tip;              ///< after the last tick
  Vector3 Fading;           ///< what is felt beyond Place - Tip, for a while
  double Fall = 0.0;        ///< by how much Fading gets shorter in a tick
  std::uint32_t Age = 0;    ///< ticks since Asked
  std::uint32_t Number = 0; ///< of Asked
  LocalQuestion Asked;
};

/** No hand is farther away (m); squares of what is nearer do not overflow. */
constexpr double FarthestTip = 1e9;

/** What a tick keeps for the next one. */
struct ServoState
{
  Vector3 Proxy;
  Vector3 PreviousTip;
  bool Enabled = false; ///< when false, the next tick puts the proxy on the tip with no force
  PreciseState Precise;
  LocalState Local;
};

/** What a tick found and did. The place is that of the materials that the tick used. */
struct TickRecord : Place
{
  Vector3 Tip;
  Vector3 Proxy;              ///< after the tick
  Vector3 Force;              ///< N, on the hand
  double NormalForce = 0.0;   ///< N, magnitude before the drag step
  double FrictionForce = 0.0; ///< N, magnitude before the drag step
  double DragForce = 0.0;     ///< N, stiffness times the distance that the drag step went back
  ContactState Contact = ContactState::Free;
  bool IsUnfinished = false; ///< PRECISE spent its budget: the force is that of a tip some way back
  bool IsRenewed = false;    ///< LOCAL_SURFACE got an answer from the slow loop
};

} // namespace VolumeHaptics

#endif
