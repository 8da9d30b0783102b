// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a vtkHapticPointShell to what a model is baked from.
 */
#ifndef ShellDescription_h
#define ShellDescription_h

#include "Core/Model/HapticModelDescription.h"

#include <string>

class vtkHapticPointShell;

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

///@{
/** Of a tool with a shape, by its class: false, with the cure, if it can't be felt. */
/** A number of it, which has to be more than 0. */
struct ToolNumber
{
  const char* Name; ///< as in Set...
  double Value;
  const char* Unit;
};
bool CheckToolNumber(const char* tool, const ToolNumber& number, std::string& error);
/** Whether method and volume are what it needs. @param deed what it does that needs the method */
bool CheckToolVolume(
  const char* tool, const char* deed, const HapticModelDescription& d, std::string& error);
/** What is solid. @param choice one of vtkHapticPointShell::SolidType */
bool FindSolid(const char* tool, int choice, double contactValue, const HapticMaterial& material,
  SolidLevel& level, std::string& error);
///@}

/**
 * Describes a tool with a shape to a model that has its settings, material and frames already. The
 * points of a mesh that has not changed are those of models that still use them. False, with the
 * reason and the cure in `error`, if it can't be felt.
 */
bool DescribePointShell(vtkHapticPointShell* shell, HapticModelDescription& d, std::string& error);

} // namespace VolumeHaptics

#endif
