// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How smooth the skin and the bone of a real scan feel, and what makes them rough.
 */
#ifndef Evaluation_Feel_h
#define Evaluation_Feel_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

/** A stroke along a surface at constant depth under its smoothed course, at 50 mm/s. */
struct Arc
{
  Path Tips;               ///< mm, one a tick
  std::size_t Pressed = 0; ///< how many of these press, before the others stroke
};

/**
 * Arcs around the vertical axis through the middle of a CT in the upper half of its height, along
 * the outermost surface at which a value (HU) is reached, and below which, for 4 mm, it stays
 * reached: a head rest is thinner. Arcs end where the surface leaps (ears), and are 30 mm long at
 * least. With `beyond` (mm), the hand first presses so much deeper, through what lies above.
 */
std::vector<Arc> FindArcs(vtkImageData* volume, double level, double beyond, const Effort& effort);

/**
 * Roughness of the force on skin (-300 HU) and skull (300 HU) of a CT with preset "CT contrast",
 * for all methods; and for PRECISE with one cause of roughness taken away at a time. Adds a plot of
 * each surface.
 */
Table CompareFeel(vtkImageData* volume, const Effort& effort, std::vector<Plot>& plots);

} // namespace evaluation

#endif
