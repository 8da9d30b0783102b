// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The displacement of a proxy while the tip makes one step, by the law of one material point.
 */
#ifndef ProxyDisplacement_h
#define ProxyDisplacement_h

#include "Core/Solvers/PreciseState.h"

namespace VolumeHaptics
{

/**
 * The displacement of a proxy (m) while the tip's step takes the spring of stiffness k (N/m) from
 * one lag (m) to another.
 *
 * Second order in the step if friction and drag hold all directions alike. `plain` is the
 * displacement by the law at the last lag alone, for steps without a mean direction.
 */
Vector3 FindProxyDisplacement(const PrecisePoint& here, double k, const Vector3& lagBefore,
  const Vector3& lag, const Vector3& plain) noexcept;

} // namespace VolumeHaptics

#endif
