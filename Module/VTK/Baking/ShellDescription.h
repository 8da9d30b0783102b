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
 * and the cure in `error`, if it never does or does so more than once.
 */
bool FindSolidLevel(const HapticMaterial& material, SolidLevel& level, std::string& error);

/**
 * Describes a tool with a shape to a model that has its settings, material and frames already. The
 * points of a mesh that has not changed are those of models that still use them. False, with the
 * reason and the cure in `error`, if it can't be felt.
 */
bool DescribePointShell(vtkHapticPointShell* shell, HapticModelDescription& d, std::string& error);

} // namespace VolumeHaptics

#endif
