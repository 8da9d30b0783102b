// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How smooth the surfaces of real scans feel, and what makes them rough.
 */
#ifndef Evaluation_Feel_h
#define Evaluation_Feel_h

#include "Comparison.h"
#include "Surfaces.h"

namespace evaluation
{

struct Feel
{
  Comparison Found;
  Figures Required; ///< of surfaces that are required to be smooth
};

/**
 * Roughness of the force on each surface, for all methods; for PRECISE also with one cause of
 * roughness taken away at a time. Then what happened to the material when the force dropped. A
 * plot for each surface.
 */
Feel MeasureFeel(const std::vector<FeltSurface>& surfaces);

/**
 * Each surface with its preset and the default settings, those of a chest CT also with the other
 * presets that are for it.
 */
Table ComparePresets(const std::vector<FeltSurface>& surfaces);

/** The function, averaged over a width of its argument: no ramp is steeper. */
void Widen(vtkPiecewiseFunction* function, double width);

/** Drops of the force along strokes, and what changed within the 5 ms of each. */
struct DropCauses
{
  int Drops = 0;
  int Strength = 0;    ///< what the surface holds changed more than twofold
  int Stiffness = 0;   ///< by more than a fifth
  int Snap = 0;        ///< the proxy moved by more than 0.3 mm in a tick
  int Unexplained = 0; ///< none of these
};

/** Adds those of a trace, from a tick on. */
void AddDropCauses(const Trace& trace, std::size_t first, DropCauses& causes);

} // namespace evaluation

#endif
