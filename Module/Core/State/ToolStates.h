// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The states that tools pass from tick to tick. Each tool with a state has one member.
 */
#ifndef ToolStates_h
#define ToolStates_h

#include "Core/State/BurrState.h"
#include "Core/State/NeedleState.h"
#include "Core/State/ShellState.h"

namespace VolumeHaptics
{

struct ToolStates
{
  NeedleState Needle;
  ShellState Shell; ///< state of a shell; ToolMemory contains the other part
  BurrState Burr;

  /** Drops the states that hold the hand, so that the next tick starts without a force. */
  void LetGo() noexcept
  {
    this->Needle = NeedleState{};
    this->Shell.Enabled = false;
  }

  /**
   * Calls a function with each number of the tools whose numbers come last in files. The numbers of
   * a new tool must be added at the end. ServoStateNumbers.cxx visits the numbers of all other
   * tools.
   */
  template <typename States, typename Function>
  static constexpr void VisitLast(States& /*states*/, Function&& /*visit*/)
  {
  }
};

} // namespace VolumeHaptics

#endif
