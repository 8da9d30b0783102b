// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The one state machine that decides whether force may flow.
 *
 * Orders of the owner and the servo loop's findings are events. The result is a state, a share of
 * the force from 0 to 1, and one reason. SafetyStage.h multiplies the force by the share, limits
 * its growth, and cuts it in the states in which nothing may flow.
 *
 * States
 * ------
 *
 *   Disarmed    no force, from the tick on in which it is entered
 *   Fault       no force, from that tick on; the reason names the fault, and stays until Arm
 *   Fading      the share falls to 0 within FadeTime, after FadeOut, because the owner is silent or
 *               because the loop is unstable
 *   Holding     the same for as long as it is held, for example during long work
 *   Retreating  no samples: the last force falls to zero by itself (SafetyStage), no new one flows
 *   Confirming  the volume is not felt: small pushes find out the device's signs (SignCheck.h)
 *   Ramping     the share rises from 0 to 1 over SafetyLimits::RampTime
 *   Armed       the whole force flows, as far as the data are there
 *
 * The last six are *open*. A hold may begin in any state and outlives all orders, and samples may
 * be missing during a fade. So the gate remembers each cause, and its open state is the first in
 * the list whose cause exists. Holding and Retreating are states of their own because the force
 * ends differently than in Fading, and comes back by itself.
 *
 * Events
 * ------
 *
 * "open" stands for: the open state by the list above. "-": the state stays.
 *
 *   event                     Disarmed    Fault          open
 *   Arm                       open (a, b) open (a, b)    open (a, b, c)
 *   Disarm                    -           Disarmed (d)   Disarmed
 *   FadeOut                   - (e)       - (e)          Fading
 *   SetHeld(true)             - (f)       - (f)          Holding, unless Fading
 *   SetHeld(false)            - (b, f)    - (b, f)       open (b, g)
 *   SetUnconfirmed(true)      - (f)       - (f)          Confirming, unless one above it
 *   SetUnconfirmed(false)     - (b, f)    - (b, f)       open (b); the ramp begins at 0
 *   SetClutched(true)         - (k)       - (k)          Disarmed (l)
 *   SetClutched(false)        - (m)       - (m)          -
 *   ReportSilence             -           -              Fading, unless held
 *   ReportUnstable            -           -              Fading
 *   ReportNotReady            -           Disarmed (d)   Disarmed
 *   ReportFault               -           -              Fault
 *   ReportGap                 -           -              open (h)
 *   ReportJump                -           -              open (j)
 *   ReportCommand of zero:
 *     the end of a retreat    - (b)       - (b)          open (b)
 *     the end of a fade       -           Disarmed (d)   Disarmed; Fault after ReportSilence and
 *                                                        ReportUnstable
 *   ReportData                -           -              - (i)
 *
 *   (a) Ends a fade and a retreat; the ramp begins at 0.
 *   (b) The proxy begins at the tip: DrainRestart. No force is wanted then, until the tip moves.
 *   (c) Changes nothing while force flows, unless it fades, or other orders came at the same time.
 *   (d) The fault stays the reason.
 *   (e) The share of the data falls to 0 and rises again, as in Fading: see GetOpening.
 *   (f) Remembered for Arm.
 *   (g) A hold that has not come to its end goes on until no force flows. Then the ramp begins at
 *       0.
 *   (h) The ramp begins at 0. The cause of Retreating exists as long as samples are missing or
 *       force flows.
 *   (i) Moves the opening towards the share of the data that are there, by 1 in FadeTime.
 *   (j) The ramp begins at 0.
 *   (k) Until SetClutched(false), Arm only has the force return then, and ends a fade.
 *   (l) The force returns with SetClutched(false), unless the gate was fading after FadeOut.
 *   (m) As Arm, if the force returns. Disarm, FadeOut and ReportNotReady since then prevent it.
 *
 * Faults, Disarm and the clutch act in the tick in which they come. Nothing that opens the gate
 * makes the share jump: it rises by RampTime, and the opening by FadeTime.
 *
 * Share
 * -----
 *
 * While the gate is open and the force does not retreat: share = opening * ramp. Else 0. While it
 * is unconfirmed, the ramp stays at 0, and the opening is the share of the pushes.
 */
#ifndef ForceGate_h
#define ForceGate_h

#include <cstdint>

namespace VolumeHaptics
{

enum class GateState : std::uint8_t
{
  Disarmed,
  Ramping,
  Armed,
  Fading,
  Holding,
  Retreating,
  Fault,
  Confirming
};

/**
 * Why the share is not 1. The arrays Reason and Fault of recordings have these numbers.
 */
enum class GateReason : std::uint8_t
{
  None,       ///< the whole force passes
  NotFinite,  ///< a fault: a force or a tip that is not a finite number
  OverSpeed,  ///< a fault: a tip that is faster than SafetyLimits::MaximumSpeed
  DeviceLost, ///< a fault: the device is lost
  Unattended, ///< a fault after the fade: the owner was silent for SafetyLimits::AttentionTime
  Ordered,    ///< not armed yet, disarmed, or fading out after FadeOut
  NotReady,   ///< the device was not ready; Arm is needed when it is
  LongWork,   ///< held by the owner
  NoSamples,  ///< no sample came within SafetyLimits::WatchdogTime
  NoData,     ///< some samples of the volume around the tip are missing (Residency.h)
  Rising,     ///< the force rises after Arm, a hold, a gap, missing data or a new model
  Confirming, ///< small pushes find out the device's signs
  Unmoved,    ///< a fault: the pushes moved the tip too little, or it moved by itself
  WrongSign,  ///< a fault: the device moves against the force
  Active,     ///< a fault: the device runs away against its force (PortObserver.h), or swings by
              ///< itself (EnergyObserver.h)
  Clutched    ///< the hand moves without the tip (clutch); the force returns by itself
};

constexpr bool IsFault(GateReason reason) noexcept
{
  return (reason >= GateReason::NotFinite && reason <= GateReason::Unattended) ||
    reason == GateReason::Unmoved || reason == GateReason::WrongSign ||
    reason == GateReason::Active;
}
/** Returns the fault that needs Arm; None if there is none. */
constexpr GateReason ComputeFault(GateState state, GateReason reason) noexcept
{
  const bool isShut = state == GateState::Disarmed || state == GateState::Fault;
  return isShut && IsFault(reason) ? reason : GateReason::None;
}

class ForceGate
{
public:
  /** The shortest time (s) in which the opening changes by 1. */
  static constexpr double FadeTime = 0.05;

  ///@{
  /**
   * Orders, given before a tick. Arm returns true if it changes anything; the contact before then
   * no longer counts. `isSole` is false if other orders came at the same time, one of which may
   * have been Disarm.
   */
  bool Arm(bool isSole = true) noexcept;
  void Disarm() noexcept;
  void FadeOut() noexcept;
  void SetHeld(bool held) noexcept;
  /** Sets whether the device's signs have yet to be confirmed. */
  void SetUnconfirmed(bool unconfirmed) noexcept;
  /** Returns true if the call armed the gate, as Arm does. */
  bool SetClutched(bool clutched) noexcept;
  ///@}

  ///@{
  /**
   * ReportSilence reports that the owner was silent for longer than SafetyLimits::AttentionTime,
   * ReportNotReady that the device is not ready.
   */
  void ReportSilence() noexcept;
  void ReportNotReady() noexcept;
  ///@}

  /** Reports that a new model would let the force leap. */
  void ReportJump() noexcept;
  /** Sets the share of the data for this tick of a period (s): 1, or the residency. */
  void ReportData(double residency, double period) noexcept;

  ///@{
  /**
   * SafetyStage calls these in this order: ReportFault, or ReportUnstable for a loop that swings
   * although it is damped, so that the force fades with a fault; ReportGap for missing samples;
   * then Pass (which returns the share, that of the pushes if there are some, and raises the ramp
   * by a step), ReportRetreat or Cut; and last ReportCommand, which tells whether force flows to
   * the device.
   */
  void ReportFault(GateReason fault) noexcept;
  void ReportUnstable() noexcept;
  void ReportGap(bool isStale, bool flows) noexcept;
  double Pass(double step) noexcept;
  void ReportRetreat(bool isStale, bool flows) noexcept;
  void Cut() noexcept;
  void ReportCommand(bool flows) noexcept;
  ///@}

  GateState GetState() const noexcept { return this->State; }
  GateReason GetReason() const noexcept;
  GateReason GetFault() const noexcept { return ComputeFault(this->State, this->GetReason()); }
  bool IsOpen() const noexcept
  {
    return this->State != GateState::Disarmed && this->State != GateState::Fault;
  }
  /** Returns the share in the last tick: 0 to 1. */
  double GetShare() const noexcept { return this->Share; }
  /**
   * Returns the share that remains after fades, holds and missing data, without the ramp: 0 to 1.
   */
  double GetOpening() const noexcept { return this->Opening; }
  /** Returns whether an order moves the opening to 0, independent of the data. */
  bool IsClosing() const noexcept { return this->Held || this->Ending != End::None; }
  /**
   * Returns whether the last force falls to zero by itself, or has done so, because samples are
   * missing.
   */
  bool IsRetreating() const noexcept { return this->Retreats; }
  bool IsUnconfirmed() const noexcept { return this->Unconfirmed; }
  /** Returns whether the gate is held and no force flows any more. */
  bool IsAtRest() const noexcept { return this->Rests; }

  /** Returns true once after an event that makes the proxy begin at the tip. */
  bool DrainRestart() noexcept;

private:
  /** How a fade ends. */
  enum class End : std::uint8_t
  {
    None,
    Disarmed,
    Fault
  };
  void Shut(GateReason why) noexcept;
  void EndFade() noexcept;
  void EndInFault(GateReason fault) noexcept;
  /** Sets the open state from its causes. */
  void Settle() noexcept;

  GateState State = GateState::Disarmed;
  GateReason Cause = GateReason::Ordered; ///< the reason in Disarmed and Fault
  End Ending = End::None;
  GateReason EndFault = GateReason::None; ///< the fault at the end of a fade
  bool Held = false;
  bool Unconfirmed = false;
  bool Clutched = false;
  bool Returns = false; ///< whether the force returns after the clutch
  bool Rests = false;
  bool Retreats = false;
  bool Retreated = false; ///< whether the force had retreated at the end of the last tick
  bool Flows = false;     ///< whether the last command had force
  bool Restarts = false;
  double Data = 1.0; ///< the share of the data
  double Opening = 1.0;
  double Ramp = 0.0;
  double Share = 0.0;
};

} // namespace VolumeHaptics

#endif
