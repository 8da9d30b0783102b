// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures how smooth the surfaces of real scans feel, and which causes make them rough.
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
  Figures Required; ///< figures of the surfaces that must be smooth
};

/**
 * Measures the roughness of the force on each surface for all methods, and for PRECISE also with
 * one cause of roughness removed at a time. Counts which changes of the material coincide with
 * drops of the force. Adds a plot for each surface.
 */
Feel MeasureFeel(const std::vector<FeltSurface>& surfaces);

/**
 * Compares, for each surface, its preset with the default settings, and for chest CTs also the
 * other chest presets.
 */
Table ComparePresets(const std::vector<FeltSurface>& surfaces);

/** Averages the function over a width of its argument, which limits the slope of ramps. */
void Widen(vtkPiecewiseFunction* function, double width);

/** Counts the drops of the force along strokes by what changed during the 5 ms of each drop. */
struct DropCauses
{
  int Drops = 0;
  int Strength = 0;    ///< surface strength changed by more than a factor of two
  int Stiffness = 0;   ///< stiffness changed by more than a fifth
  int Snap = 0;        ///< the proxy moved by more than 0.3 mm in a tick
  int Unexplained = 0; ///< none of the causes above
};

/** Adds the drops of a trace, beginning at tick `first`. */
void AddDropCauses(const Trace& trace, std::size_t first, DropCauses& causes);

} // namespace evaluation

#endif
