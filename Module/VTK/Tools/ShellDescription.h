// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks and describes what the tools with a shape have in common, vtkHapticPointShell and
 * vtkHapticBurr.
 */
#ifndef ShellDescription_h
#define ShellDescription_h

#include "Core/Tools/PointShell/BakedShell.h"
#include "VTK/Tools/ToolKind.h"

#include <string>

namespace VolumeHaptics
{

/** The values that are solid: those on one side of a level. */
struct SolidLevel
{
  double Level = 0.0;
  bool IsBelow = false;
};

/**
 * Finds the value at which the surface strength passes half of its maximum. Returns false if it
 * never does so, or more than once; `error` then has the reason and the cure, and continues the
 * name of the tool.
 */
bool ComputeSolidLevel(const HapticMaterial& material, SolidLevel& level, std::string& error);

/** A number of a tool, which must be more than 0. */
struct ToolNumber
{
  const char* Name; ///< the name as in Set...
  double Value;
  const char* Unit;
};
/** Checks that a number is more than 0. Returns false, with the cure, if it isn't. */
bool CheckToolNumber(vtkHapticTool* tool, const ToolNumber& number, std::string& error);

/**
 * Describes what all tools with a shape share. Returns false, with an error in the plan, if the
 * tool can't be felt.
 * @param deed what the tool does that needs the method, such as "removes what is solid"
 */
bool DescribeShapedTool(
  vtkHapticShapedTool* tool, const char* deed, ToolPlan& plan, ShellDescription& described);

} // namespace VolumeHaptics

#endif
