// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes a tool with a shape, such as a vtkHapticPointShell, to the model that is baked.
 */
#ifndef ShellDescription_h
#define ShellDescription_h

#include "Core/Model/HapticModelDescription.h"

#include <string>

class vtkHapticPointShell;
class vtkHapticShapedTool;
class vtkHapticTool;

namespace VolumeHaptics
{

/** The values that are solid: those on one side of a level. */
struct SolidLevel
{
  double Level = 0.0;
  bool IsBelow = false;
};

/**
 * Finds the value at which the surface strength passes half of its maximum. False if it never does
 * so, or more than once; `error` then has the reason and the cure, and continues the name of the
 * tool.
 */
bool FindSolidLevel(const HapticMaterial& material, SolidLevel& level, std::string& error);

/** A number of a tool, which must be more than 0. */
struct ToolNumber
{
  const char* Name; ///< the name as in Set...
  double Value;
  const char* Unit;
};
/** Checks that a number is more than 0. False, with the cure, if it isn't. */
bool CheckToolNumber(vtkHapticTool* tool, const ToolNumber& number, std::string& error);

/**
 * Adds what all tools with a shape share to the description of a model that already has its
 * settings, material and frames. False, with the reason and the cure in `error`, if the tool can't
 * be felt.
 * @param deed what the tool does that needs the method, such as "removes what is solid"
 */
bool DescribeShapedTool(
  vtkHapticShapedTool* tool, const char* deed, HapticModelDescription& d, std::string& error);

/**
 * Adds a shell of points to the description of a model that already has its settings, material and
 * frames. If the mesh has not changed, its points are shared with models that still use them.
 * False, with the reason and the cure in `error`, if the shell can't be felt.
 */
bool DescribePointShell(vtkHapticPointShell* shell, HapticModelDescription& d, std::string& error);

} // namespace VolumeHaptics

#endif
