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

#include "HapticModel.h"

namespace VolumeHaptics
{

enum class ContactState : std::uint8_t
{
  Free = 0,       ///< no surface holds the proxy
  Sticking = 1,   ///< a surface holds it, friction too
  Sliding = 2,    ///< it slides over a surface
  Penetrating = 3 ///< it is pushed through a surface
};

/** What a tick keeps for the next one. */
struct ServoState
{
  Vector3 Proxy;
  Vector3 PreviousTip;
  bool Enabled = false; ///< when false, the next tick puts the proxy on the tip with no force
};

/** What a tick found and did. Materials, normal and gradient are those the tick used. */
struct TickRecord
{
  Vector3 Tip;
  Vector3 Proxy;                  ///< after the tick
  Vector3 Force;                  ///< N, on the hand
  double NormalForce = 0.0;       ///< N, magnitude before the drag step
  double FrictionForce = 0.0;     ///< N, magnitude before the drag step
  double DragForce = 0.0;         ///< N, stiffness times the distance that the drag step went back
  Vector3 Normal;                 ///< unit, into the structure
  double GradientMagnitude = 0.0; ///< scalar units per world unit
  double SurfaceValue = 0.0;      ///< V(x_s)
  double MediumValue = 0.0;       ///< V(x_v)
  double Stiffness = 0.0;         ///< k, N/m
  double Friction = 0.0;          ///< mu
  double Viscosity = 0.0;         ///< R, N
  double SurfaceStrength = 0.0;   ///< T_N W_d, N
  ContactState Contact = ContactState::Free;
};

/**
 * Advances the state by one tick and writes what happened.
 *
 * The first tick after enabling sets the proxy on the tip with zero force. A tip that is not finite, or a
 * million kilometres away, gives zero force and disables the state.
 */
void Tick(
  const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record) noexcept;

/**
 * Takes the state from one placement of the device to another. The proxy rests on the volume: when the
 * volume moves under the hand, it goes along.
 */
void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state) noexcept;

} // namespace VolumeHaptics

#endif
