// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Handles what the mouse moves besides camera and tip: the slices, and the tool in the hand.
 */
#ifndef SceneMouse_h
#define SceneMouse_h

#include "Core/Math/Quaternion.h"
#include "VTK/Scene/Interaction/TouchedScene.h"

#include <array>

namespace VolumeHaptics
{

class TouchMode;

/**
 * Handles the mouse in the slices beside a scene: see vtkInteractorStyleHaptic.
 *
 * Functions return true if the event concerned the slices. Positions are pixels of the window.
 */
class SliceMouse
{
public:
  SliceMouse(TouchedScene& scene, TouchMode& touch)
    : Scene(scene)
    , Touch(touch)
  {
  }

  bool Press(int x, int y, bool isRight);
  /** Ends the drag with this button. */
  bool Release(bool isRight);
  bool Move(int x, int y);
  bool TurnWheel(double steps, int x, int y);

  /**
   * Returns whether events have changed the slices' picture without moving the tip, and resets
   * this.
   */
  bool DrainChange();

private:
  enum class Drag
  {
    None,
    Position,
    WindowLevel
  };

  /** Returns the index of the slice under the mouse; -1 if there is none. */
  int Find(int x, int y) const;
  void GoTo(int x, int y);
  /** Moves the tip to a position if the mouse controls it; otherwise only the slices. */
  void GoTo(const double position[3]);
  void SetWindowLevel(int x, int y);

  TouchedScene& Scene;
  TouchMode& Touch;
  Drag Dragged = Drag::None;
  bool IsRight = false;  ///< whether the drag uses the right button
  int Slice = 0;         ///< slice in which the drag began
  int From[2] = {};      ///< start of the drag
  double Before[2] = {}; ///< window and level at the start of the drag
  bool HasChanged = false;
};

/** Turns a shaped tool with the mouse, for a device that measures no orientation. */
class ToolTurn
{
public:
  explicit ToolTurn(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /** Returns whether the hand holds a tool that only the mouse can turn. */
  bool HasTool() const;
  /** Returns whether HasTool() is true and the key Alt is held. */
  bool IsOn() const;

  ///@{
  /**
   * Turn the tool. Roll() turns it like a ball under the pointer, which moves from one position to
   * another (pixels), about the view's axes right and up. Twist() turns it about the line of sight
   * by steps of the wheel. Shift reduces the turn.
   */
  void Roll(const int from[2], const int to[2]);
  void Twist(double steps);
  ///@}

private:
  /**
   * Turns the tool by a rotation vector (rad) with components along right, up and towards the
   * viewer.
   */
  void TurnBy(const Vector3& angles);
  /** Returns the orientation (world) from which the next turn starts. */
  Quaternion FindStart();

  TouchedScene& Scene;
  Quaternion Wish; ///< last ordered orientation (world)
  /** Device placement at the last turn, with which the hand turns. */
  std::array<double, 16> Placement{};
  double Turned = -1e9; ///< time (s) of the last turn
};

} // namespace VolumeHaptics

#endif
