// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The boundaries between materials, from many edges: clusters of their LH histogram.
 */
#ifndef Boundaries_h
#define Boundaries_h

#include "Core/Proposal/EdgeLine.h"

#include <vector>

namespace VolumeHaptics
{

/** The lines that cross from one material to another. */
struct Boundary
{
  /** The values of the materials on both sides. */
  double Low = 0.0;
  double High = 0.0;
  /** The first quartile of the lines' rises: smaller than High - Low under a bias. */
  double LeastRise = 0.0;
  /** The standard deviation s of the blurred step (world units): V = Low + (High - Low) Phi(x/s).
   */
  double Width = 0.0;
  /** Variance of the estimator's own blur (world units squared), which Width does not include. */
  double Blur = 0.0;
  double Voxel = 0.0; ///< the mean length of a voxel along the lines (world units)
  /** The boundary's fraction of the area of all boundaries. */
  double Fraction = 0.0;
  /** The fraction of the lines that are brighter towards the middle of all edges. */
  double Inward = 0.0;
};

/**
 * The values of materials as the histogram sees them. A multiplicative bias, such as that of a coil
 * in MRI, moves all values of a logarithmic axis by the same amount; close to zero it is linear.
 */
class ValueAxis
{
public:
  /**
   * Makes a logarithmic axis if the lines have no value below 0 other than noise, else a linear
   * one.
   */
  ValueAxis(const std::vector<EdgeLine>& lines, double noise);

  double operator()(double value) const noexcept;
  double Span() const noexcept { return this->Last - this->First; }
  double First = 0.0;
  double Last = 1.0;

private:
  double Scale = 0.0; ///< the axis is logarithmic from this value on; 0: linear
};

/**
 * Returns the boundaries in descending order of their fractions; leaves out boundaries with hardly
 * any lines.
 */
std::vector<Boundary> DetectBoundaries(const std::vector<EdgeLine>& lines, const ValueAxis& axis);

} // namespace VolumeHaptics

#endif
