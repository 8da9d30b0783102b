// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A function as a text that a user types.
 */
#ifndef HapticFunctionText_h
#define HapticFunctionText_h

#include <string>

class vtkPiecewiseFunction;

/**
 * Adds the points of a text to a function: one number, which holds everywhere; or pairs of a
 * position and a number, such as "0 0, 0.5 2". False for any other text. An empty text adds
 * nothing.
 */
bool ReadFunctionText(std::string text, vtkPiecewiseFunction* function);

#endif
