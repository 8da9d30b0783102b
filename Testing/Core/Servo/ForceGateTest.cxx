// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The force gate: every event in every state, against a table that is written by hand; and random
 * sequences, against a model that keeps a flag for everything.
 */

#include "Core/Servo/ForceGate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

using namespace VolumeHaptics;

namespace
{

//------------------------------------------------------------------------------
// Every event in every state.

/// A letter for each state with its reason.
struct Outcome
{
  char Letter;
  GateState State;
  GateReason Reason;
};
constexpr Outcome Outcomes[] = {
  { 'a', GateState::Armed, GateReason::None },
  { 'r', GateState::Ramping, GateReason::Rising },
  { 'T', GateState::Retreating, GateReason::NoSamples },
  { 'H', GateState::Holding, GateReason::LongWork },
  { 'F', GateState::Fading, GateReason::Ordered },
  { 'S', GateState::Fading, GateReason::Unattended },
  { 'D', GateState::Disarmed, GateReason::Ordered },
  { 'N', GateState::Disarmed, GateReason::NotReady },
  { 'd', GateState::Disarmed, GateReason::OverSpeed },
  { 'O', GateState::Fault, GateReason::OverSpeed },
  { 'L', GateState::Fault, GateReason::DeviceLost },
  { 'U', GateState::Fault, GateReason::Unattended },
};

char LetterOf(const ForceGate& gate)
{
  for (const Outcome& outcome : Outcomes)
  {
    if (outcome.State == gate.GetState() && outcome.Reason == gate.GetReason())
    {
      return outcome.Letter;
    }
  }
  return '?';
}

enum Event
{
  Arm,            ///< while no force flows
  ArmFlowing,     ///< while force flows
  ArmAmongOthers, ///< the same, together with other orders
  Disarm,
  FadeOut,
  Hold,
  Release,       ///< while the hold may still fade
  ReleaseAtRest, ///< once no force flows
  Silence,
  NotReady,
  Lost,
  GapOver,       ///< samples were missing and are back; no force flows
  GapOn,         ///< samples are missing
  Force,         ///< a tick whose command is not zero
  NoForce,       ///< a tick whose command is zero
  NoForceClosed, ///< the same, with the opening where it goes
  Events
};

/// The causes: f an ordered fade, s a fade since the owner is silent, h a hold, r a retreat. D, d,
/// O and o stand for the shut states and for an open one.
struct Row
{
  const char* Causes;
  const char* Expected; ///< a letter an event
};
// clang-format off
constexpr Row Table[] = {
  // Arm: no force, force, among others; Disarm, FadeOut, Hold; Release: early, at rest; Silence;
  // NotReady, Lost; gap: over, on; command: force, zero, zero with the opening where it goes.
  { "D", "rrr" "DDD" "DDD" "ND" "DD" "DDD" },
  { "Df", "rrr" "DNN" "NNN" "NN" "NN" "NND" },
  { "Ds", "rrr" "DNN" "NNN" "NN" "NN" "NNN" },
  { "Dh", "HHH" "DDD" "DDD" "ND" "DD" "DDD" },
  { "Dfh", "HHH" "DNN" "NNN" "NN" "NN" "NND" },
  { "Dsh", "HHH" "DNN" "NNN" "NN" "NN" "NNN" },
  { "d", "rrr" "ddd" "ddd" "dd" "dd" "ddd" },
  { "df", "rrr" "ddd" "ddd" "dd" "dd" "ddd" },
  { "ds", "rrr" "ddd" "ddd" "dd" "dd" "ddd" },
  { "dh", "HHH" "ddd" "ddd" "dd" "dd" "ddd" },
  { "dfh", "HHH" "ddd" "ddd" "dd" "dd" "ddd" },
  { "dsh", "HHH" "ddd" "ddd" "dd" "dd" "ddd" },
  { "O", "rrr" "dOO" "OOO" "dO" "OO" "OOO" },
  { "Of", "rrr" "dOO" "OOO" "dO" "OO" "OOd" },
  { "Os", "rrr" "dOO" "OOO" "dO" "OO" "OOO" },
  { "Oh", "HHH" "dOO" "OOO" "dO" "OO" "OOO" },
  { "Ofh", "HHH" "dOO" "OOO" "dO" "OO" "OOd" },
  { "Osh", "HHH" "dOO" "OOO" "dO" "OO" "OOO" },
  { "o", "rar" "DFH" "aaS" "NL" "rT" "aaa" },
  { "or", "rTr" "DFH" "TrS" "NL" "rT" "Trr" },
  { "oh", "HHH" "DFH" "HrH" "NL" "HH" "HHH" },
  { "ohr", "HHH" "DFH" "HrH" "NL" "HH" "HHH" },
  { "of", "rrr" "DFF" "FFS" "NL" "FF" "FFD" },
  { "ofr", "rrr" "DFF" "FFS" "NL" "FF" "FFD" },
  { "ofh", "HHH" "DFF" "FFF" "NL" "FF" "FFD" },
  { "ofhr", "HHH" "DFF" "FFF" "NL" "FF" "FFD" },
  { "os", "rrr" "DSS" "SSS" "NL" "SS" "SSU" },
  { "osr", "rrr" "DSS" "SSS" "NL" "SS" "SSU" },
  { "osh", "HHH" "DSS" "SSS" "NL" "SS" "SSU" },
  { "oshr", "HHH" "DSS" "SSS" "NL" "SS" "SSU" },
};
// clang-format on

bool Has(const std::string& causes, char cause)
{
  return causes.find(cause) != std::string::npos;
}

/// The end of a tick, as SafetyStage reports it; the ramp stays where it is.
void Tick(ForceGate& gate, bool flows, bool isStale = false)
{
  if (!gate.IsOpen())
  {
    gate.Cut();
    flows = false;
  }
  else if (gate.IsRetreating())
  {
    gate.NoteRetreat(isStale, flows);
  }
  else
  {
    gate.Pass(0.0);
  }
  gate.NoteCommand(flows);
}

/// Brings a gate into the state of a row; with a ramp from 0 to 1, and force or not in an open one.
ForceGate Make(const std::string& causes, double ramp, bool flows)
{
  ForceGate gate;
  gate.Arm();
  gate.Pass(ramp);
  gate.Pass(0.0);
  gate.NoteCommand(flows);
  if (Has(causes, 's'))
  {
    gate.NoteSilence();
  }
  if (Has(causes, 'f'))
  {
    gate.FadeOut();
  }
  if (Has(causes, 'r'))
  {
    gate.NoteGap(true, flows);
    Tick(gate, flows, true);
  }
  if (causes[0] == 'd' || causes[0] == 'O')
  {
    gate.NoteFault(GateReason::OverSpeed);
    Tick(gate, false);
  }
  if (causes[0] == 'd' || (causes[0] == 'D' && causes.find_first_of("fs") != std::string::npos))
  {
    gate.NoteNotReady(); // it leaves a fade where it is
    Tick(gate, false);
  }
  else if (causes[0] == 'D')
  {
    gate.Disarm();
    Tick(gate, false);
  }
  if (Has(causes, 'h'))
  {
    gate.SetHeld(true);
  }
  gate.TakeRestart();
  return gate;
}

void Apply(ForceGate& gate, Event event)
{
  switch (event)
  {
    case Arm:
    case ArmFlowing:
      gate.Arm();
      break;
    case ArmAmongOthers:
      gate.Arm(false);
      break;
    case Disarm:
      gate.Disarm();
      break;
    case FadeOut:
      gate.FadeOut();
      break;
    case Hold:
      gate.SetHeld(true);
      break;
    case ReleaseAtRest:
      Tick(gate, false);
      gate.SetHeld(false);
      break;
    case Release:
      gate.SetHeld(false);
      break;
    case Silence:
      gate.NoteSilence();
      break;
    case NotReady:
      gate.NoteNotReady();
      break;
    case Lost:
      gate.NoteFault(GateReason::DeviceLost);
      break;
    case GapOver:
      gate.NoteGap(false, false);
      break;
    case GapOn:
      gate.NoteGap(true, false);
      break;
    case Force:
      Tick(gate, true);
      break;
    case NoForceClosed:
      gate.NoteData(1.0, ForceGate::FadeTime);
      Tick(gate, false);
      break;
    case NoForce:
      Tick(gate, false);
      break;
    case Events:
      break;
  }
}

/// Whether the proxy has to begin at the tip afterwards.
bool ExpectsRestart(const std::string& causes, Event event)
{
  const bool wasFault = causes[0] == 'd' || causes[0] == 'O';
  switch (event)
  {
    case Arm:
    case ArmFlowing:
    case ArmAmongOthers:
      return wasFault;
    case ReleaseAtRest:
      return Has(causes, 'h') || Has(causes, 'r');
    case NoForce:
    case NoForceClosed:
      return Has(causes, 'r');
    default:
      return false;
  }
}

} // namespace

TEST(ForceGate, DoesInEveryStateWhatTheTableSays)
{
  for (const Row& row : Table)
  {
    const std::string causes = row.Causes;
    ASSERT_EQ(std::strlen(row.Expected), static_cast<std::size_t>(Events)) << causes;
    for (const double ramp : { 0.25, 1.0 })
    {
      for (int i = 0; i < Events; ++i)
      {
        const auto event = static_cast<Event>(i);
        const bool flows = event == ArmFlowing || event == ArmAmongOthers || event == Release;
        ForceGate gate = Make(causes, ramp, flows);
        Apply(gate, event);
        char expected = row.Expected[i];
        expected = expected == 'a' && ramp < 1.0 ? 'r' : expected;
        EXPECT_EQ(LetterOf(gate), expected)
          << causes << ", event " << i << ", with the ramp at " << ramp;
        EXPECT_EQ(gate.IsOpen(), std::strchr("arTHFS", expected) != nullptr);
        EXPECT_EQ(gate.TakeRestart(), ExpectsRestart(causes, event)) << causes << ", event " << i;
        EXPECT_FALSE(gate.TakeRestart()) << "once";
        const GateReason fault = std::strchr("dO", expected) ? GateReason::OverSpeed
          : expected == 'L'                                  ? GateReason::DeviceLost
          : expected == 'U'                                  ? GateReason::Unattended
                                                             : GateReason::None;
        EXPECT_EQ(gate.GetFault(), fault) << causes << ", event " << i;
      }
    }
  }
}

TEST(ForceGate, OfAnOrderToArmSaysWhetherItBeginsAnew)
{
  for (const Row& row : Table)
  {
    const std::string causes = row.Causes;
    const bool fades = causes.find_first_of("fs") != std::string::npos;
    EXPECT_TRUE(Make(causes, 1.0, false).Arm()) << causes;
    EXPECT_TRUE(Make(causes, 1.0, true).Arm(false)) << causes;
    EXPECT_EQ(Make(causes, 1.0, true).Arm(), causes[0] != 'o' || fades) << causes;
  }
}

TEST(ForceGate, SharesRampAndOpening)
{
  ForceGate gate;
  gate.Arm();
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_DOUBLE_EQ(gate.Pass(0.1), 0.1 * i);
    gate.NoteCommand(true);
  }
  EXPECT_EQ(gate.GetState(), GateState::Ramping) << "a tenth ten times is a little less than 1";
  gate.Pass(0.1);
  gate.NoteCommand(true);
  EXPECT_EQ(gate.GetState(), GateState::Armed);
  EXPECT_EQ(gate.Pass(0.1), 1.0);
  // The data go, and come back to two thirds.
  gate.NoteData(0.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.Pass(0.1), 0.75);
  EXPECT_EQ(gate.GetReason(), GateReason::NoData);
  gate.NoteData(2.0 / 3.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.Pass(0.1), 2.0 / 3.0);
  gate.NoteData(1.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.GetReason(), GateReason::Rising);
  // Twice as fast would be a jump.
  gate.NoteData(1.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.Pass(0.1), 1.0);
  EXPECT_EQ(gate.GetReason(), GateReason::None);
  gate.NoteFault(GateReason::NotFinite);
  gate.Cut();
  EXPECT_EQ(gate.GetShare(), 0.0);
  EXPECT_EQ(gate.GetOpening(), 1.0);
}

//------------------------------------------------------------------------------
// Random sequences.

namespace
{

/// The gate as it was before it was one: flags, each with rules of its own.
struct Flags
{
  bool IsArmed = false;
  GateReason Fault = GateReason::None;
  bool FadesOut = false;
  bool IsUnattended = false;
  bool IsHeld = false;
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
    const bool flows = isSole && this->IsArmed && !this->FadesOut && this->Flowed;
    this->FadesOut = this->IsUnattended = false;
    if (!flows)
    {
      this->Restarts |= this->Fault != GateReason::None;
      this->IsArmed = true;
      this->Fault = GateReason::None;
      this->Ramp = 0.0;
      this->Retreats = false;
    }
  }
  void Disarm()
  {
    this->FadesOut = this->IsUnattended = false;
    this->IsArmed = false;
  }
  void NoteSilence()
  {
    if (this->CanFlow() && !this->IsHeld)
    {
      this->IsUnattended = this->FadesOut = true;
    }
  }
  void FollowData(double there, double period)
  {
    const double wanted = this->FadesOut || this->IsHeld ? 0.0 : there;
    const double most = period / 0.05;
    this->Opening = wanted > this->Opening + most ? this->Opening + most
      : wanted < this->Opening - most             ? this->Opening - most
                                                  : wanted;
  }
  /// The rest of a tick: what is found, and the force that would be there.
  void Finish(GateReason fault, bool gap, bool isStale, bool flows, double step)
  {
    const bool retreated = this->Retreats;
    if (this->CanFlow())
    {
      this->Fault = fault;
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
      if (!this->IsUnattended)
      {
        this->IsArmed = false;
      }
      else if (this->CanFlow())
      {
        this->Fault = GateReason::Unattended;
      }
      this->FadesOut = this->IsUnattended = false;
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
    GateReason::DeviceLost };
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
            flags.FadesOut = true;
        }
      }
      if (chance(0.3 * trouble))
      {
        gate.NoteSilence();
        flags.NoteSilence();
      }
      if (chance(0.3 * trouble))
      {
        gate.NoteNotReady();
        flags.IsArmed = false;
      }
      ASSERT_EQ(gate.TakeRestart(), flags.Restarts) << sequence << ", " << tick;
      flags.Restarts = false;

      there = chance(trouble) ? pick({ 0.0, 0.4, 1.0 }) : there;
      gate.NoteData(there, period);
      flags.FollowData(there, period);

      const double before = gate.GetShare();
      const bool flowed = flags.Flowed;
      const GateReason fault = chance(0.3 * trouble) ? Faults[engine() % 3] : GateReason::None;
      const bool wasStale = isStale;
      isStale = chance(isStale ? 0.5 : trouble);
      const bool gap = isStale || wasStale;
      // A command may follow its share late.
      const bool wants = chance(flags.Opening > 0.0 ? 0.8 : 0.3);
      flags.Finish(fault, gap, isStale, wants, step);
      if (fault != GateReason::None)
      {
        gate.NoteFault(fault);
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
          gate.NoteGap(isStale, flowed);
        }
        gate.IsRetreating() ? gate.NoteRetreat(isStale, wants) : void(gate.Pass(step));
      }
      gate.NoteCommand(isOpen && wants);

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
      // Of the share itself: never a jump upwards.
      const double opens = period / ForceGate::FadeTime;
      ASSERT_GE(gate.GetShare(), 0.0);
      ASSERT_LE(gate.GetShare(), std::min(1.0, before + step + opens + 1e-12));
    }
  }
  EXPECT_GT(*std::min_element(seen, seen + 7), 10000);
}
