// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The kinds of vtkHapticMode.
 */
#ifndef HapticModeKinds_h
#define HapticModeKinds_h

#include "vtkHapticMode.h"

#include <vector>

class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/** A strength function of a mode. */
struct ModeFunction
{
  const char* Name; ///< as in Get... and Set...
  double Default;   ///< N, of a function without points
  vtkPiecewiseFunction* (*Get)(vtkHapticMode*);
};

/** The array that a kind of mode is about. */
enum class ModeInput
{
  None,
  Vectors,
  Tensors
};

/** A kind of mode; its class is vtkHapticNAMEMode. */
struct ModeKindRow
{
  const char* Name; ///< as in files
  ModeInput Input;
  vtkSmartPointer<vtkHapticMode> (*Make)();
  std::vector<ModeFunction> Functions; ///< two at most
};

const std::vector<ModeKindRow>& GetModeKinds();
/** Whether a mode is of one of these kinds. An application's own class of modes is of none. */
bool HasModeKind(vtkHapticMode* mode);
/** The kind of a mode that has one. */
const ModeKindRow& FindModeKind(vtkHapticMode* mode);

/** A mode as the user sees it, such as "vector follow, velocity". */
std::string GetModeText(vtkHapticMode* mode);

/** Prints the settings that all kinds have, for PrintSelf. */
void PrintMode(std::ostream& os, vtkIndent indent, vtkHapticMode* mode);

} // namespace VolumeHaptics

#endif
