// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * volumehaptics-evaluation-stage [HANDS]
 *
 * Prints how much energy the safety stage returns (Documentation/evaluation.md): for a mass that
 * strikes a wall, with the stage and without, and for random presses through each of its rules.
 * Each of the HANDS hands (200 by default) presses five times. The exit status is the number of
 * rebounds and rules that return too much.
 */
#include "Rigs/Impacts.h"
#include "Rigs/RandomPresses.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <vector>

using namespace rigs;
using namespace rigs::impacts;

namespace
{
void Print(const char* name, const Rebound& r)
{
  std::printf("| %s | %.3f | %.3f | %.0f N/m, %.1f m/s, %.0f N, %.0f kHz, %zu |\n", name,
    r.Left / r.Free, r.Left / r.Unlimited, r.Stiffness, r.Speed, r.MaximumForce, 1e-3 / r.Tick,
    r.Delay);
}

int CompareRebounds()
{
  const std::vector<Rebound> all = FlyAll();
  std::vector<Rebound> slowed;
  std::copy_if(all.begin(), all.end(), std::back_inserter(slowed),
    [](const Rebound& r) { return r.Left != r.Unlimited; });
  const auto byFree = [](const Rebound& a, const Rebound& b)
  { return a.Left / a.Free < b.Left / b.Free; };
  const auto byClamped = [](const Rebound& a, const Rebound& b)
  { return a.Left / a.Unlimited < b.Left / b.Unlimited; };
  std::printf("Energy of the rebound; the slew limit acts in %zu of %zu cases.\n\n"
              "| case | / without the stage | / with the clamp alone | wall, speed, limit, rate, "
              "ticks of delay |\n| --- | --- | --- | --- |\n",
    slowed.size(), all.size());
  Print("worst of all", *std::max_element(all.begin(), all.end(), byFree));
  if (!slowed.empty())
  {
    Print("worst with the slew limit", *std::max_element(slowed.begin(), slowed.end(), byClamped));
    Print("least with the slew limit", *std::min_element(slowed.begin(), slowed.end(), byClamped));
  }
  Print("least of all", *std::min_element(all.begin(), all.end(), byFree));
  return static_cast<int>(std::count_if(all.begin(), all.end(),
    [](const Rebound& r) { return r.Left > r.Free || r.Left > r.Unlimited; }));
}

int MeasureExcess(int hands)
{
  constexpr int presses = 5;
  int failed = 0;
  std::printf("\n| rule | presses | that returned more than the hand put in | by at most, mJ |\n"
              "| --- | --- | --- | --- |\n");
  for (const StageRules& rules : AllStageRules)
  {
    int above = 0;
    double most = 0.0;
    for (int i = 0; i < hands; ++i)
    {
      RandomPresses hand(rules, static_cast<unsigned>(i));
      for (int press = 0; press < presses; ++press)
      {
        const double excess = hand.Press();
        above += excess > RandomPresses::Tolerance ? 1 : 0;
        most = std::max(most, excess);
      }
    }
    std::printf("| %s | %d | %d | %.3g |\n", rules.Name, hands * presses, above, 1e3 * most);
    failed += above > 0 ? 1 : 0;
  }
  return failed;
}
} // namespace

int main(int argc, char* argv[])
{
  const int hands = argc > 1 ? std::atoi(argv[1]) : 200;
  if (argc > 2 || hands <= 0)
  {
    std::fprintf(stderr, "usage: %s [HANDS]\n", argv[0]);
    return 255;
  }
  return std::min(CompareRebounds() + MeasureExcess(hands), 250);
}
