// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of HapticMethod::Primitives from tick to tick. See Primitives/PrimitiveFollower.h.
 */
#ifndef PrimitiveMemory_h
#define PrimitiveMemory_h

#include "Core/Math/Vector3.h"

#include <array>

namespace VolumeHaptics
{

/** Limit of the primitives in a tick. */
constexpr int MostPrimitives = 8;

/** The force (N) of each primitive on the hand. */
using PrimitiveForces = std::array<Vector3, MostPrimitives>;

struct PrimitiveMemory
{
  PrimitiveForces Forces{}; ///< forces of the primitives, in the order in which the field adds them
  double Rate = 1.0;        ///< rate r at which steps lower the field, learned from the last steps
  /** Direction of the proxy's last motion, of any length; 0 if the proxy has not moved. */
  Vector3 Towards;
};

} // namespace VolumeHaptics

#endif
