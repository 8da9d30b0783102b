// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the force gate of a device whose signs are not confirmed yet. Compares it with a gate that
 * receives the same events and has nothing to confirm. The states must be the same, except for
 * Confirming instead of Ramping and Armed, and no force of the volume may pass.
 */

#include "Core/Safety/ForceGate.h"

#include <gtest/gtest.h>

#include <random>

using namespace VolumeHaptics;

namespace
{
GateState Expect(GateState confirmed)
{
  return confirmed == GateState::Ramping || confirmed == GateState::Armed ? GateState::Confirming
                                                                          : confirmed;
}

/// Reports the end of a tick as SafetyStage does. Returns the factor for the force.
double Tick(ForceGate& gate, bool isStale, bool flows)
{
  double share = 0.0;
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
    share = gate.Pass(0.1);
  }
  gate.ReportCommand(flows);
  return share;
}
} // namespace

TEST(ConfirmGate, AnUnconfirmedGateConfirmsInsteadOfRamping)
{
  constexpr int Sequences = 5000;
  constexpr int Ticks = 100;
  std::mt19937 engine(3);
  const auto chance = [&engine](double p) { return engine() * 0x1p-32 < p; };
  int confirming = 0;
  for (int sequence = 0; sequence < Sequences; ++sequence)
  {
    ForceGate plain;
    ForceGate gate;
    gate.SetUnconfirmed(true);
    ASSERT_EQ(gate.GetState(), GateState::Disarmed) << "it waits for Arm";
    bool isHeld = false;
    double opening = 1.0;
    const double rate = chance(0.5) ? 0.02 : 0.3;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      isHeld = chance(rate) ? !isHeld : isHeld;
      const unsigned order = tick == 0 ? 0 : chance(rate) ? engine() % 6 : 9;
      const bool isSole = chance(0.5);
      const GateReason fault = chance(0.5) ? GateReason::OverSpeed : GateReason::WrongSign;
      for (ForceGate* const each : { &plain, &gate })
      {
        each->SetHeld(isHeld);
        switch (order)
        {
          case 0:
          case 1:
            each->Arm(isSole);
            break;
          case 2:
            each->Disarm();
            break;
          case 3:
            each->FadeOut();
            break;
          case 4:
            each->ReportSilence();
            break;
          case 5:
            isSole ? each->ReportNotReady() : each->ReportFault(fault);
            break;
          default:
            break;
        }
        each->ReportData(1.0, 0.02);
      }
      ASSERT_EQ(gate.DrainRestart(), plain.DrainRestart());
      const bool isStale = chance(0.2 * rate);
      const bool flows = chance(0.7);
      if (isStale || chance(0.2 * rate))
      {
        plain.ReportGap(isStale, flows);
        gate.ReportGap(isStale, flows);
      }
      Tick(plain, isStale, flows);
      const double share = Tick(gate, isStale, flows);
      ASSERT_EQ(gate.GetState(), Expect(plain.GetState())) << sequence << ", " << tick;
      ASSERT_EQ(gate.GetFault(), plain.GetFault()) << sequence << ", " << tick;
      ASSERT_EQ(gate.GetShare(), 0.0) << "the volume is not felt";
      ASSERT_NE(gate.GetReason(), GateReason::None);
      ASSERT_EQ(gate.GetOpening(), plain.GetOpening());
      if (gate.GetState() == GateState::Confirming)
      {
        ++confirming;
        ASSERT_EQ(gate.GetReason(), GateReason::Confirming);
      }
      if (gate.IsOpen() && !gate.IsRetreating())
      {
        ASSERT_LE(share, opening + 0.4 + 1e-12) << "pushes fade, and rise, with the opening";
      }
      opening = gate.GetOpening();
    }
  }
  EXPECT_GT(confirming, 10000);
}

TEST(ConfirmGate, OnceConfirmedTheForceRisesFromZeroWithTheProxyAtTheTip)
{
  ForceGate gate;
  gate.SetUnconfirmed(true);
  gate.Arm();
  EXPECT_TRUE(gate.DrainRestart());
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_EQ(gate.Pass(0.1), 1.0) << "of the pushes";
    gate.ReportCommand(true);
  }
  EXPECT_EQ(gate.GetState(), GateState::Confirming);
  EXPECT_FALSE(gate.DrainRestart());
  gate.SetUnconfirmed(false);
  EXPECT_TRUE(gate.DrainRestart());
  EXPECT_EQ(gate.GetState(), GateState::Ramping);
  EXPECT_EQ(gate.Pass(0.1), 0.0);
  gate.ReportCommand(false);
  EXPECT_EQ(gate.GetReason(), GateReason::Rising);
}

TEST(ConfirmGate, AWrongSignHoldsUntilArm)
{
  for (const GateReason fault : { GateReason::WrongSign, GateReason::Unmoved })
  {
    ForceGate gate;
    gate.SetUnconfirmed(true);
    gate.Arm();
    gate.ReportFault(fault);
    Tick(gate, false, false);
    EXPECT_EQ(gate.GetState(), GateState::Fault);
    EXPECT_EQ(gate.GetFault(), fault);
    gate.FadeOut();
    gate.Disarm();
    EXPECT_EQ(gate.GetFault(), fault);
    gate.Arm();
    EXPECT_EQ(gate.GetState(), GateState::Confirming) << "anew";
  }
}
