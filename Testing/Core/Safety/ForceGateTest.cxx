// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the force gate with a table that was written by hand, for every event in every state.
 */

#include "Core/Safety/ForceGate.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

using namespace VolumeHaptics;

namespace
{

/// The letter for a state and its reason in the table below.
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
  { 'K', GateState::Disarmed, GateReason::Clutched },
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
  ArmAmongOthers, ///< while force flows, and other orders come in the same tick
  Disarm,
  FadeOut,
  Hold,
  Release,       ///< while the force may still be fading
  ReleaseAtRest, ///< when no force flows any more
  Silence,
  NotReady,
  Lost,
  GapOver,       ///< samples were missing and have returned; no force flows
  GapOn,         ///< samples are missing
  Force,         ///< a tick whose command is not zero
  NoForce,       ///< a tick whose command is zero
  NoForceClosed, ///< a tick whose command is zero, with the opening at its target
  ClutchIn,
  ClutchOut,
  Jump, ///< a new model
  Events
};

/// Letters of the causes. D, d: closed; O, o: open. f: ordered fade; s: fade because the owner is
/// silent; h: hold; r: retreat; c: clutch; C: clutch after which the force returns.
struct Row
{
  const char* Causes;
  const char* Expected; ///< the letter of the outcome of each event
};
// clang-format off
constexpr Row Table[] = {
  // Columns: Arm (without force, with force, with other orders); Disarm, FadeOut, Hold; Release
  // (early, at rest); Silence; NotReady, Lost; gap (over, on); command (force, zero, zero with the
  // opening at its target); clutch (in, out); jump.
  { "D", "rrr" "DDD" "DDD" "ND" "DD" "DDD" "DD" "D" },
  { "Df", "rrr" "DNN" "NNN" "NN" "NN" "NND" "NN" "N" },
  { "Ds", "rrr" "DNN" "NNN" "NN" "NN" "NNN" "NN" "N" },
  { "Dh", "HHH" "DDD" "DDD" "ND" "DD" "DDD" "DD" "D" },
  { "Dfh", "HHH" "DNN" "NNN" "NN" "NN" "NND" "NN" "N" },
  { "Dsh", "HHH" "DNN" "NNN" "NN" "NN" "NNN" "NN" "N" },
  { "d", "rrr" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "df", "rrr" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "ds", "rrr" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dh", "HHH" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dfh", "HHH" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dsh", "HHH" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "O", "rrr" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  { "Of", "rrr" "dOO" "OOO" "dO" "OO" "OOd" "OO" "O" },
  { "Os", "rrr" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  { "Oh", "HHH" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  { "Ofh", "HHH" "dOO" "OOO" "dO" "OO" "OOd" "OO" "O" },
  { "Osh", "HHH" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  { "o", "rar" "DFH" "aaS" "NL" "rT" "aaa" "Ka" "r" },
  { "or", "rTr" "DFH" "TrS" "NL" "rT" "Trr" "KT" "T" },
  { "oh", "HHH" "DFH" "HrH" "NL" "HH" "HHH" "KH" "H" },
  { "ohr", "HHH" "DFH" "HrH" "NL" "HH" "HHH" "KH" "H" },
  { "of", "rrr" "DFF" "FFS" "NL" "FF" "FFD" "DF" "F" },
  { "ofr", "rrr" "DFF" "FFS" "NL" "FF" "FFD" "DF" "F" },
  { "ofh", "HHH" "DFF" "FFF" "NL" "FF" "FFD" "DF" "F" },
  { "ofhr", "HHH" "DFF" "FFF" "NL" "FF" "FFD" "DF" "F" },
  { "os", "rrr" "DSS" "SSS" "NL" "SS" "SSU" "KS" "S" },
  { "osr", "rrr" "DSS" "SSS" "NL" "SS" "SSU" "KS" "S" },
  { "osh", "HHH" "DSS" "SSS" "NL" "SS" "SSU" "KS" "S" },
  { "oshr", "HHH" "DSS" "SSS" "NL" "SS" "SSU" "KS" "S" },
  // These rows begin with a clutch that was pressed while the gate let no force through.
  { "Dc", "KKK" "DDD" "DDD" "ND" "DD" "DDD" "DD" "D" },
  { "Dfc", "KKK" "DNN" "NNN" "NN" "NN" "NND" "NN" "N" },
  { "Dsc", "KKK" "DNN" "NNN" "NN" "NN" "NNN" "NN" "N" },
  { "Dhc", "KKK" "DDD" "DDD" "ND" "DD" "DDD" "DD" "D" },
  { "Dfhc", "KKK" "DNN" "NNN" "NN" "NN" "NND" "NN" "N" },
  { "Dshc", "KKK" "DNN" "NNN" "NN" "NN" "NNN" "NN" "N" },
  { "dc", "ddd" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dfc", "ddd" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dsc", "ddd" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dhc", "ddd" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dfhc", "ddd" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "dshc", "ddd" "ddd" "ddd" "dd" "dd" "ddd" "dd" "d" },
  { "Oc", "OOO" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  { "Ofc", "OOO" "dOO" "OOO" "dO" "OO" "OOd" "OO" "O" },
  { "Osc", "OOO" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  { "Ohc", "OOO" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  { "Ofhc", "OOO" "dOO" "OOO" "dO" "OO" "OOd" "OO" "O" },
  { "Oshc", "OOO" "dOO" "OOO" "dO" "OO" "OOO" "OO" "O" },
  // These rows begin with a clutch that was pressed, after which the force returns.
  { "DC", "KKK" "DDK" "KKK" "NL" "KK" "KKK" "Kr" "K" },
  { "DhC", "KKK" "DDK" "KKK" "NL" "KK" "KKK" "KH" "K" },
  { "dC", "ddd" "ddd" "ddd" "dL" "dd" "ddd" "dr" "d" },
  { "dhC", "ddd" "ddd" "ddd" "dL" "dd" "ddd" "dH" "d" },
  { "OC", "OOO" "dOO" "OOO" "dL" "OO" "OOO" "Or" "O" },
  { "OhC", "OOO" "dOO" "OOO" "dL" "OO" "OOO" "OH" "O" },
};
// clang-format on

bool Has(const std::string& causes, char cause)
{
  return causes.find(cause) != std::string::npos;
}

/// Reports the end of a tick as SafetyStage does, without advancing the ramp.
void Tick(ForceGate& gate, bool flows, bool isStale = false)
{
  if (!gate.IsOpen())
  {
    gate.Cut();
    flows = false;
  }
  else if (gate.IsRetreating())
  {
    gate.ReportRetreat(isStale, flows);
  }
  else
  {
    gate.Pass(0.0);
  }
  gate.ReportCommand(flows);
}

/// Brings a gate into the state of a row. `ramp` is the completed part of the ramp, from 0 to 1. If
/// the gate is open, `flows` is whether force flows.
ForceGate Make(const std::string& causes, double ramp, bool flows)
{
  ForceGate gate;
  gate.Arm();
  gate.Pass(ramp);
  gate.Pass(0.0);
  gate.ReportCommand(flows);
  if (Has(causes, 's'))
  {
    gate.ReportSilence();
  }
  if (Has(causes, 'f'))
  {
    gate.FadeOut();
  }
  if (Has(causes, 'r'))
  {
    gate.ReportGap(true, flows);
    Tick(gate, flows, true);
  }
  if (causes[0] == 'd' || causes[0] == 'O')
  {
    gate.ReportFault(GateReason::OverSpeed);
    Tick(gate, false);
  }
  if (causes[0] == 'd' || (causes[0] == 'D' && causes.find_first_of("fs") != std::string::npos))
  {
    gate.ReportNotReady(); // a fault that leaves a fade unchanged
    Tick(gate, false);
  }
  else if (causes[0] == 'D' && !Has(causes, 'C'))
  {
    gate.Disarm();
    Tick(gate, false);
  }
  if (Has(causes, 'c') || Has(causes, 'C'))
  {
    gate.SetClutched(true);
    Tick(gate, false);
  }
  if (Has(causes, 'C') && causes[0] != 'D')
  {
    gate.Arm();
  }
  if (Has(causes, 'h'))
  {
    gate.SetHeld(true);
  }
  gate.DrainRestart();
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
      gate.ReportSilence();
      break;
    case NotReady:
      gate.ReportNotReady();
      break;
    case Lost:
      gate.ReportFault(GateReason::DeviceLost);
      break;
    case GapOver:
      gate.ReportGap(false, false);
      break;
    case GapOn:
      gate.ReportGap(true, false);
      break;
    case Force:
      Tick(gate, true);
      break;
    case NoForceClosed:
      gate.ReportData(1.0, ForceGate::FadeTime);
      Tick(gate, false);
      break;
    case NoForce:
      Tick(gate, false);
      break;
    case ClutchIn:
      gate.SetClutched(true);
      break;
    case ClutchOut:
      gate.SetClutched(false);
      break;
    case Jump:
      gate.ReportJump();
      break;
    case Events:
      break;
  }
}

/// Returns whether the event must make the proxy restart at the tip.
bool ExpectsRestart(const std::string& causes, Event event)
{
  const bool isClutched = Has(causes, 'c') || Has(causes, 'C');
  const bool isFelt = causes[0] == 'o' && !Has(causes, 'f') && !Has(causes, 's');
  switch (event)
  {
    case Arm:
    case ArmAmongOthers:
      return !isClutched;
    case ArmFlowing:
      return !isClutched && !isFelt;
    case ClutchOut:
      return Has(causes, 'C');
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
        EXPECT_EQ(gate.DrainRestart(), ExpectsRestart(causes, event)) << causes << ", event " << i;
        EXPECT_FALSE(gate.DrainRestart()) << "once";
        const GateReason fault = std::strchr("dO", expected) ? GateReason::OverSpeed
          : expected == 'L'                                  ? GateReason::DeviceLost
          : expected == 'U'                                  ? GateReason::Unattended
                                                             : GateReason::None;
        EXPECT_EQ(gate.GetFault(), fault) << causes << ", event " << i;
      }
    }
  }
}

TEST(ForceGate, OfAnUnstableLoopFadesAndThenIsAFault)
{
  for (const bool isHeld : { false, true })
  {
    ForceGate gate = Make(isHeld ? "oh" : "o", 1.0, true);
    gate.ReportUnstable();
    EXPECT_EQ(gate.GetState(), GateState::Fading);
    EXPECT_EQ(gate.GetReason(), GateReason::Active);
    gate.ReportSilence();
    double share = 1.0;
    for (int i = 0; gate.IsOpen() && i < 100; ++i)
    {
      gate.ReportData(1.0, 1e-3);
      gate.Pass(1.0);
      EXPECT_LE(gate.GetShare(), share);
      share = gate.GetShare();
      gate.ReportCommand(share > 0.0);
    }
    EXPECT_EQ(gate.GetState(), GateState::Fault);
    EXPECT_EQ(gate.GetFault(), GateReason::Active) << "the first reason stays";
    gate.Arm();
    EXPECT_TRUE(gate.IsOpen());
  }
  ForceGate disarmed;
  disarmed.ReportUnstable();
  EXPECT_EQ(disarmed.GetFault(), GateReason::None);
}

TEST(ForceGate, OfAnOrderToArmSaysWhetherItBeginsAnew)
{
  for (const Row& row : Table)
  {
    const std::string causes = row.Causes;
    const bool fades = causes.find_first_of("fs") != std::string::npos;
    const bool isClutched = causes.find_first_of("cC") != std::string::npos;
    EXPECT_EQ(Make(causes, 1.0, false).Arm(), !isClutched) << causes;
    EXPECT_EQ(Make(causes, 1.0, true).Arm(false), !isClutched) << causes;
    EXPECT_EQ(Make(causes, 1.0, true).Arm(), !isClutched && (causes[0] != 'o' || fades)) << causes;
    EXPECT_EQ(Make(causes, 1.0, true).SetClutched(false), Has(causes, 'C')) << causes;
    EXPECT_FALSE(Make(causes, 1.0, true).SetClutched(true)) << causes;
  }
}

TEST(ForceGate, ReturnsAfterTheClutchUnlessItWasDisarmedOrLostMeanwhile)
{
  for (const Row& row : Table)
  {
    const std::string causes = row.Causes;
    for (int i = 0; i < ClutchIn && causes.find_first_of("cC") != std::string::npos; ++i)
    {
      const auto event = static_cast<Event>(i);
      ForceGate gate = Make(causes, 1.0, false);
      Apply(gate, event);
      EXPECT_FALSE(gate.IsOpen()) << causes << ", event " << i;
      const bool arms = event == Arm || event == ArmFlowing || event == ArmAmongOthers;
      const bool disarms =
        event == Disarm || event == FadeOut || event == NotReady || event == Lost;
      EXPECT_EQ(gate.SetClutched(false), arms || (Has(causes, 'C') && !disarms))
        << causes << ", event " << i;
      EXPECT_EQ(gate.IsOpen(), arms || (Has(causes, 'C') && !disarms));
      gate.Pass(0.1);
      EXPECT_EQ(gate.GetShare(), 0.0) << "a ramp from zero";
    }
  }
}

TEST(ForceGate, SharesRampAndOpening)
{
  ForceGate gate;
  gate.Arm();
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_DOUBLE_EQ(gate.Pass(0.1), 0.1 * i);
    gate.ReportCommand(true);
  }
  EXPECT_EQ(gate.GetState(), GateState::Ramping) << "a tenth ten times is a little less than 1";
  gate.Pass(0.1);
  gate.ReportCommand(true);
  EXPECT_EQ(gate.GetState(), GateState::Armed);
  EXPECT_EQ(gate.Pass(0.1), 1.0);
  // The share of the data that is in memory drops to 0, then rises to 2/3. The gate follows by at
  // most a quarter per tick, so it only reaches 0.75 before it goes to 2/3.
  gate.ReportData(0.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.Pass(0.1), 0.75);
  EXPECT_EQ(gate.GetReason(), GateReason::NoData);
  gate.ReportData(2.0 / 3.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.Pass(0.1), 2.0 / 3.0);
  gate.ReportData(1.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.GetReason(), GateReason::Rising);
  // The opening rises at most by a quarter per tick here, so it reaches 1 only now.
  gate.ReportData(1.0, 0.25 * ForceGate::FadeTime);
  EXPECT_EQ(gate.Pass(0.1), 1.0);
  EXPECT_EQ(gate.GetReason(), GateReason::None);
  gate.ReportFault(GateReason::NotFinite);
  gate.Cut();
  EXPECT_EQ(gate.GetShare(), 0.0);
  EXPECT_EQ(gate.GetOpening(), 1.0);
}
