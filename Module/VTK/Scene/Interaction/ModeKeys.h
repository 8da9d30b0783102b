// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which modes of PRIMITIVES are felt: by a key, and by clicks on their list.
 */
#ifndef ModeKeys_h
#define ModeKeys_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include <vector>

namespace VolumeHaptics
{

class ModeKeys
{
public:
  explicit ModeKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /**
   * The next mode alone; after the last one all of them, unless those are too many for a tick.
   * False if PRIMITIVES is not felt.
   */
  bool Next();
  /** The mode in the list of the head-up display at a position, on or off. False if none is. */
  bool Click(int x, int y);

private:
  vtkVolumeHapticsFilter* FindFilter() const;
  /** Takes everything back, with a notice, if that can't be felt. */
  void Set(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active);

  TouchedScene& Scene;
};

} // namespace VolumeHaptics

#endif
