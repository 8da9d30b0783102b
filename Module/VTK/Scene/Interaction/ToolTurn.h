// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Turns a shaped tool by the mouse if its device measures no orientation.
 */
#ifndef ToolTurn_h
#define ToolTurn_h

#include "Core/Math/Quaternion.h"
#include "VTK/Scene/Interaction/TouchedScene.h"

#include <array>

namespace VolumeHaptics
{

class ToolTurn
{
public:
  explicit ToolTurn(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /** Whether the hand holds a tool that only the mouse can turn. */
  bool HasTool() const;
  /** Whether, in addition, the key Alt is held. */
  bool IsOn() const;

  ///@{
  /**
   * Turns the tool from one position of the pointer to the next (pixels), like a ball under the
   * pointer: about the view's axes up and right, and about the line of sight. Less with Shift.
   */
  void Roll(const int from[2], const int to[2]);
  void Twist(double steps);
  ///@}

private:
  /** Turns by an angle vector (rad) along right, up and towards the viewer. */
  void TurnBy(const Vector3& angles);
  /** The orientation at which the next turn begins (world). */
  Quaternion FindStart();

  TouchedScene& Scene;
  Quaternion Wish;                    ///< world; the last ordered orientation
  std::array<double, 16> Placement{}; ///< placement of the device then: the hand turns with it
  double Turned = -1e9;               ///< s, the time of the last turn
};

} // namespace VolumeHaptics

#endif
