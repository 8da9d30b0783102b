// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * volumehaptics-evaluation-runaway [SESSIONS]
 *
 * Counts the false alarms of PortObserver.h over random sessions of honest devices (2000 by
 * default, Documentation/evaluation.md has 100 000), and the devices with wrong signs and with late
 * forces that it misses. For those that it finds it prints the energy that they gave and the way
 * that they went before. The exit status is the number of false alarms.
 */
#include "Rigs/PortSessions.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace rigs;

namespace
{
double At(const std::vector<double>& sorted, double share)
{
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(share * last)];
}

int CountFalseAlarms(int sessions)
{
  int alarms = 0;
  double rising = 0.0;
  double runAway = 0.0;
  for (int i = 0; i < sessions; ++i)
  {
    const PortResult result =
      PortSession(PortKind::Honest, true, 0.0, static_cast<std::uint32_t>(i)).Run();
    alarms += result.IsFound ? 1 : 0;
    rising = std::max(rising, result.Rising);
    runAway = std::max(runAway, result.RunAway);
  }
  std::printf("Honest devices: %d false alarms in %d sessions.\n"
              "Largest run-away: rising %.2f mJ of %.2f, in a contact %.2f mJ of %.2f.\n\n",
    alarms, sessions, 1e3 * rising, 1e3 * VolumeHaptics::PortObserver::RisingBound, 1e3 * runAway,
    1e3 * VolumeHaptics::PortObserver::ContactBound);
  return alarms;
}

void CountMisses(const char* name, PortKind kind, bool isHeld, int sessions)
{
  // A device that gave less is not told from one at rest.
  constexpr double LeastGiven = 1e-3;
  for (const double stiffness : { 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0 })
  {
    std::vector<double> given;
    std::vector<double> ways;
    int all = 0;
    for (int i = 0; i < sessions; ++i)
    {
      const PortResult result =
        PortSession(kind, isHeld, stiffness, static_cast<std::uint32_t>(i)).Run();
      all += result.IsFound || result.Given > LeastGiven ? 1 : 0;
      if (result.IsFound)
      {
        given.push_back(1e3 * result.Given);
        ways.push_back(1e3 * result.Way);
      }
    }
    std::printf("| %s, %s | %.0f | %.0f %% |", name, isHeld ? "held" : "limp", stiffness,
      all > 0 ? 100.0 * (1.0 - static_cast<double>(given.size()) / all) : 0.0);
    if (given.empty())
    {
      std::printf(" - | - |\n");
      continue;
    }
    std::sort(given.begin(), given.end());
    std::sort(ways.begin(), ways.end());
    std::printf(
      " %.0f, %.0f | %.1f, %.1f |\n", At(given, 0.5), At(given, 0.9), At(ways, 0.5), At(ways, 0.9));
  }
}
} // namespace

int main(int argc, char* argv[])
{
  const int sessions = argc > 1 ? std::atoi(argv[1]) : 2000;
  if (argc > 2 || sessions <= 0)
  {
    std::fprintf(stderr, "usage: %s [SESSIONS]\n", argv[0]);
    return 255;
  }
  const int alarms = CountFalseAlarms(sessions);
  std::printf("| device | N/m | missed | mJ: median, 90 %% | mm: median, 90 %% |\n"
              "| --- | --- | --- | --- | --- |\n");
  const int few = std::max(100, sessions / 50);
  CountMisses("wrong sign", PortKind::WrongSign, false, few);
  CountMisses("wrong sign", PortKind::WrongSign, true, few);
  CountMisses("late forces", PortKind::Unstable, false, few);
  CountMisses("late forces", PortKind::Unstable, true, few);
  return std::min(alarms, 250);
}
