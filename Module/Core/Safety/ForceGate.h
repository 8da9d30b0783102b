// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state machine that decides whether force may flow.
 *
 * Orders of the owner and findings of the servo loop are events. The result is a state, a share of
 * the force from 0 to 1, and a reason. SafetyStage.h multiplies the force by the share, limits its
 * growth, and cuts it in the states in which no force may flow.
 *
 * States
 * ------
 *
 *   Disarmed    no force; it ends at once
 *   Fault       no force; it ends at once. The reason names the fault until Arm is called
 *   Fading      the share falls to 0 within FadeTime, after FadeOut, because the owner is silent or
 *               because the loop is unstable
 *   Holding     the same for as long as it is held, for example during long work
 *   Retreating  no samples: the last force falls to zero (SafetyStage), and no new force flows
 *   Confirming  the volume is not felt: small pushes test the device's signs (SignCheck.h)
 *   Ramping     the share rises from 0 to 1 over SafetyLimits::RampTime
 *   Armed       the whole force flows, unless data are missing
 *
 * The last six states are *open*. A hold may begin in any state and is not ended by other orders,
 * and samples may be missing during a fade. The gate therefore stores each cause, and its open
 * state is the first one in the list whose cause exists. Holding and Retreating are separate
 * states, because the force ends differently than in Fading, and returns by itself.
 *
 * Events
 * ------
 *
 * "open" means the first open state of the list whose cause exists, and "-" means that the state
 * does not change.
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
 *   ReportFault               - (m)       - (m)          Fault
 *   ReportGap                 -           -              open (h)
 *   ReportJump                -           -              open (j)
 *   ReportCommand of zero:
 *     the end of a retreat    - (b)       - (b)          open (b)
 *     the end of a fade       -           Disarmed (d)   Disarmed; Fault after ReportSilence and
 *                                                        ReportUnstable
 *   ReportData                -           -              - (i)
 *
 *   (a) Ends a fade and a retreat; the ramp begins at 0.
 *   (b) The proxy restarts at the tip (DrainRestart), so no force is wanted until the tip moves.
 *   (c) Changes nothing while force flows, unless the force fades or other orders came at the same
 *       time.
 *   (d) The fault remains the reason.
 *   (e) The share of the data falls to 0 and rises again, as in Fading (GetOpening).
 *   (f) Stored until Arm.
 *   (g) A hold that has begun continues until no force flows. After that, the ramp begins at 0.
 *   (h) The ramp begins at 0. The cause of Retreating exists while samples are missing or force
 *       flows.
 *   (i) Moves the opening towards the share of the data in memory, at most by 1 in FadeTime.
 *   (j) The ramp begins at 0.
 *   (k) Until SetClutched(false), Arm only ends a fade and lets the force return afterwards.
 *   (l) The force returns with SetClutched(false), unless the gate was fading after FadeOut.
 *   (m) Acts like Arm if the force is to return. It does not return after Disarm, FadeOut,
 *       ReportNotReady or DeviceLost, which is then a fault.
 *
 * Faults, Disarm and the clutch take effect in the same tick. When the gate opens, the share never
 * jumps: the ramp takes RampTime, and the opening FadeTime.
 *
 * Share
 * -----
 *
 * While the gate is open and the force does not retreat, share = opening * ramp. Otherwise it is 0.
 * While the gate is unconfirmed, the ramp stays at 0, and the opening is the share of the pushes.
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
 * The reason why the share is below 1. Recordings store these numbers in the arrays Reason and
 * Fault.
 */
enum class GateReason : std::uint8_t
{
  None,       ///< the whole force is sent
  NotFinite,  ///< a fault: a force or a tip is not finite
  OverSpeed,  ///< a fault: the tip is faster than SafetyLimits::MaximumSpeed
  DeviceLost, ///< a fault: the device is lost
  /** A fault after the fade: the owner was silent for longer than SafetyLimits::AttentionTime. */
  Unattended,
  Ordered,   ///< not armed yet, disarmed, or fading out after FadeOut
  NotReady,  ///< the device was not ready; call Arm again once it is ready
  LongWork,  ///< held by the owner, for example during long work
  NoSamples, ///< no sample came within SafetyLimits::WatchdogTime
  NoData,    ///< some samples of the volume around the tip are missing (Residency.h)
  Rising, ///< the force rises after Arm, after a hold, a gap or missing data, or with a new model
  Confirming, ///< small pushes test the device's signs
  Unmoved,    ///< a fault: the pushes moved the tip too little, or the tip moved by itself
  WrongSign,  ///< a fault: the device moves against the force
  /**
   * A fault: the device runs away against its force (PortObserver.h) or oscillates
   * (EnergyObserver.h).
   */
  Active,
  Clutched ///< the hand moves while the tip stays (clutch); the force returns by itself afterwards
};

constexpr bool IsFault(GateReason reason) noexcept
{
  return (reason >= GateReason::NotFinite && reason <= GateReason::Unattended) ||
    reason == GateReason::Unmoved || reason == GateReason::WrongSign ||
    reason == GateReason::Active;
}
/** Returns the fault that Arm must clear, or None. */
constexpr GateReason ComputeFault(GateState state, GateReason reason) noexcept
{
  const bool isShut = state == GateState::Disarmed || state == GateState::Fault;
  return isShut && IsFault(reason) ? reason : GateReason::None;
}

class ForceGate
{
public:
  /** Shortest time (s) in which the opening changes from 0 to 1 or back. */
  static constexpr double FadeTime = 0.05;

  ///@{
  /**
   * Orders, given before a tick. Arm returns true if it changed anything; earlier contact must then
   * be ignored. `isSole` is false if other orders came at the same time, because one of them may
   * have been Disarm.
   */
  bool Arm(bool isSole = true) noexcept;
  void Disarm() noexcept;
  void FadeOut() noexcept;
  void SetHeld(bool held) noexcept;
  /** Sets whether the device's signs must still be confirmed. */
  void SetUnconfirmed(bool unconfirmed) noexcept;
  /** Sets whether the gate is clutched. Returns true if this has armed the gate. */
  bool SetClutched(bool clutched) noexcept;
  ///@}

  ///@{
  /**
   * ReportSilence() reports that the owner was silent for longer than SafetyLimits::AttentionTime,
   * and ReportNotReady() that the device is not ready.
   */
  void ReportSilence() noexcept;
  void ReportNotReady() noexcept;
  ///@}

  /** Reports that a new model would make the force jump. */
  void ReportJump() noexcept;
  /**
   * Reports how much of the data is in memory in this tick: 1, or the residency. `period` is in s.
   */
  void ReportData(double residency, double period) noexcept;

  ///@{
  /**
   * SafetyStage calls these functions in this order. First, ReportFault() or, for a loop that
   * oscillates although it is damped, ReportUnstable(), which lets the force fade and then ends in
   * a fault. Then ReportGap() for missing samples. Then one of Pass(), ReportRetreat() and Cut();
   * Pass() returns the share (or that of the pushes) and raises the ramp by a step. Last,
   * ReportCommand(), which reports whether the device receives a force.
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
  /** Returns the share of the last tick, 0 to 1. */
  double GetShare() const noexcept { return this->Share; }
  /**
   * Returns the opening, 0 to 1. It is the share without the ramp, and depends on fades, holds and
   * missing data.
   */
  double GetOpening() const noexcept { return this->Opening; }
  /** Returns whether an order reduces the opening to 0, whatever data are in memory. */
  bool IsClosing() const noexcept { return this->Held || this->Ending != End::None; }
  /**
   * Returns whether samples are missing, so that the last force falls or has fallen to zero.
   */
  bool IsRetreating() const noexcept { return this->Retreats; }
  bool IsUnconfirmed() const noexcept { return this->Unconfirmed; }
  /** Returns whether the gate is held and the device receives no force. */
  bool IsAtRest() const noexcept { return this->Rests; }

  /**
   * Returns whether an event requires the proxy to restart at the tip. Returns true only once per
   * event.
   */
  bool DrainRestart() noexcept;

private:
  /** State that follows a fade. */
  enum class End : std::uint8_t
  {
    None,
    Disarmed,
    Fault
  };
  void Shut(GateReason why) noexcept;
  void EndFade() noexcept;
  void EndInFault(GateReason fault) noexcept;
  /** Computes the open state from the stored causes. */
  void Settle() noexcept;

  GateState State = GateState::Disarmed;
  GateReason Cause = GateReason::Ordered; ///< reason of the states Disarmed and Fault
  End Ending = End::None;
  GateReason EndFault = GateReason::None; ///< fault that follows the fade
  bool Held = false;
  bool Unconfirmed = false;
  bool Clutched = false;
  bool Returns = false; ///< whether the force returns after the clutch ends
  bool Rests = false;
  bool Retreats = false;
  bool Retreated = false; ///< whether the force was retreating at the end of the last tick
  bool Flows = false;     ///< whether the last command contained a force
  bool Restarts = false;
  double Data = 1.0; ///< share of the data that are in memory
  double Opening = 1.0;
  double Ramp = 0.0;
  double Share = 0.0;
};

} // namespace VolumeHaptics

#endif
