// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts states of the servo to plain numbers for files, and back.
 */
#ifndef ServoStateNumbers_h
#define ServoStateNumbers_h

#include "Core/State/ServoState.h"

#include <array>

namespace VolumeHaptics
{

/** Returns the number of numbers that ToolStates::VisitLast visits. */
constexpr int CountLastToolNumbers()
{
  int count = 0;
  const ToolStates states{};
  ToolStates::VisitLast(states, [&count](const auto& /*number*/) { ++count; });
  return count;
}

/** Number of the numbers of a state, without those that ToolStates::VisitLast() visits. */
constexpr int FirstServoStateSize = 299;
constexpr int ServoStateSize = FirstServoStateSize + CountLastToolNumbers();
/**
 * Sizes of the states in old recordings. Each size precedes the addition of one of these:
 * MaterialPlacement, moving volumes, primitives, directions of primitives, tools, tools with a
 * shape, burrs, burr steps that take more than a tick, releases, and BurrState::Room. Missing
 * numbers are read as 0.
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
/** Returns whether a tick may have produced these numbers. If not, the file is damaged. */
bool AreOfAState(const std::array<double, ServoStateSize>& numbers) noexcept;

} // namespace VolumeHaptics

#endif
