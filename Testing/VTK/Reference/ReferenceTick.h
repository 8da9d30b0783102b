// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Computes one tick of method PROXY with the paper's solver, following the documentation step by
 * step, and one tick of FORCE_FIELD. Arguments and results are in world units; the computation is
 * in metres.
 */
#ifndef ReferenceTick_h
#define ReferenceTick_h

#include "ReferenceField.h"

namespace reference
{
/// Computes a tick. If the gradient vanishes, the unit vector `freeNormal` is the normal.
TickRecord ProxyTick(const ReferenceField& field, Scene& scene, const Vec3& proxy, const Vec3& tip,
  const Vec3& freeNormal);

TickRecord ForceFieldTick(
  const ReferenceField& field, Scene& scene, const Vec3& previousTip, const Vec3& tip);
} // namespace reference

#endif
