// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a tool with a shape, such as a vtkHapticPointShell, to what a model is baked from.
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

/** The values of a solid: beyond a level. */
struct SolidLevel
{
  double Level = 0.0;
  bool IsBelow = false;
};

/**
 * Finds the value at which the surface strength passes half of its largest. False, with the reason
 * and the cure in `error`, which goes on from the name of the tool, if it never does or does so
 * more than once.
 */
bool FindSolidLevel(const HapticMaterial& material, SolidLevel& level, std::string& error);

/** A number of a tool, which has to be more than 0. */
struct ToolNumber
{
  const char* Name; ///< as in Set...
  double Value;
  const char* Unit;
};
/** False, with the cure, if it isn't. */
bool CheckToolNumber(vtkHapticTool* tool, const ToolNumber& number, std::string& error);

/**
 * Describes what all tools with a shape have to a model that has its settings, material and frames
 * already. False, with the reason and the cure in `error`, if it can't be felt.
 * @param deed what it does that needs the method, as in "removes what is solid"
 */
bool DescribeShapedTool(
  vtkHapticShapedTool* tool, const char* deed, HapticModelDescription& d, std::string& error);

/**
 * Describes a shell of points to a model that has its settings, material and frames already. The
 * points of a mesh that has not changed are those of models that still use them. False, with the
 * reason and the cure in `error`, if it can't be felt.
 */
bool DescribePointShell(vtkHapticPointShell* shell, HapticModelDescription& d, std::string& error);

} // namespace VolumeHaptics

#endif
