// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One tick of the servo: from the tip to the force on the hand.
 *
 * Offline traces and the servo loop run exactly this code. It neither allocates, locks nor throws.
 * Everything is in device space: metres, newtons.
 */
#ifndef ServoTick_h
#define ServoTick_h

#include "LocalSurfaceSolver.h"
#include "MaterialLaw.h"
#include "PassiveSpring.h"

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

constexpr int ServoStateSize = 64;

/** A state for a file: every number of it, in the order of the structs. */
std::array<double, ServoStateSize> ToNumbers(const ServoState& state) noexcept;
ServoState FromNumbers(const std::array<double, ServoStateSize>& numbers) noexcept;
/** False for numbers that no tick leaves, as a file may hold any. */
bool AreOfAState(const std::array<double, ServoStateSize>& numbers) noexcept;

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

/**
 * Advances the state by one tick and writes what happened.
 *
 * The first tick after enabling sets the proxy on the tip with zero force. A tip that is not finite, or a
 * million kilometres away, gives zero force and disables the state. The answer is for LOCAL_SURFACE only.
 */
void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record,
  const LocalAnswer& answer = LocalAnswer::Simulated()) noexcept;

/**
 * The part of a tick's force (N) that is drag, which only takes energy; for FORCE_FIELD, zero for the methods that pull
 * with a spring.
 */
Vector3 FindDrag(
  const HapticModel& model, const Vector3& previousTip, const TickRecord& record) noexcept;

/**
 * Takes the state from one placement of the device to another. The proxy rests on the volume: when the
 * volume moves under the hand, it goes along. From one region of a volume to another the state stays as it is.
 */
void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state) noexcept;

} // namespace VolumeHaptics

#endif
