// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which arrays a trace of the filter has.
 */
#ifndef TraceArrayChoice_h
#define TraceArrayChoice_h

#include "VTK/Tools/ToolColumns.h"

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

///@{
/**
 * The names of arrays that only traces of volumes with labels, of volumes that move, and of the
 * method PRIMITIVES have. The number of the mode follows the name of its array.
 */
constexpr const char* LabelColumn = "Label";
constexpr const char* DataTimeColumn = "DataTime";
constexpr const char* ModeForceColumn = "ModeForce_";
///@}

/** As many as there may be modes. */
constexpr std::size_t MostModeForces = 8;

/**
 * Bit i stands for column i of GetTraceColumns(), and the bits after the last for the labels, the
 * data time, the force of each mode, and the ToolColumns.
 */
using TraceArrayChoice = unsigned long long;
constexpr TraceArrayChoice AllTraceArrays = ~TraceArrayChoice(0);

constexpr bool IsChosen(TraceArrayChoice choice, std::size_t array)
{
  return (choice >> array & TraceArrayChoice(1)) != 0;
}

///@{
/** Number and names of the arrays, in the order of the bits. */
std::size_t GetNumberOfTraceArrays();
/** The number of the array of a mode's force. */
std::size_t GetModeForceArray(std::size_t mode);
/** The number of one of the ToolColumns. */
std::size_t GetToolArray(std::size_t column);
const char* GetTraceArrayName(std::size_t array);
///@}

/** The number of an array; GetNumberOfTraceArrays() if there is none of this name. */
std::size_t FindTraceArray(const std::string& name);

/** The words of a text that commas or spaces separate. */
std::vector<std::string> SplitTraceArrays(const std::string& text);

/**
 * Reads "all", "none" or some names. Returns the fault and the cure, and leaves the choice as it
 * is, if there is no array of a name.
 */
std::string ReadTraceArrays(const std::vector<std::string>& names, TraceArrayChoice& choice);

/** The choice as a text that can be read again. */
std::string DescribeTraceArrays(TraceArrayChoice choice);

} // namespace VolumeHaptics

#endif
