// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Leads the virtual device by positions in the world.
 */
#ifndef VirtualTip_h
#define VirtualTip_h

#include "Core/Math/Vector3.h"
#include "VTK/Device/DeviceSession.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Leads the virtual device; does nothing to other devices. Functions that return a string return an
 * error, or an empty string: see the functions of vtkHapticDevice with these names.
 */
class VirtualTip
{
public:
  explicit VirtualTip(DeviceSession& session)
    : Session(session)
  {
  }

  ///@{
  /** Leads the tip to a position in the world: at the speed of the hand, or at once. */
  std::string Lead(const Vector3& world, const Affine3& deviceToWorld);
  std::string Place(const Vector3& world, const Affine3& deviceToWorld);
  ///@}
  /** Speed of the tip on its way to where it is led, without dynamics (m/s). */
  static double GetSpeed() { return VirtualDynamics().HandSpeed; }
  /**
   * Turns the stylus to an orientation in the world, of any norm; four zeros remove the
   * orientation.
   */
  std::string Turn(Quaternion world, const Affine3& deviceToWorld);
  /** Turns the tool in the hand of any device likewise: see vtkHapticDevice::SetTipOrientation. */
  std::string TurnHand(Quaternion world, const Affine3& deviceToWorld);
  void SetButtons(int buttons);
  std::string SetDynamics(
    double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay);
  std::string SetLimits(
    double maximumForce, double maximumStiffness, double maximumDamping, double friction);

private:
  std::string Check(const Vector3& world) const;

  DeviceSession& Session;
};

} // namespace VolumeHaptics

#endif
