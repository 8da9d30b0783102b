// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions that properties, modes and tools own, and the polylines that the core bakes from them.
 */
#ifndef HapticFunctions_h
#define HapticFunctions_h

#include "Core/Math/PiecewiseTable.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkHapticProperty;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/**
 * Chord error allowed on a curved piece, as a fraction of the piece's height and of the value
 * there.
 */
constexpr double CurveTolerance = 1e-4;
constexpr double CurveValueTolerance = 1e-3;

/**
 * Converts a function to a polyline: exactly for linear pieces and steps, within CurveTolerance for
 * curved pieces. A function without points gives the constant `emptyValue`.
 */
Polyline ToPolyline(vtkPiecewiseFunction* function, double emptyValue);

/**
 * Returns an error that names the first point of a function whose value is negative, above a
 * maximum or not finite, with the cure; empty if there is no such point.
 *
 * @param what such as "Strength of a vtkHapticMode of kind Vortex"
 * @param allowed such as "0 N or more"
 * @param getter such as "vtkHapticMode::GetStrength()"
 */
std::string DetectFunctionFault(const Polyline& line, double maximum, const std::string& what,
  const std::string& allowed, const std::string& getter);

/** Converts a function of the property's values to a function of scalars. */
void ToScalars(vtkHapticProperty* property, Polyline& line);

/** Returns the function that an object owns; creates it on the first call. */
vtkPiecewiseFunction* ProvideFunction(vtkSmartPointer<vtkPiecewiseFunction>& owned);

/**
 * Makes a function equal to another one, in place, with all of its nodes: vtkPiecewiseFunction's
 * DeepCopy() loses one of two nodes at one position, and the logarithmic scale. A function that is
 * equal already is not modified.
 */
void CopyFunction(vtkPiecewiseFunction* source, vtkPiecewiseFunction* target);

} // namespace VolumeHaptics

#endif
