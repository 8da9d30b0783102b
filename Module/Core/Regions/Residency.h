// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The residency of a tick, from 0 to 1. It is 1 if all samples that the tick can read are in
 * memory, with some distance to the border.
 *
 * A model of a region (VolumeView::Whole) has borders of two kinds. At the volume's own borders,
 * surfaces fade (HapticModel::BorderFade). At the region's other borders, the force is multiplied
 * by the *residency* of the tick instead. Let c be the smallest distance (voxels) between these
 * borders and all samples that the tick can read (kernels, x_s, x_v or the walk of FarSide.h, and
 * the path between tip and proxy). Then
 *
 *   residency = s(c / ResidencyBand),   s(t) = t^2 (3 - 2 t) on 0 ... 1,
 *
 * so that it is 1 well inside, and 0 before a tick could read a sample that is not resident. Models
 * of whole volumes have a residency of 1. If samples of a coarser level replace the volume's own,
 * the residency is multiplied by HapticModelDescription::ResidentShare.
 */
#ifndef Residency_h
#define Residency_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** Returns how far (index steps along each axis) around tip and proxy a tick reads samples. */
Vector3 ComputeReadReach(const HapticModel& model) noexcept;

/**
 * Computes the box of the samples that a tick reads when it moves from a state to a tip (device).
 * Returns false if the tick reads none.
 */
bool ComputeReadBox(
  const HapticModel& model, const ServoState& state, const Vector3& tip, ReadBox& box) noexcept;

/** Returns the residency (0 to 1) of a tick that moves from a state to a tip (device). */
double ComputeResidency(
  const HapticModel& model, const ServoState& state, const Vector3& tip) noexcept;

} // namespace VolumeHaptics

#endif
