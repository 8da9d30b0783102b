// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rounding down, for the sampling kernels: see FieldKernels.h for their rules.
 */
#ifndef KernelFloor_h
#define KernelFloor_h

#include "Core/Math/KernelInline.h"

#include <cstdint>

namespace VolumeHaptics
{
namespace
{

/** Returns the largest whole number that is not above a position; the position is not negative. */
VOLUME_HAPTICS_INLINE double Floor(double position)
{
#if defined(__SSE4_1__)
  return __builtin_floor(position); // one instruction with SSE4.1, a call elsewhere
#else
  return static_cast<double>(static_cast<std::int64_t>(position));
#endif
}

} // namespace
} // namespace VolumeHaptics

#endif
