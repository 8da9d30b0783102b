// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Windows of a volume whose frames come one by one, joined so that the volume does not jump.
 */
#ifndef StreamedWindow_h
#define StreamedWindow_h

#include "Core/Model/BakedVolume.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

/** Returns a frame of a window for use in another window. */
VolumeFrame KeepFrame(const BakedVolume& window, std::size_t number);

/**
 * Whether frames at the times `next` give the same volume at a time as frames at the times `last`.
 * The frames that both contain are equal, so this holds at a common frame, or between two
 * neighbours that both contain. Times are ascending.
 */
bool GoesOnWith(const std::vector<double>& last, const std::vector<double>& next, double time);

/**
 * Joins the frames of `next` to the two frames of `last` around a time, if `next` does not continue
 * `last` there: so the volume moves from its present shape to the next frames, whatever was left
 * out. All windows are whole series of one volume, with the first frame repeated at their ends.
 * Null if the windows are of different regions or have meshes, which would have to be made.
 */
std::shared_ptr<const BakedVolume> JoinWindows(
  const BakedVolume& last, const BakedVolume& next, double time);

} // namespace VolumeHaptics

#endif
