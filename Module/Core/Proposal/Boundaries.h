// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the boundaries between materials from many edges, as clusters in their LH histogram.
 */
#ifndef Boundaries_h
#define Boundaries_h

#include "Core/Proposal/EdgeLine.h"

#include <vector>

namespace VolumeHaptics
{

/** A boundary consists of all lines that lead from one material to another. */
struct Boundary
{
  /** The values of the materials on both sides. */
  double Low = 0.0;
  double High = 0.0;
  /** First quartile of the lines' rises. With a bias field, it is smaller than High - Low. */
  double LeastRise = 0.0;
  /** Standard deviation s (world units) of the blurred step V = Low + (High - Low) Phi(x/s). */
  double Width = 0.0;
  /** Variance (world units squared) of the estimator's own blur. It is not part of Width. */
  double Blur = 0.0;
  double Voxel = 0.0; ///< mean length (world units) of a voxel along the lines
  /** Area of this boundary as a fraction of the area of all boundaries. */
  double Fraction = 0.0;
  /** Fraction of the lines whose values rise towards the middle of all edges. */
  double Inward = 0.0;
};

/**
 * Maps the values of materials to the axis of the histogram. The axis is logarithmic, so that a
 * multiplicative bias, such as that of a coil in MRI, shifts all values by the same amount. Near
 * zero, the axis is linear.
 */
class ValueAxis
{
public:
  /**
   * Makes a linear axis if lines have negative values that are not noise, and otherwise a
   * logarithmic one.
   */
  ValueAxis(const std::vector<EdgeLine>& lines, double noise);

  double operator()(double value) const noexcept;
  double Span() const noexcept { return this->Last - this->First; }
  double First = 0.0;
  double Last = 1.0;

private:
  double Scale = 0.0; ///< value from which the axis is logarithmic; 0 if it is linear
};

/**
 * Returns the boundaries, sorted by fraction, the largest first. Drops boundaries with very few
 * lines.
 */
std::vector<Boundary> DetectBoundaries(const std::vector<EdgeLine>& lines, const ValueAxis& axis);

} // namespace VolumeHaptics

#endif
