// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * States of the servo as plain numbers, for files.
 */
#ifndef ServoStateNumbers_h
#define ServoStateNumbers_h

#include "Core/State/ServoState.h"

#include <array>

namespace VolumeHaptics
{

/** Counts the numbers of ToolStates::VisitLast. */
constexpr int CountLastToolNumbers()
{
  int count = 0;
  const ToolStates states{};
  ToolStates::VisitLast(states, [&count](const auto& /*number*/) { ++count; });
  return count;
}

/** The size of a state without the numbers of ToolStates::VisitLast. */
constexpr int FirstServoStateSize = 299;
constexpr int ServoStateSize = FirstServoStateSize + CountLastToolNumbers();
/**
 * The sizes of states in old recordings, from before the following were added, in this order:
 * MaterialPlacement, volumes that move, primitives, their directions, tools, tools with a shape,
 * burrs, burr steps that take more than a tick, releases, and the room of burrs. The missing
 * numbers are 0.
 */
constexpr std::array<int, 11> OldServoStateSizes = { 64, 68, 73, 98, 101, 226, 273, 288, 292, 293,
  298 };
/** Returns whether old recordings have states of this size. */
constexpr bool IsOldServoStateSize(int size)
{
  for (const int old : OldServoStateSizes)
  {
    if (size == old)
    {
      return true;
    }
  }
  return size >= FirstServoStateSize && size < ServoStateSize;
}

/** Returns all numbers of a state, for a file. */
std::array<double, ServoStateSize> ToNumbers(const ServoState& state) noexcept;
ServoState FromNumbers(const std::array<double, ServoStateSize>& numbers) noexcept;
/** Returns false for numbers that a file may contain but no tick produces. */
bool AreOfAState(const std::array<double, ServoStateSize>& numbers) noexcept;

} // namespace VolumeHaptics

#endif
