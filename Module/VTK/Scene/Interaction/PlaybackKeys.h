// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys of a volume that moves: see vtkInteractorStyleHaptic.
 */
#ifndef PlaybackKeys_h
#define PlaybackKeys_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include <string>

namespace VolumeHaptics
{

class PlaybackKeys
{
public:
  explicit PlaybackKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /** False if the key is none of them, or without a moving volume. */
  bool Press(const std::string& key);

private:
  TouchedScene& Scene;
};

} // namespace VolumeHaptics

#endif
