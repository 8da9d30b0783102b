// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Carries out the orders in the properties Running, Armed and Recording of a device's proxy.
 */
#ifndef HapticOrderLink_h
#define HapticOrderLink_h

#include "HapticRecordingLink.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <string>

class vtkHapticDevice;
class vtkSMHapticDeviceProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

class HapticReport;

/**
 * The properties decide: a device that something else has armed is disarmed if Armed is 0. After a
 * fault, and if the device is stopped, the properties go back to 0, so that the user has to order
 * again.
 */
class HapticOrderLink
{
public:
  /** The names of the properties. */
  static constexpr const char* Names[] = { "Armed", "Recording", "Running" };

  /** `canReach` tells whether the server can be reached; if not, nothing is armed. */
  HapticOrderLink(vtkSMHapticDeviceProxy* proxy, vtkHapticDevice* device, HapticReport& report,
    std::function<bool()> canReachServer);

  /** Open and start the device if Running is 1 and it does not run. */
  void FollowRunning(vtkVolumeHapticsFilter* filter);
  /** Pass the filter to the servo, if it has changed. */
  void Publish(vtkVolumeHapticsFilter* filter);
  /** Arm, disarm, record or stop, and take over limits and tip. */
  void Take();
  /** Only disarm. For an order that comes while the proxy is busy. */
  void TakeCuts();
  /** After a fault, Armed goes back to 0. If the server is lost, the device is stopped. */
  void FollowFault(bool isServerLost);
  /** Take the device's new states into a log. */
  void Continue() { this->Recording.Continue(this->Device); }

  /** Zero force, stop, and reset the properties. The notice tells the reason; "" for none. */
  void Stop(const std::string& why);

private:
  int GetInt(const char* name) const;
  void Reset(const char* name);
  void TakeLimits();
  void TakeTip();
  void TakeRecording(bool record);
  void EndForce();

  vtkSMHapticDeviceProxy* const Proxy;
  vtkHapticDevice* const Device;
  HapticReport& Report;
  const std::function<bool()> CanReachServer;
  HapticRecordingLink Recording;
  bool IsArmed = false;      // by the last order
  double ArmedAt = 0.0;      // s, of the device
  double MaximumForce = 0.0; // N, taken over; 0: the device's own choice
  std::array<double, 3> Tip = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX }; // taken over
};

} // namespace VolumeHapticsLive

#endif
