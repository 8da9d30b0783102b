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
  // text on how well the servo kept time, with a comparison with the offline filter
  std::string Report;
  bool IsReproduced = false; // whether equal tips gave equal forces offline and live
};

/// Leads the virtual device along the planned path in real time, with the servo at its rate, and
/// records to a file (.vtp). Then replays the planned path tick by tick, to compare it with the
/// exploration's trace. Throws std::runtime_error if the servo can't run.
LiveRun RunLive(const Exploration& exploration, const std::string& file);
} // namespace Explore

#endif
