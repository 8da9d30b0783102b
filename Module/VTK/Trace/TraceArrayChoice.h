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
 * Names of arrays that only some traces have: of volumes with labels, of moving volumes, and of the
 * method PRIMITIVES. The name of a mode's array ends with the index of the mode.
 */
constexpr const char* LabelColumn = "Label";
constexpr const char* DataTimeColumn = "DataTime";
constexpr const char* ModeForceColumn = "ModeForce_";
///@}
/** Names of arrays in traces of every tool. The arrays of the tool's kind (ToolKind) follow. */
constexpr const char* CommonToolArrays[] = { "Orientation", "Torque", "Depth", "ShaftForce" };

/** Largest number of modes whose forces a trace has. */
constexpr std::size_t MostModeForces = 8;

/**
 * A set of arrays. Bit i stands for column i of GetTraceColumns(). The following bits stand for the
 * labels, the data time, the force of each mode, and the arrays of tools.
 */
using TraceArrayChoice = unsigned long long;
constexpr TraceArrayChoice AllTraceArrays = ~TraceArrayChoice(0);

constexpr bool IsChosen(TraceArrayChoice choice, std::size_t array)
{
  return (choice >> array & TraceArrayChoice(1)) != 0;
}

///@{
/**
 * Return the number of all arrays, and the name of an array. Arrays are in the order of the bits.
 */
std::size_t GetNumberOfTraceArrays();
/** Returns the index of the array with a mode's force. */
std::size_t GetModeForceArray(std::size_t mode);
/**
 * Returns the index of a tool's array. `column` counts the CommonToolArrays first, then the arrays
 * of each kind of tool.
 */
std::size_t GetToolArray(std::size_t column);
const char* GetTraceArrayName(std::size_t array);
///@}

/** Returns the index of the array with a name; GetNumberOfTraceArrays() if there is none. */
std::size_t FindTraceArray(const std::string& name);

/** Splits a text into words at commas and spaces. */
std::vector<std::string> SplitTraceArrays(const std::string& text);

/**
 * Parses "all", "none" or names of arrays. For an unknown name, returns the error with the cure,
 * and leaves the choice unchanged.
 */
std::string ReadTraceArrays(const std::vector<std::string>& names, TraceArrayChoice& choice);

/**
 * Lists the names of the chosen arrays, with one more array added or removed. An unknown name is
 * added to the list, so that ReadTraceArrays() reports it.
 */
std::vector<std::string> ListTraceArrays(
  TraceArrayChoice choice, const std::string& other, bool isWanted);

/** Returns the choice as a text that ReadTraceArrays() can parse. */
std::string DescribeTraceArrays(TraceArrayChoice choice);

} // namespace VolumeHaptics

#endif
