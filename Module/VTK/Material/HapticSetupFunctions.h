// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads transfer functions in a setup.
 */
#ifndef HapticSetupFunctions_h
#define HapticSetupFunctions_h

#include "VTK/Base/HapticSetupNode.h"

#include <functional>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

///@{
/** Passes a function in its own node; the getter may create the function. */
void PassFunction(
  SetupNode node, const NumberRange& values, const std::function<vtkPiecewiseFunction*()>& get);
void PassColors(SetupNode node, const std::function<vtkColorTransferFunction*()>& get);
///@}

} // namespace VolumeHaptics

#endif
