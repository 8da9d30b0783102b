// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the kinds of vtkHapticMode with their properties.
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
 * Properties of a kind of vtkHapticMode. The kinds' names are the choices of Kind in
 * Module/VTK/Settings.json; Core/Model/BakedMode.h describes what a tick computes for each kind.
 */
struct ModeKindRow
{
  /**
   * Names of the functions Strength and SecondStrength in files and errors; null for a function
   * that the kind lacks.
   */
  const char* Functions[2];
  /** Settings that only this kind has, ended by null. */
  const char* Settings[2];
  /**
   * Returns the core's kind, and copies the settings that only this kind has to the description.
   */
  ModeKind (*Describe)(vtkHapticMode*, ModeDescription&);
};

const ModeKindRow& GetModeKind(vtkHapticMode* mode);

/** Returns which data of the touched image a mode reads. */
ModeInput GetInput(vtkHapticMode* mode);
/** Returns whether a mode can read an array with this many components. */
bool HasComponents(ModeInput input, int components);

/** A function of a mode, Strength or SecondStrength. */
struct ModeFunction
{
  const char* Name; ///< name in files and error texts
  const char* Getter;
  double Default; ///< value (N) of a function without points
  vtkPiecewiseFunction* Function;
};

std::vector<ModeFunction> GetModeFunctions(vtkHapticMode* mode);

} // namespace VolumeHaptics

#endif
