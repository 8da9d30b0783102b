// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LiveRun_h
#define Explore_LiveRun_h

#include "Applications/Explorer/Exploration/Exploration.h"

#include <string>

namespace Explore
{
/// Results of a run through the servo loop.
struct LiveRun
{
  vtkSmartPointer<vtkPolyData> Trace; // recorded trace, tick by tick
  // a report of the servo's timing, and of the comparison with the offline filter
  std::string Report;
  bool IsReproduced = false; // whether equal tips led to equal forces offline and live
};

/// Moves the virtual device along the planned path in real time, with the servo at its rate, and
/// records to a file (.vtp). Then replays the planned path tick by tick, and compares the result
/// with the exploration's trace. Throws std::runtime_error if the servo can't run.
LiveRun RunLive(const Exploration& exploration, const std::string& file);
} // namespace Explore

#endif
