// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks and describes the settings that the tools with a shape share, vtkHapticPointShell and
 * vtkHapticBurr.
 */
#ifndef ShellDescription_h
#define ShellDescription_h

#include "Core/Tools/PointShell/BakedShell.h"
#include "VTK/Tools/ToolKind.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Value that separates solid from other values. Solid values are above it, or below it if IsBelow.
 */
struct SolidLevel
{
  double Level = 0.0;
  bool IsBelow = false;
};

/**
 * Computes the value where the surface strength crosses half of its maximum. Returns false if there
 * is no such value or more than one; `error` then has the reason and the cure, as the end of a
 * sentence that begins with the tool's name.
 */
bool ComputeSolidLevel(const HapticMaterial& material, SolidLevel& level, std::string& error);

/** A setting of a tool that must be above 0. */
struct ToolNumber
{
  const char* Name; ///< name without Set
  double Value;
  const char* Unit;
};
/** Returns whether a number is above 0. If not, sets `error` to the fault and the cure. */
bool CheckToolNumber(vtkHapticTool* tool, const ToolNumber& number, std::string& error);

/**
 * Describes the common part of all tools with a shape. Returns false, with an error in the plan, if
 * the tool can't be felt.
 * @param deed what the tool needs the method for, as in "removes what is solid"
 */
bool DescribeShapedTool(
  vtkHapticShapedTool* tool, const char* deed, ToolPlan& plan, ShellDescription& described);

} // namespace VolumeHaptics

#endif
