// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The kinds of vtkHapticMode.
 */
#ifndef HapticModeKinds_h
#define HapticModeKinds_h

#include "Core/Model/BakedMode.h"

#include "vtkHapticMode.h"

#include <vector>

class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/**
 * The properties that differ between the kinds of vtkHapticMode. The kinds' names are the choices
 * of Kind in Module/VTK/Settings.json; Core/Model/BakedMode.h describes what a tick computes for
 * each kind.
 */
struct ModeKindRow
{
  /**
   * Names of the functions Strength and SecondStrength in files and errors. The name of a function
   * that the kind lacks is null.
   */
  const char* Functions[2];
  /** The settings that only this kind has; null after the last one. */
  const char* Settings[2];
  /**
   * Returns the core's kind, and writes the settings that only this kind has to the description.
   */
  ModeKind (*Describe)(vtkHapticMode*, ModeDescription&);
};

const ModeKindRow& GetModeKind(vtkHapticMode* mode);

/** Returns which data of the touched image a mode reads. */
ModeInput GetInput(vtkHapticMode* mode);
/** Returns whether a mode can read an array with this many components. */
bool HasComponents(ModeInput input, int components);

/** A strength function of a mode. */
struct ModeFunction
{
  const char* Name; ///< name in files and errors
  const char* Getter;
  double Default; ///< N, the value of a function without points
  vtkPiecewiseFunction* Function;
};

std::vector<ModeFunction> GetModeFunctions(vtkHapticMode* mode);

} // namespace VolumeHaptics

#endif
