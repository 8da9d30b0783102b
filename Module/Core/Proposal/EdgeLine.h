// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The edge that a line along the gradient crosses: its plateaus, and how fast the value rises
 * between them.
 *
 * The values at both ends of the line, low and high, are those of an LH histogram. Slope and
 * curvature (the first and the second derivative along the line) are kept against the fraction of
 * the rise, (V - low) / (high - low), and divided by high - low. So the lines of one boundary can
 * be averaged wherever each of them crosses it, and a multiplicative bias has no effect on them.
 *
 * Kindlmann and Durkin, "Semi-automatic generation of transfer functions for direct volume
 * rendering", 1998, look at edges against their values; Sereda et al., "Visualization of boundaries
 * in volumetric data sets using LH histograms", 2006, look at the values at their ends.
 */
#ifndef EdgeLine_h
#define EdgeLine_h

#include "Core/Field/FieldSampler.h"
#include "Core/Math/Vector3.h"

#include <array>

namespace VolumeHaptics
{

struct EdgeLine
{
  /** The fractions of the rise at which slope and curvature are kept are (k + 1/2) / Fractions. */
  static constexpr int Fractions = 24;

  double Low = 0.0;
  double High = 0.0;
  /**
   * Whether both ends are plateaus; otherwise an end may be the middle of a layer that is too thin.
   */
  bool IsWide = false;
  /** The area of the boundary for which the line stands (relative). */
  double Weight = 0.0;
  /**
   * Where the edge is steepest, from the volume's first sample, and the direction from low to high
   * (world units).
   */
  Vector3 Centre;
  Vector3 Ahead;
  /** Variance of the estimator's own blur along the line (world units squared). */
  double Blur = 0.0;
  double Voxel = 1.0; ///< the length of a voxel along the line (world units)
  /** First derivative / (High - Low), per world unit. */
  std::array<float, Fractions> Slope{};
  /** Second derivative / (High - Low), per world unit squared. */
  std::array<float, Fractions> Curvature{};
};

/** The noise of a field, as slopes per voxel. */
struct EdgeThresholds
{
  double Least = 0.0; ///< the least slope of an edge
  double Flat = 0.0;  ///< the largest slope of a plateau
};

/**
 * Traces lines through a volume. The sampler estimates gradients that are the derivatives of its
 * values (GaussianWeights::OwnDerivative).
 */
class EdgeTracer
{
public:
  /**
   * Makes a tracer. `variance` is the variance of the estimator's kernel along an axis (voxels
   * squared).
   */
  EdgeTracer(const FieldSampler& field, const Affine3& indexToWorld, double variance,
    const EdgeThresholds& thresholds);

  /**
   * Returns the slope at an index (per voxel, along the gradient in the world); 0 if it is not
   * finite.
   */
  double Slope(const Vector3& index) const noexcept;

  /**
   * Traces the edge on whose slope an index stands. Returns false if there is too little slope, no
   * plateau within reach, or if the border of the volume or a sample that is not finite comes
   * before a plateau.
   */
  bool Trace(const Vector3& index, EdgeLine& line) const noexcept;

private:
  struct Ray;
  struct Profile;

  bool Aim(Ray& ray) const noexcept;
  bool Climb(Ray& ray) const noexcept;
  bool WalkSide(const Ray& ray, int side, Profile& profile) const noexcept;

  const FieldSampler& Field;
  Matrix3 WorldToIndex;
  Matrix3 IndexToWorld;
  double Variance;
  EdgeThresholds Thresholds;
};

/**
 * Returns the variance of an estimator's kernel along an axis (voxels squared): the amount that the
 * kernel adds to x^2.
 */
double MeasureKernelVariance(const GradientKernel& kernel);

} // namespace VolumeHaptics

#endif
