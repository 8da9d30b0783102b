// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Touching a region of a volume that is somewhere else: how much of what a tick reads is there.
 *
 * A model of a region (VolumeView::Whole) knows which of its borders are the volume's own, where
 * surfaces fade (HapticModel::BorderFade), and which are merely the region's, where they must not.
 * At those it says how *resident* a tick is instead. With c the voxels between the region's border
 * and what the tick can read (kernels, x_s, x_v, and the way between tip and proxy), over all
 * borders that are not the volume's own,
 *
 *   residency = s(c / ResidencyBand),   s(t) = t^2 (3 - 2 t) on 0 ... 1,
 *
 * so that it is 1 well inside, 0 from where a tick could read what is not there, and everything is
 * true in between. Models of whole volumes have a residency of 1.
 */
#ifndef Residency_h
#define Residency_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{
class HapticModel;
struct ServoState;

/**
 * Voxels that a kernel reads beyond its radius, that a motion bulges out between tip and proxy, and
 * one to spare.
 */
constexpr double ResidencySpare = 3.0;

/** How far (index steps along each axis) a tick reads around tip and proxy. */
Vector3 FindReadReach(const HapticModel& model) noexcept;

/** The residency of the tick that takes a state to a tip (device): 0 to 1. */
double FindResidency(
  const HapticModel& model, const ServoState& state, const Vector3& tip) noexcept;

} // namespace VolumeHaptics

#endif
