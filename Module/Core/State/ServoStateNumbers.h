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

constexpr int ServoStateSize = 299;
/**
 * In recordings from before MaterialPlacement, before volumes that move, before primitives, before
 * their directions, before tools, before those with a shape, before burrs, before theirs that take
 * more than a tick, before releases, and before the room of burrs; the other numbers are 0 then.
 */
constexpr std::array<int, 11> OldServoStateSizes = { 64, 68, 73, 98, 101, 226, 273, 288, 292, 293,
  298 };

/** A state for a file: every number of it. */
std::array<double, ServoStateSize> ToNumbers(const ServoState& state) noexcept;
ServoState FromNumbers(const std::array<double, ServoStateSize>& numbers) noexcept;
/** False for numbers that no tick produces, but a file may contain. */
bool AreOfAState(const std::array<double, ServoStateSize>& numbers) noexcept;

} // namespace VolumeHaptics

#endif
