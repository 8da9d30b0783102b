// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * volumehaptics-evaluation-runaway [SESSIONS]
 *
 * Prints the tables of PortSafety.h for SESSIONS sessions of honest devices (2000 by default;
 * Documentation/evaluation.md has 100 000). The exit status is the number of false alarms.
 */
#include "PortSafety.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

int main(int argc, char* argv[])
{
  const int sessions = argc > 1 ? std::atoi(argv[1]) : 2000;
  if (argc > 2 || sessions <= 0)
  {
    std::fprintf(stderr, "usage: %s [SESSIONS]\n", argv[0]);
    return 255;
  }
  const evaluation::PortSafety safety =
    evaluation::MeasurePortSafety(sessions, std::clamp(sessions / 20, 10, 1000));
  std::for_each(safety.Tables.begin(), safety.Tables.end(), evaluation::PrintTable);
  return std::min(safety.Alarms, 250);
}
