// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The mouse in the slices beside a scene: see vtkInteractorStyleHaptic.
 */
#ifndef SliceMouse_h
#define SliceMouse_h

#include "VTK/Scene/Interaction/TouchedScene.h"

namespace VolumeHaptics
{

class TouchMode;

/** Functions return true if the event was for the slices. Positions are pixels of the window. */
class SliceMouse
{
public:
  SliceMouse(TouchedScene& scene, TouchMode& touch)
    : Scene(scene)
    , Touch(touch)
  {
  }

  bool Press(int x, int y, bool isRight);
  /** Ends what the press of this button began. */
  bool Release(bool isRight);
  bool Move(int x, int y);
  bool TurnWheel(double steps, int x, int y);

  /** Whether the events have changed what the slices show, without a motion of the tip. */
  bool TakeChange();

private:
  enum class Drag
  {
    None,
    Position,
    WindowLevel
  };

  /** The slice under the mouse, if there are slices; else -1. */
  int Find(int x, int y) const;
  void GoTo(int x, int y);
  /** Leads the tip to a position, or if the mouse does not lead it, the slices. */
  void GoTo(const double position[3]);
  void SetWindowLevel(int x, int y);

  TouchedScene& Scene;
  TouchMode& Touch;
  Drag Dragged = Drag::None;
  bool IsRight = false;  ///< the button that drags
  int Slice = 0;         ///< in which the drag began
  int From[2] = {};      ///< where it began
  double Before[2] = {}; ///< window and level then
  bool HasChanged = false;
};

} // namespace VolumeHaptics

#endif
