// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LabelMemory_h
#define LabelMemory_h

#include "Core/Model/BakedLabels.h"
#include "Core/Model/LabelWalls.h"

namespace VolumeHaptics
{

/**
 * Memories of the last label lookups. They are kept from tick to tick to make lookups faster, and
 * change no result.
 */
struct LabelMemory
{
  WallMemory Wall;  ///< memory of the lookup around the proxy
  MixMemory Ahead;  ///< memory of the lookup at x_s
  MixMemory Behind; ///< memory of the lookup at x_v
};

} // namespace VolumeHaptics

#endif
