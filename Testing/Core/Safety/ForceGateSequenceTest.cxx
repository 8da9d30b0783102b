// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the force gate in random sequences of events with a model that has a flag for each
 * cause.
 */

#include "Core/Safety/ForceGate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <random>

using namespace VolumeHaptics;

namespace
{

/// A simple model of the gate: a set of flags, with one rule for each.
struct Flags
{
  bool IsArmed = false;
  GateReason Fault = GateReason::None;
  bool FadesOut = false;
  GateReason EndFault = GateReason::None; ///< takes effect at the end of a fade
  bool IsHeld = false;
  bool IsClutched = false;
  bool Returns = false;
  bool IsAtRest = false;
  bool Retreats = false;
  bool Restarts = false;
  double Ramp = 0.0;
  double Opening = 1.0;
  double Share = 0.0;
  bool Flowed = false;

  bool CanFlow() const { return this->IsArmed && this->Fault == GateReason::None; }

  void Follow(bool holdWanted)
  {
    const bool was = this->IsHeld;
    this->IsHeld = holdWanted || (was && !this->IsAtRest);
    if (was && !this->IsHeld)
    {
      this->Restarts = true;
      this->Ramp = 0.0;
    }
  }
  void Arm(bool isSole)
  {
    if (this->IsClutched)
    {
      this->Returns = true;
      this->EndFadeOut();
      return;
    }
    const bool flows = isSole && this->IsArmed && !this->FadesOut && this->Flowed;
    this->EndFadeOut();
    if (!flows)
    {
      this->Restarts = true;
      this->IsArmed = true;
      this->Fault = GateReason::None;
      this->Ramp = 0.0;
      this->Retreats = false;
    }
  }
  void Disarm()
  {
    this->EndFadeOut();
    this->Returns = false;
    this->IsArmed = false;
  }
  void FadeOut()
  {
    this->FadesOut = true;
    this->Returns = false;
  }
  void Clutch(bool on)
  {
    const bool begins = on && !this->IsClutched;
    this->IsClutched = on;
    if (begins && this->CanFlow())
    {
      const bool returns = !this->FadesOut || this->EndFault != GateReason::None;
      this->Disarm();
      this->Returns = returns;
    }
    if (!on && this->Returns)
    {
      this->Returns = false;
      this->Arm(false);
    }
  }
  void ReportSilence()
  {
    if (this->CanFlow() && !this->IsHeld)
    {
      this->FadeTo(GateReason::Unattended);
    }
  }
  void ReportUnstable()
  {
    if (this->CanFlow())
    {
      this->FadeTo(GateReason::Active);
    }
  }
  void FadeTo(GateReason fault)
  {
    this->EndFault = this->EndFault == GateReason::None ? fault : this->EndFault;
    this->FadesOut = true;
  }
  void EndFadeOut()
  {
    this->EndFault = GateReason::None;
    this->FadesOut = false;
  }
  void UpdateData(double there, double period)
  {
    const double wanted = this->FadesOut || this->IsHeld ? 0.0 : there;
    const double most = period / 0.05;
    this->Opening = wanted > this->Opening + most ? this->Opening + most
      : wanted < this->Opening - most             ? this->Opening - most
                                                  : wanted;
  }
  /// Ends a tick: applies the faults, and decides whether a force acts.
  void Finish(GateReason fault, bool gap, bool isStale, bool flows, double step)
  {
    const bool retreated = this->Retreats;
    if (this->CanFlow())
    {
      this->Fault = fault;
    }
    else if (this->Returns && fault == GateReason::DeviceLost)
    {
      this->IsArmed = true;
      this->Fault = fault;
      this->Returns = false;
    }
    bool hasForce = false;
    if (!this->CanFlow())
    {
      this->Ramp = this->Share = 0.0;
      this->Retreats = false;
    }
    else
    {
      if (gap)
      {
        this->Ramp = 0.0;
        this->Retreats = isStale || this->Flowed;
      }
      hasForce = flows;
      if (this->Retreats)
      {
        this->Share = 0.0;
        this->Retreats = isStale || flows;
      }
      else
      {
        this->Share = this->Opening * this->Ramp;
        this->Ramp = std::min(1.0, this->Ramp + step);
      }
    }
    if (this->FadesOut && this->Opening == 0.0 && !hasForce)
    {
      if (this->EndFault == GateReason::None)
      {
        this->IsArmed = false;
      }
      else if (this->CanFlow())
      {
        this->Fault = this->EndFault;
      }
      this->EndFadeOut();
    }
    this->IsAtRest = this->IsHeld && !hasForce;
    this->Opening = this->IsAtRest ? 0.0 : this->Opening;
    this->Restarts |= (retreated || this->Retreats) && !hasForce;
    this->Flowed = hasForce;
  }
};

} // namespace

TEST(ForceGate, DoesInRandomSequencesWhatFlagsWouldDo)
{
  constexpr int Sequences = 20000;
  constexpr int Ticks = 100;
  constexpr GateReason Faults[] = { GateReason::NotFinite, GateReason::OverSpeed,
    GateReason::DeviceLost, GateReason::Active };
  std::mt19937 engine(1);
  const auto chance = [&engine](double p) { return engine() * 0x1p-32 < p; };
  const auto pick = [&engine](std::initializer_list<double> of)
  { return of.begin()[engine() % of.size()]; };
  int seen[7] = {};
  for (int sequence = 0; sequence < Sequences; ++sequence)
  {
    ForceGate gate;
    Flags flags;
    const double orders = pick({ 0.01, 0.1, 0.5 });
    const double trouble = pick({ 0.0, 0.01, 0.1 });
    const double period = pick({ 1e-3, 5e-3, 0.02 });
    const double step = pick({ 0.002, 0.1, 1.0 });
    bool isHoldWanted = false;
    bool isClutched = false;
    bool isStale = false;
    double there = 1.0;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      isHoldWanted = chance(orders) ? !isHoldWanted : isHoldWanted;
      gate.SetHeld(isHoldWanted);
      flags.Follow(isHoldWanted);
      if (tick == 0 || chance(orders))
      {
        const bool isSole = chance(0.8);
        switch (tick == 0 ? 0 : engine() % 4)
        {
          case 0:
          case 1:
            gate.Arm(isSole);
            flags.Arm(isSole);
            break;
          case 2:
            gate.Disarm();
            flags.Disarm();
            break;
          default:
            gate.FadeOut();
            flags.FadeOut();
        }
      }
      isClutched = isClutched != chance(isClutched ? 0.3 : 0.2 * orders);
      gate.SetClutched(isClutched);
      flags.Clutch(isClutched);
      if (chance(0.3 * trouble))
      {
        gate.ReportSilence();
        flags.ReportSilence();
      }
      if (chance(0.1 * trouble))
      {
        gate.ReportUnstable();
        flags.ReportUnstable();
      }
      if (chance(0.3 * trouble))
      {
        gate.ReportNotReady();
        flags.IsArmed = flags.Returns = false;
      }
      ASSERT_EQ(gate.DrainRestart(), flags.Restarts) << sequence << ", " << tick;
      flags.Restarts = false;

      if (chance(0.3 * trouble))
      {
        gate.ReportJump();
        flags.Ramp = flags.CanFlow() ? 0.0 : flags.Ramp;
      }
      there = chance(trouble) ? pick({ 0.0, 0.4, 1.0 }) : there;
      gate.ReportData(there, period);
      flags.UpdateData(there, period);

      const double before = gate.GetShare();
      const bool flowed = flags.Flowed;
      const GateReason fault = chance(0.3 * trouble) ? Faults[engine() % 4] : GateReason::None;
      const bool wasStale = isStale;
      isStale = chance(isStale ? 0.5 : trouble);
      const bool gap = isStale || wasStale;
      // The command may be non-zero while the opening is 0, and zero while the gate is open.
      const bool wants = chance(flags.Opening > 0.0 ? 0.8 : 0.3);
      flags.Finish(fault, gap, isStale, wants, step);
      if (fault != GateReason::None)
      {
        gate.ReportFault(fault);
      }
      const bool isOpen = gate.IsOpen();
      if (!isOpen)
      {
        gate.Cut();
      }
      else
      {
        if (gap)
        {
          gate.ReportGap(isStale, flowed);
        }
        gate.IsRetreating() ? gate.ReportRetreat(isStale, wants) : void(gate.Pass(step));
      }
      gate.ReportCommand(isOpen && wants);

      ASSERT_EQ(gate.GetState() != GateState::Disarmed, flags.IsArmed) << sequence << ", " << tick;
      ASSERT_EQ(gate.GetFault(), flags.Fault) << sequence << ", " << tick;
      ASSERT_EQ(gate.GetShare(), flags.Share) << sequence << ", " << tick;
      ASSERT_EQ(gate.GetOpening(), flags.Opening) << sequence << ", " << tick;
      ASSERT_EQ(gate.IsRetreating(), flags.Retreats) << sequence << ", " << tick;
      ASSERT_EQ(gate.IsAtRest(), flags.IsAtRest) << sequence << ", " << tick;
      const GateState expected = !flags.IsArmed ? GateState::Disarmed
        : !flags.CanFlow()                      ? GateState::Fault
        : flags.FadesOut                        ? GateState::Fading
        : flags.IsHeld                          ? GateState::Holding
        : flags.Retreats                        ? GateState::Retreating
        : flags.Ramp < 1.0                      ? GateState::Ramping
                                                : GateState::Armed;
      ASSERT_EQ(gate.GetState(), expected) << sequence << ", " << tick;
      ++seen[static_cast<int>(expected)];
      ASSERT_EQ(gate.GetReason() == GateReason::None, gate.GetShare() == 1.0)
        << sequence << ", " << tick;
      // In one tick, the opening rises at most by the ramp's step plus the step of a fade.
      const double opens = period / ForceGate::FadeTime;
      ASSERT_GE(gate.GetShare(), 0.0);
      ASSERT_LE(gate.GetShare(), std::min(1.0, before + step + opens + 1e-12));
    }
  }
  EXPECT_GT(*std::min_element(seen, seen + 7), 10000);
}
