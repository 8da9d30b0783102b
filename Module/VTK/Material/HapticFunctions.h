// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts the functions of properties, modes and tools to the polylines that models use.
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
 * Largest error of a chord on a curved piece, as a fraction of the piece's height (CurveTolerance)
 * and of the value there (CurveValueTolerance).
 */
constexpr double CurveTolerance = 1e-4;
constexpr double CurveValueTolerance = 1e-3;

/**
 * Converts a function to a polyline: linear pieces and steps exactly, curved pieces within
 * CurveTolerance. A function without points becomes the constant `emptyValue`.
 */
Polyline ToPolyline(vtkPiecewiseFunction* function, double emptyValue);

/**
 * Returns an error that names the first point of a function whose value is negative, above a
 * maximum or not finite, with the cure; empty if there is no such point.
 *
 * @param what the function's name, such as "Strength of a vtkHapticMode of kind Vortex"
 * @param allowed the allowed values, such as "0 N or more"
 * @param getter the getter, such as "vtkHapticMode::GetStrength()"
 */
std::string DetectFunctionFault(const Polyline& line, double maximum, const std::string& what,
  const std::string& allowed, const std::string& getter);

/** Converts the positions of a function from the property's values to scalars. */
void ToScalars(vtkHapticProperty* property, Polyline& line);

/** Returns the function that an object owns, and creates it on the first call. */
vtkPiecewiseFunction* ProvideFunction(vtkSmartPointer<vtkPiecewiseFunction>& owned);

/**
 * Copies all nodes of `source` into `target` in place. The DeepCopy() of vtkPiecewiseFunction would
 * lose one of two nodes at the same position, and the logarithmic scale. Does not modify `target`
 * if the functions are already equal.
 */
void CopyFunction(vtkPiecewiseFunction* source, vtkPiecewiseFunction* target);

} // namespace VolumeHaptics

#endif
