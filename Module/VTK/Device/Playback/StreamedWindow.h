// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Windows of a volume whose frames come one by one, and how one follows another without a leap.
 */
#ifndef StreamedWindow_h
#define StreamedWindow_h

#include "Core/Model/BakedVolume.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

/** A frame of a window, for another one. */
VolumeFrame KeepFrame(const BakedVolume& window, std::size_t number);

/**
 * Whether a volume with frames at the times `next` is at a time what it is with frames at the times
 * `last`, of which the common ones are the same: at a frame of both, or between two neighbours.
 * Times are ascending.
 */
bool GoesOnWith(const std::vector<double>& last, const std::vector<double>& next, double time);

/**
 * The frames of `next`, and those of `last` between which a time is, where `next` does not go on
 * from it: so the volume goes from where it is to where it is next, whatever was left out. All are
 * windows of whole series of one volume, with the first frame once more at their ends. Null if they
 * are of different regions or have meshes, which would have to be made.
 */
std::shared_ptr<const BakedVolume> JoinWindows(
  const BakedVolume& last, const BakedVolume& next, double time);

} // namespace VolumeHaptics

#endif
