// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Proposes material functions from the boundaries in a volume.
 *
 * The values on both sides of the boundaries are materials. All of them get the same stiffness, so
 * that a surface is felt at its true place. They differ in strength, friction and drag:
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
 * The functions are constant around each material's value, with a wide blend between two values,
 * because steep functions would turn noise and partial volumes into changes of the force. The
 * background has neither strength nor drag up to the value where its noise ends.
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

/** Properties of a volume that its edges do not show. */
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
   * Returns 3.4 times the standard deviation of the gradient's noise (scalar units per world unit)
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

  /** Boundaries that are felt, sorted by area times rise, the largest first. */
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
 * Proposes material functions. If noise hides all boundaries, the proposal has none.
 */
MaterialProposal ProposeMaterials(
  const std::vector<Boundary>& boundaries, const ValueAxis& axis, const ProposalFacts& facts);

} // namespace VolumeHaptics

#endif
