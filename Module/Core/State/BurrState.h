// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a burr from tick to tick, beside that of its head, which is a ShellState: see
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
  bool IsCarving = false; ///< whether Carved is a place to go on from
  bool IsRemoved = false; ///< whether the sphere at Carved was removed
  Vector3 Carved;         ///< m, the centre of the sphere that is removed
  double Unspent = 0.0;   ///< J
  ///@{
  /** J and m, of the last steps: what a step costs. */
  double LastCost = 0.0;
  double LastWay = 0.0;
  ///@}
  double Idle = 0.0;  ///< s, since the burr last removed something
  double Phase = 0.0; ///< of the vibration, 0 to 1
  double Lost = 0.0;  ///< J, that the hand has lost, and the vibration may give back
  Vector3 Vibration;  ///< N, of the last tick
  ///@{
  /** A sphere that takes more than a tick: where it is (m), and which part is next; 0: none. */
  Vector3 Next;
  std::uint32_t Part = 0;
  ///@}
  /** m: the next step is no longer, since a later part of one met what nothing removes; 0: any. */
  double Shorter = 0.0;
  /** m: how much larger the sphere at Carved is, since the tissue around still held the head. */
  double Room = 0.0;
};

} // namespace VolumeHaptics

#endif
