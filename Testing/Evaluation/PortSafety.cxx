// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PortSafety.h"

#include "StiffWalls.h"
#include "Taps.h"

#include "Rigs/ArmSessions.h"
#include "Rigs/PortSessions.h"
#include "Rigs/SignTrials.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace rigs;

namespace evaluation
{
namespace
{
constexpr double Milli = 1e3;

std::string Percent(int part, int all)
{
  return all > 0 ? Number(100.0 * part / all) + " %" : "-";
}

/** Returns the median and the 90th percentile, multiplied by 1000. */
std::string Spread(std::vector<double> values)
{
  if (values.empty())
  {
    return "-";
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](double fraction)
  { return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))]; };
  return Number(Milli * at(0.5)) + ", " + Number(Milli * at(0.9));
}

Table CountFalseAlarms(int sessions, int& alarms)
{
  Table table;
  table.Title = "Honest devices";
  table.Text = "Random sessions of honest devices. The bounds of the observer of run-aways were "
               "found with the first kind of arm; the second has another model, other walls and "
               "the force fields.";
  table.Columns = { "arm", "sessions", "false alarms", "damped", "largest run-away, of its bound" };
  int cut = 0;
  double fraction = 0.0;
  for (int i = 0; i < sessions; ++i)
  {
    const PortResult result =
      PortSession(PortKind::Honest, true, 0.0, static_cast<std::uint32_t>(i)).Run();
    cut += result.IsFound ? 1 : 0;
    fraction = std::max({ fraction, result.Rising / VolumeHaptics::PortObserver::RisingBound,
      result.RunAway / VolumeHaptics::PortObserver::ContactBound });
  }
  table.Rows.push_back({ "one mass", std::to_string(sessions), std::to_string(cut), "-",
    Number(100.0 * fraction) + " %" });
  alarms += cut;
  cut = 0;
  int damped = 0;
  for (int i = 0; i < sessions; ++i)
  {
    const auto seed = static_cast<std::uint32_t>(i);
    const ArmResult result = ArmSession(ArmSession::DrawHonest(seed), seed).Run();
    cut += result.IsCut ? 1 : 0;
    damped += result.IsDamped ? 1 : 0;
  }
  table.Rows.push_back(
    { "two masses", std::to_string(sessions), std::to_string(cut), std::to_string(damped), "-" });
  alarms += cut;
  return table;
}

/** Returns a loop with only part of the friction that stability requires (see ArmSessions.h). */
ArmScene DrawUnstable(bool isHeld, double stiffness, int delay, std::uint32_t seed)
{
  std::mt19937 engine(seed);
  const auto pick = [&engine](double a, double b) { return a + (b - a) * (engine() * 0x1p-32); };
  ArmScene scene;
  scene.Stiffness = stiffness;
  scene.Delay = delay;
  scene.Mass = pick(0.05, 0.15);
  scene.IsHeld = isHeld;
  scene.Weight = pick(0.3, 1.5);
  scene.Quantum = pick(0.0, 1.0) < 0.5 ? 6e-5 : 1e-5;
  const double needed = stiffness * (0.5 + delay) / scene.Rate;
  scene.Damping = (isHeld ? pick(0.1, 0.3) : pick(0.3, 0.7)) * needed;
  scene.Grip = 300.0;
  scene.GripLoss = pick(0.1, 0.3) * needed;
  scene.MaximumForce = pick(2.0, 8.0);
  scene.MaximumDamping = 20.0;
  scene.Motion = Gesture::Press;
  scene.Depth = pick(0.005, 0.015);
  scene.Tremor = pick(0.0, 3e-4);
  return scene;
}

Table CountUnstable(int trials)
{
  // A tip with a smaller last swing counts as at rest.
  constexpr double LeastSwing = 1e-3;
  Table table;
  table.Title = "Loops that swing by themselves";
  table.Text =
    "Devices of 50 to 150 g at 1 kHz with 20 to 70 % of the friction that sampling and "
    "delay need, limp under a weight of 0.3 to 1.5 N, or held. Missed: neither damped nor "
    "cut off, and still swinging by more than 1 mm after 2 s. Energies and ways are "
    "those until then; median, 90 %.";
  table.Columns = { "device", "N/m", "ticks late", "damped", "cut off", "missed", "mJ until damped",
    "mm until damped", "mJ until cut off" };
  for (const bool isHeld : { false, true })
  {
    for (const double stiffness : { 500.0, 1000.0, 2000.0, 5000.0 })
    {
      for (const int delay : { 0, 1, 3 })
      {
        int damped = 0;
        int cut = 0;
        int missed = 0;
        std::vector<double> given;
        std::vector<double> ways;
        std::vector<double> givenCut;
        for (int i = 0; i < trials; ++i)
        {
          const auto seed = static_cast<std::uint32_t>(i);
          const ArmResult result =
            ArmSession(DrawUnstable(isHeld, stiffness, delay, seed), seed).Run();
          damped += result.IsDamped ? 1 : 0;
          cut += result.IsCut ? 1 : 0;
          missed += !result.IsDamped && !result.IsCut && result.LastSwing > LeastSwing ? 1 : 0;
          if (result.IsDamped)
          {
            given.push_back(std::max(0.0, result.GivenDamped));
            ways.push_back(result.WayDamped);
          }
          if (result.IsCut)
          {
            givenCut.push_back(std::max(0.0, result.Given));
          }
        }
        table.Rows.push_back({ isHeld ? "held" : "limp", Number(stiffness), std::to_string(delay),
          Percent(damped, trials), Percent(cut, trials), Percent(missed, trials), Spread(given),
          Spread(ways), Spread(givenCut) });
      }
    }
  }
  return table;
}

Table CountCheckedSigns(int trials)
{
  using VolumeHaptics::SignResult;
  Table table;
  table.Title = "Wrong signs, with the check at the first arming";
  table.Text = "Random hands and devices (SignTrials.h), wrong on one axis at least, and right on "
               "all. Undecided: told to hold it otherwise, and nothing is felt.";
  table.Columns = { "signs", "checks", "called wrong", "undecided", "called right", "mJ at most",
    "mm at most", "s" };
  for (const bool isWrong : { true, false })
  {
    signtest::RandomHands random(isWrong ? 21 : 22);
    int wrong = 0;
    int right = 0;
    double work = 0.0;
    double motion = 0.0;
    double seconds = 0.0;
    for (int i = 0; i < trials; ++i)
    {
      signtest::Hand hand;
      signtest::Port port;
      random.Draw(hand, port);
      const signtest::Triple signs =
        isWrong ? random.DrawWrongSigns() : signtest::Triple{ 1.0, 1.0, 1.0 };
      const signtest::Outcome outcome =
        signtest::CheckSigns(hand, port, signs, 3000 + static_cast<unsigned>(i));
      wrong += outcome.Verdict.Result == SignResult::Wrong ? 1 : 0;
      right += outcome.Verdict.Result == SignResult::Confirmed ? 1 : 0;
      work = std::max(work, outcome.Work);
      motion = std::max(motion, outcome.Motion);
      seconds += outcome.Seconds / trials;
    }
    table.Rows.push_back({ isWrong ? "wrong" : "right", std::to_string(trials),
      std::to_string(wrong), std::to_string(trials - wrong - right), std::to_string(right),
      Number(Milli * work), Number(Milli * motion), Number(seconds) });
  }
  return table;
}

Table CountRunAways(int trials)
{
  // Energy (J) below which a device can't be distinguished from one at rest.
  constexpr double LeastGiven = 1e-3;
  Table table;
  table.Title = "Wrong signs, with the observer of the port alone";
  table.Text = "Without that check (PortSessions.h). Median, 90 % of those that were found.";
  table.Columns = { "device", "N/m", "missed", "mJ", "mm" };
  for (const bool isHeld : { false, true })
  {
    for (const double stiffness : { 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0 })
    {
      std::vector<double> given;
      std::vector<double> ways;
      int all = 0;
      for (int i = 0; i < trials; ++i)
      {
        const auto seed = static_cast<std::uint32_t>(i);
        const PortResult result = PortSession(PortKind::WrongSign, isHeld, stiffness, seed).Run();
        all += result.IsFound || result.Given > LeastGiven ? 1 : 0;
        if (result.IsFound)
        {
          given.push_back(result.Given);
          ways.push_back(result.Way);
        }
      }
      table.Rows.push_back({ isHeld ? "held" : "limp", Number(stiffness),
        Percent(all - static_cast<int>(given.size()), all), Spread(given), Spread(ways) });
    }
  }
  return table;
}

} // namespace

PortSafety MeasurePortSafety(int sessions, int trials)
{
  PortSafety safety;
  safety.Tables.push_back(CountFalseAlarms(sessions, safety.Alarms));
  safety.Tables.push_back(CountUnstable(trials));
  safety.Tables.push_back(CountCheckedSigns(trials));
  safety.Tables.push_back(CountRunAways(trials));
  safety.Tables.push_back(MeasureStiffWalls());
  safety.Tables.push_back(MeasureTaps());
  return safety;
}

} // namespace evaluation
