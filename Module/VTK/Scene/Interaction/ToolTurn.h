// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The mouse turns a tool with a shape whose device measures no orientation.
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
  /** The same while the key Alt says that the mouse turns it. */
  bool IsOn() const;

  ///@{
  /**
   * From one position of the pointer to another one (pixels), as a ball under the pointer: about
   * the view's axes that point up and right; and about the line of sight. A share of it with Shift.
   */
  void Roll(const int from[2], const int to[2]);
  void Twist(double steps);
  ///@}

private:
  /** By an angle vector (rad) along right, up and towards the viewer. */
  void TurnBy(const Vector3& angles);
  /** Where the next turn begins (world). */
  Quaternion FindStart();

  TouchedScene& Scene;
  Quaternion Wish;                    ///< world; as ordered last
  std::array<double, 16> Placement{}; ///< of the device then: the hand turns with it
  double Turned = -1e9;               ///< s, the time of the last turn
};

} // namespace VolumeHaptics

#endif
