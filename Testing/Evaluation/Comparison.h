// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file The part of the report that compares the paper's method with others, to check the paper's
 * claims.
 *
 * These numbers are information only; no test has bounds for them.
 */
#ifndef Evaluation_Comparison_h
#define Evaluation_Comparison_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

/** A picture in the report that is not a plot. */
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

/** Value (HU) of the isosurface that represents bone. */
constexpr double BoneValue = 300.0;

/**
 * Compares the methods. If the volume is null or has no bone, the result contains the reason
 * instead of the tables for bone.
 */
Comparison CompareMethods(vtkImageData* volume, const Effort& effort);

/**
 * Compares the methods by the stiffest wall on which a device comes to rest. Adds a plot for each
 * delay.
 */
Table CompareStability(const Effort& effort, std::vector<Plot>& plots);

} // namespace evaluation

#endif
