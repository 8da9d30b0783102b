// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Checks and describes the settings that vtkHapticPointShell and vtkHapticBurr, the tools
 * with a shape, share.
 */
#ifndef ShellDescription_h
#define ShellDescription_h

#include "Core/Tools/PointShell/BakedShell.h"
#include "VTK/Tools/ToolKind.h"

#include <string>

namespace VolumeHaptics
{

/**
 * The level that separates solid values from other values. Solid values are above it, or below it
 * if IsBelow.
 */
struct SolidLevel
{
  double Level = 0.0;
  bool IsBelow = false;
};

/**
 * Computes the value at which the surface strength passes half of its maximum. Returns false if it
 * does so never or more than once. The reason and the cure in `error` then continue a sentence that
 * begins with the tool's name.
 */
bool ComputeSolidLevel(const HapticMaterial& material, SolidLevel& level, std::string& error);

/** A number of a tool that must be above 0. */
struct ToolNumber
{
  const char* Name; ///< name as in Set...
  double Value;
  const char* Unit;
};
/** Checks that a number is above 0. If not, returns false, with the cure in `error`. */
bool CheckToolNumber(vtkHapticTool* tool, const ToolNumber& number, std::string& error);

/**
 * Describes what all tools with a shape have in common. Returns false, with an error in the plan,
 * if the tool can't be felt.
 * @param deed what the tool does that needs the method, such as "removes what is solid"
 */
bool DescribeShapedTool(
  vtkHapticShapedTool* tool, const char* deed, ToolPlan& plan, ShellDescription& described);

} // namespace VolumeHaptics

#endif
