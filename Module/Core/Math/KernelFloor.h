// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A floor function for the sampling kernels, by the rules in FieldKernels.h.
 */
#ifndef KernelFloor_h
#define KernelFloor_h

#include "Core/Math/KernelInline.h"

#include <cstdint>

namespace VolumeHaptics
{
namespace
{

/**
 * Returns the largest whole number that is not above the position, which must not be negative.
 */
VOLUME_HAPTICS_INLINE double Floor(double position)
{
#if defined(__SSE4_1__)
  return __builtin_floor(position); // one instruction with SSE4.1; without it, a call
#else
  return static_cast<double>(static_cast<std::int64_t>(position));
#endif
}

} // namespace
} // namespace VolumeHaptics

#endif
