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
  /** Ends the action that the press of this button began. */
  bool Release(bool isRight);
  bool Move(int x, int y);
  bool TurnWheel(double steps, int x, int y);

  /** Whether events have changed what the slices show, without a motion of the tip. */
  bool TakeChange();

private:
  enum class Drag
  {
    None,
    Position,
    WindowLevel
  };

  /** The slice under the mouse; -1 if there is none. */
  int Find(int x, int y) const;
  void GoTo(int x, int y);
  /** Leads the tip to a position; if the mouse does not lead the tip, moves the slices there. */
  void GoTo(const double position[3]);
  void SetWindowLevel(int x, int y);

  TouchedScene& Scene;
  TouchMode& Touch;
  Drag Dragged = Drag::None;
  bool IsRight = false;  ///< the button that drags
  int Slice = 0;         ///< the slice in which the drag began
  int From[2] = {};      ///< start of the drag
  double Before[2] = {}; ///< window and level at the start
  bool HasChanged = false;
};

} // namespace VolumeHaptics

#endif
