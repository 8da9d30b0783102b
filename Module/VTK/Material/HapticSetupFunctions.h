// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Transfer functions in a setup, for writing and for reading alike.
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
/** A function in a node of its own; the getter may create it. */
void PassFunction(
  SetupNode node, const NumberRange& values, const std::function<vtkPiecewiseFunction*()>& get);
void PassColors(SetupNode node, const std::function<vtkColorTransferFunction*()>& get);
///@}

} // namespace VolumeHaptics

#endif
