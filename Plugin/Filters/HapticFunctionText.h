// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads functions from texts that a user types.
 */
#ifndef HapticFunctionText_h
#define HapticFunctionText_h

#include <string>

class vtkPiecewiseFunction;

/**
 * Adds the points in a text to a function. The text is a number, which is the value everywhere, or
 * pairs of a position and a value, such as "0 0, 0.5 2". An empty text adds nothing. Returns false
 * for any other text.
 */
bool ReadFunctionText(std::string text, vtkPiecewiseFunction* function);

#endif
