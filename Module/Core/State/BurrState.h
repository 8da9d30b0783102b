// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a burr from tick to tick, in addition to its head's ShellState. See
 * Core/Tools/Burr/BurrTool.h.
 */
#ifndef BurrState_h
#define BurrState_h

#include "Core/Math/Vector3.h"

#include <cstdint>

namespace VolumeHaptics
{

struct BurrState
{
  bool IsCarving = false; ///< whether the next step of carving starts at Carved
  bool IsRemoved = false; ///< whether the sphere at Carved was removed
  Vector3 Carved;         ///< centre (m) of the last removed sphere
  double Unspent = 0.0;   ///< energy (J) that the hand has put in, but carving has not used yet
  ///@{
  /** Cost (J) and length (m) of the last steps. */
  double LastCost = 0.0;
  double LastWay = 0.0;
  ///@}
  double Idle = 0.0;  ///< time (s) since the burr last removed tissue
  double Phase = 0.0; ///< phase of the vibration, 0 to 1
  double Lost = 0.0;  ///< energy (J) that the hand has lost, and that the vibration may give back
  Vector3 Vibration;  ///< force (N) of the vibration in the last tick
  ///@{
  /**
   * A sphere whose removal takes more than one tick: its centre (m), and the part to remove next.
   * Part is 0 if there is no such sphere.
   */
  Vector3 Next;
  std::uint32_t Part = 0;
  ///@}
  /**
   * Limit (m) of the next step's length. It is set if a later part of a step met tissue that can't
   * be removed, and 0 if there is no limit.
   */
  double Shorter = 0.0;
  /**
   * Radius of the sphere at Carved, minus the radius of the head (m). It grows while tissue still
   * holds the head.
   */
  double Room = 0.0;
};

} // namespace VolumeHaptics

#endif
