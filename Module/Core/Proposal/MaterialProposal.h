// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Material functions that a volume's boundaries suggest.
 *
 * The values on both sides of the boundaries are materials. All of them have one stiffness, so that
 * a surface is felt where it is; they are told apart by strength, friction and drag:
 *
 *   strength     Strongest dV / dV_max of the largest rise dV of a boundary that leads into it; the
 *                Ceiling for the largest rise into a material with another one in front of it and
 *                none behind
 *   friction     rises from material to material, as their values do
 *   drag         as friction; none outside
 *   distinctness 0 up to the larger one of 3.4 sigma_g and 0.2 g_max, 1 from 0.5 g_max on; g_max is
 *                the largest slope that the estimator finds at the weakest boundary, and sigma_g
 *                the noise of its gradients
 *
 * Around each value the functions are constant, and between two of them there is a wide blend: a
 * steep function would turn noise and partial volumes into changes of the force. The background has
 * neither strength nor drag up to where its noise ends.
 */
#ifndef MaterialProposal_h
#define MaterialProposal_h

#include "Core/Math/PiecewiseTable.h"
#include "Core/Proposal/Boundaries.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace VolumeHaptics
{

enum class ProposedSide : std::uint8_t
{
  Higher,
  Lower,
  Both
};

/** Facts about a volume that its edges do not show. */
struct ProposalFacts
{
  double Outside = 0.0; ///< value at the volume's border
  /**
   * Value at which the background ends. All values on the background's side of it are one material,
   * however noisy they are.
   */
  std::optional<double> BackgroundEnd;
  double SearchVariance = 1.0; ///< variance (voxels squared) of the kernel that found the edges
  int MostRadius = 2;          ///< largest kernel radius (voxels) that the volume allows
  /**
   * Returns 3.4 times the standard deviation of a gradient's noise (scalar units per world unit)
   * for a kernel radius.
   */
  std::function<double(int)> NoiseGradient;

  /** Returns whether a value belongs to the noisy background. */
  bool Covers(double value) const noexcept;
};

struct MaterialProposal
{
  static constexpr double Stiffness = 500.0; // N/m
  static constexpr double Strongest = 3.0;   // N; any device can break through
  static constexpr double Ceiling = 12.0;    // N; more than most devices exert

  /** Boundaries that are felt, in descending order of area times rise. */
  std::vector<Boundary> Boundaries;
  std::vector<double> Slopes; ///< for each boundary, its largest slope as the kernel estimates it
  std::vector<double> Materials; ///< values of the materials, in ascending order
  std::size_t Background = 0;    ///< index of the material outside
  ProposedSide Side = ProposedSide::Higher;
  int KernelRadius = 2; ///< voxels
  Polyline SurfaceStrength;
  Polyline Friction;
  Polyline Viscosity;
  Polyline Distinctness;
};

/**
 * Proposes material functions. The proposal has no boundaries if all of them are hidden by noise.
 */
MaterialProposal ProposeMaterials(
  const std::vector<Boundary>& boundaries, const ValueAxis& axis, const ProposalFacts& facts);

} // namespace VolumeHaptics

#endif
