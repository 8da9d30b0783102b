// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The states that tools pass from tick to tick, one line a tool that has one.
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
  ShellState Shell; ///< state of a shell, used together with ToolMemory
  BurrState Burr;

  /** Drops the states that hold the hand: the next tick begins without a force. */
  void LetGo() noexcept
  {
    this->Needle = NeedleState{};
    this->Shell.Enabled = false;
  }

  /**
   * Calls a function with each number of the tools whose numbers come last in files; add the
   * numbers of a new tool at the end. ServoStateNumbers.cxx visits the numbers of the other tools.
   */
  template <typename States, typename Function>
  static constexpr void VisitLast(States& /*states*/, Function&& /*visit*/)
  {
  }
};

} // namespace VolumeHaptics

#endif
