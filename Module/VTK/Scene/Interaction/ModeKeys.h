// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Chooses which modes of PRIMITIVES are felt: by a key, and by clicks on their list.
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
   * Feels the next mode alone; after the last one all modes, unless they are too many for a tick.
   * False if PRIMITIVES is not felt.
   */
  bool Next();
  /**
   * Switches the mode at a position in the head-up display's list on or off. False if none is
   * there.
   */
  bool Click(int x, int y);

private:
  vtkVolumeHapticsFilter* FindFilter() const;
  /** Undoes all changes, with a notice, if they can't be felt. */
  void Set(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active);

  TouchedScene& Scene;
};

} // namespace VolumeHaptics

#endif
