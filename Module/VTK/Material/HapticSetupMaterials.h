// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads transfer functions, and the materials of a vtkHapticProperty, in setups and
 * presets.
 */
#ifndef HapticSetupMaterials_h
#define HapticSetupMaterials_h

#include "VTK/Base/HapticSetupNode.h"

#include <functional>

class vtkColorTransferFunction;
class vtkHapticProperty;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

///@{
/** Reads or writes a function in a node of its own. The getter may create the function. */
void PassFunction(
  SetupNode node, const NumberRange& values, const std::function<vtkPiecewiseFunction*()>& get);
void PassColors(SetupNode node, const std::function<vtkColorTransferFunction*()>& get);
///@}

/**
 * Reads or writes functions, settings and tissues. Each change of functions and tissues calls the
 * getter again.
 */
void PassMaterials(SetupNode node, const std::function<vtkHapticProperty*()>& get);

} // namespace VolumeHaptics

#endif
