// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of the report that checks what the paper says of its method beside others.
 *
 * Nothing here is required of anybody: the numbers are what they are.
 */
#ifndef Evaluation_Comparison_h
#define Evaluation_Comparison_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

/** The content of a picture of the report that is not a plot. */
struct Picture
{
  std::string File; ///< without extension
  std::string Title;
};

struct Comparison
{
  std::vector<Table> Tables;
  std::vector<Plot> Plots;
};

/** The value (HU) on whose isosurface bone is touched. */
constexpr double BoneValue = 300.0;

/** If the volume is null or has no bone, bone is left out, with the reason in its place. */
Comparison CompareMethods(vtkImageData* volume, const Effort& effort);

/** The fraction of the Z-width that a method needs; adds a plot for each delay. */
Table CompareStability(const Effort& effort, std::vector<Plot>& plots);

} // namespace evaluation

#endif
