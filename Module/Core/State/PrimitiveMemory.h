// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of HapticMethod::Primitives from tick to tick: see Primitives/PrimitiveFollower.h.
 */
#ifndef PrimitiveMemory_h
#define PrimitiveMemory_h

#include "Core/Math/Vector3.h"

#include <array>

namespace VolumeHaptics
{

/** The most primitives in a tick. */
constexpr int MostPrimitives = 8;

/** The force (N) of each primitive on the hand. */
using PrimitiveForces = std::array<Vector3, MostPrimitives>;

/** The state that a tick passes to the next one. */
struct PrimitiveMemory
{
  PrimitiveForces Forces{}; ///< forces of the primitives, in the order in which the field adds them
  double Rate = 1.0;        ///< the rate r of the steps
  /** The direction of the proxy's last motion, of any length; 0 if it has not moved. */
  Vector3 Towards;
};

} // namespace VolumeHaptics

#endif
