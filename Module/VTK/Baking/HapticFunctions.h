// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From vtkPiecewiseFunction to the polylines that the core bakes.
 */
#ifndef HapticFunctions_h
#define HapticFunctions_h

#include "Core/Math/PiecewiseTable.h"

class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/**
 * Chord error allowed on a curved piece, as a share of the piece's height, and of the value there.
 */
constexpr double CurveTolerance = 1e-4;
constexpr double CurveValueTolerance = 1e-3;

/**
 * The function as a polyline: exact for linear pieces and steps, within CurveTolerance for curved
 * pieces. A function without points gives the constant `emptyValue`.
 */
Polyline ToPolyline(vtkPiecewiseFunction* function, double emptyValue);

/**
 * Makes a function the same as another one, in place, with all of its nodes: vtkPiecewiseFunction's
 * DeepCopy() loses one of two nodes at one position, and the logarithmic scale. A function that is
 * the same already is not modified.
 */
void CopyFunction(vtkPiecewiseFunction* source, vtkPiecewiseFunction* target);

} // namespace VolumeHaptics

#endif
