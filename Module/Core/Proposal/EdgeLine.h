// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A line along the gradient across an edge, with the plateaus at both ends, and the slope between
 * them.
 *
 * The values at both ends of the line, low and high, are those of an LH histogram. Slope and
 * curvature (the first and the second derivative along the line) are divided by high - low, and
 * stored as functions of the fraction of the rise, (V - low) / (high - low). The lines of a
 * boundary can therefore be averaged wherever they cross it, and a multiplicative bias does not
 * change them.
 *
 * The method combines two papers. Kindlmann and Durkin, "Semi-automatic generation of transfer
 * functions for direct volume rendering", 1998, plot the derivatives at edges against values.
 * Sereda et al., "Visualization of boundaries in volumetric data sets using LH histograms", 2006,
 * plot the values at the ends of edges.
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
  /**
   * Number of fractions of the rise at which slope and curvature are stored: (k + 1/2) / Fractions.
   */
  static constexpr int Fractions = 24;

  double Low = 0.0;
  double High = 0.0;
  /**
   * Whether both ends are plateaus. If not, an end may be the middle of a thin layer, whose real
   * value the line does not reach.
   */
  bool IsWide = false;
  /** Area of the boundary that the line represents, relative to other lines. */
  double Weight = 0.0;
  /**
   * Centre is where the edge is steepest, relative to the volume's first sample. Ahead is the
   * direction from low to high. Both are in world units.
   */
  Vector3 Centre;
  Vector3 Ahead;
  /** Variance (world units squared) of the estimator's own blur along the line. */
  double Blur = 0.0;
  double Voxel = 1.0; ///< length (world units) of a voxel along the line
  /** First derivative divided by High - Low, per world unit. */
  std::array<float, Fractions> Slope{};
  /** Second derivative divided by High - Low, per world unit squared. */
  std::array<float, Fractions> Curvature{};
};

/** Limits of slopes (per voxel) that distinguish edges, plateaus and noise. */
struct EdgeThresholds
{
  double Least = 0.0; ///< least slope of an edge
  double Flat = 0.0;  ///< largest slope of a plateau
};

/**
 * Traces lines across the edges of a volume. The sampler's gradients must be the derivatives of its
 * values (GaussianWeights::OwnDerivative).
 */
class EdgeTracer
{
public:
  /**
   * Makes a tracer. `variance` is the variance (voxels squared) of the estimator's kernel along an
   * axis.
   */
  EdgeTracer(const FieldSampler& field, const Affine3& indexToWorld, double variance,
    const EdgeThresholds& thresholds);

  /**
   * Returns the slope at an index, per voxel along the gradient in the world, or 0 if it is not
   * finite.
   */
  double Slope(const Vector3& index) const noexcept;

  /**
   * Traces the edge to whose slope an index belongs. Returns false if the slope is too small, if
   * there is no plateau within reach, or if the line reaches the volume's border or a sample that
   * is not finite before a plateau.
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
 * Returns the variance (voxels squared) of an estimator's kernel along an axis, which is the
 * smoothed value of x^2 at x = 0.
 */
double MeasureKernelVariance(const GradientKernel& kernel);

} // namespace VolumeHaptics

#endif
