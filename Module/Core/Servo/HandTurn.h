// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The orientation of a tool if the device does not measure one. The program rotates the tool, for
 * example with the mouse.
 */
#ifndef HandTurn_h
#define HandTurn_h

#include "Core/Math/Quaternion.h"
#include "Core/Realtime/TripleBuffer.h"

namespace VolumeHaptics
{

/**
 * Follows the orientations that the program orders, not faster than a hand rotates, so that a tool
 * in contact does not tear through the tissue. Begins at the last orientation that the device
 * measured.
 */
class HandTurn
{
public:
  static constexpr double FastestTurn = 4.0; ///< rad/s

  ///@{
  /**
   * Orders an orientation, a unit quaternion in the device's space. The owner calls this. Before
   * the first call there is no orientation.
   */
  void Order(const Quaternion& orientation) noexcept { this->Orders.Write({ orientation, true }); }
  void Forget() noexcept { this->Orders.Write({}); }
  ///@}

  /**
   * Sets the orientation, unless the device has measured it. Returns whether there is an
   * orientation. The servo calls this once in each tick of a period (s).
   */
  bool Update(double period, Quaternion& orientation, bool isMeasured) noexcept;

private:
  struct Wish
  {
    Quaternion Orientation;
    bool IsThere = false;
  };
  TripleBuffer<Wish> Orders;
  Quaternion Now; ///< orientation in the last tick; only the servo uses it
  bool IsNow = false;
};

} // namespace VolumeHaptics

#endif
