// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Chooses which arrays a trace of the filter has.
 */
#ifndef TraceArrayChoice_h
#define TraceArrayChoice_h

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

///@{
/**
 * Names of arrays that only some traces have: those of volumes with labels, of volumes that move,
 * and of the method PRIMITIVES. The number of the mode follows the name of its array.
 */
constexpr const char* LabelColumn = "Label";
constexpr const char* DataTimeColumn = "DataTime";
constexpr const char* ModeForceColumn = "ModeForce_";
///@}
/** Names of arrays that traces of every tool have, before those of its kind (ToolKind). */
constexpr const char* CommonToolArrays[] = { "Orientation", "Torque", "Depth", "ShaftForce" };

/** Largest number of modes. */
constexpr std::size_t MostModeForces = 8;

/**
 * Bit i stands for column i of GetTraceColumns(), and the bits after the last for the labels, the
 * data time, the force of each mode, and the arrays of tools.
 */
using TraceArrayChoice = unsigned long long;
constexpr TraceArrayChoice AllTraceArrays = ~TraceArrayChoice(0);

constexpr bool IsChosen(TraceArrayChoice choice, std::size_t array)
{
  return (choice >> array & TraceArrayChoice(1)) != 0;
}

///@{
/** Return the number and the names of the arrays, in the order of the bits. */
std::size_t GetNumberOfTraceArrays();
/** Returns the index of the array of a mode's force. */
std::size_t GetModeForceArray(std::size_t mode);
/** Returns the index of an array of tools: the CommonToolArrays, then those of each kind. */
std::size_t GetToolArray(std::size_t column);
const char* GetTraceArrayName(std::size_t array);
///@}

/** Returns the index of an array; GetNumberOfTraceArrays() if no array has this name. */
std::size_t FindTraceArray(const std::string& name);

/** Splits a text into words at commas and spaces. */
std::vector<std::string> SplitTraceArrays(const std::string& text);

/**
 * Reads "all", "none" or some names. If no array has one of the names, returns the fault and the
 * cure, and leaves the choice unchanged.
 */
std::string ReadTraceArrays(const std::vector<std::string>& names, TraceArrayChoice& choice);

/** Writes the choice as a text that can be read again. */
std::string DescribeTraceArrays(TraceArrayChoice choice);

} // namespace VolumeHaptics

#endif
