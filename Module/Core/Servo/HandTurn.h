// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The orientation of a tool if the device measures none: the program turns the tool, for example by
 * the mouse.
 */
#ifndef HandTurn_h
#define HandTurn_h

#include "Core/Math/Quaternion.h"
#include "Core/Realtime/TripleBuffer.h"

namespace VolumeHaptics
{

/**
 * Lets the orientation follow the program's orders, no faster than a hand turns, so that a tool in
 * contact is not torn through the tissue. Begins at the last orientation that a device measured.
 */
class HandTurn
{
public:
  static constexpr double FastestTurn = 4.0; ///< rad/s

  ///@{
  /**
   * Orders an orientation: a unit quaternion in the device's space. There is no orientation before
   * the first call. Called by the owner.
   */
  void Order(const Quaternion& orientation) noexcept { this->Orders.Write({ orientation, true }); }
  void Forget() noexcept { this->Orders.Write({}); }
  ///@}

  /**
   * Sets the orientation, unless the device measured it; returns true if there is an orientation.
   * Called by the servo, once in a tick of a period (s).
   */
  bool Update(double period, Quaternion& orientation, bool isMeasured) noexcept;

private:
  struct Wish
  {
    Quaternion Orientation;
    bool IsThere = false;
  };
  TripleBuffer<Wish> Orders;
  Quaternion Now; ///< used by the servo
  bool IsNow = false;
};

} // namespace VolumeHaptics

#endif
