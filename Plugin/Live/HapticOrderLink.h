// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Carries out the orders in the properties Running, Armed and Recording of a device's proxy.
 */
#ifndef HapticOrderLink_h
#define HapticOrderLink_h

#include "HapticRecordingLink.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
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
 * The properties are orders of the user: a device that something else has armed is disarmed if
 * Armed is 0. The device itself tells which order it has; nothing here repeats an order to arm.
 * Armed goes back to 0 as soon as something else disarms the device, such as a key or a closed
 * window, and after a fault; all of them do if the device is stopped. The user then has to order
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
  ~HapticOrderLink() { this->Leave(); }
  HapticOrderLink(const HapticOrderLink&) = delete;
  HapticOrderLink& operator=(const HapticOrderLink&) = delete;

  /** The proxy is being deleted: its properties no longer follow the device. */
  void Leave();

  /** Open and start the device if Running is 1 and it does not run. */
  void FollowRunning(vtkVolumeHapticsFilter* filter);
  /** Pass the filter to the servo, if it has changed. */
  void Publish(vtkVolumeHapticsFilter* filter);
  /** Arm, disarm, record or stop, and take over limits and tip. */
  void Take();
  /** Only disarm. For an order that comes while the proxy is busy. */
  void TakeCuts();
  /** After a fault the device is disarmed. If the server is lost, it is stopped. */
  void FollowFault(bool isServerLost);
  /** Take the device's new states into a log. */
  void Continue() { this->Recording.Continue(this->Device); }

  /** Zero force, stop, and reset the properties. The notice tells the reason; "" for none. */
  void Stop(const std::string& why);

private:
  int GetInt(const char* name) const;
  void Reset(const char* name);
  void FollowDisarm();
  void TakeLimits();
  void TakeTip();
  void TakeRecording(bool record);
  void EndForce();

  vtkSMHapticDeviceProxy* const Proxy;
  vtkHapticDevice* const Device;
  HapticReport& Report;
  const std::function<bool()> CanReachServer;
  HapticRecordingLink Recording;
  vtkNew<vtkCallbackCommand> DisarmObserver;
  double MaximumForce = 0.0; // N, taken over; 0: the device's own choice
  std::array<double, 3> Tip = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX }; // taken over
};

} // namespace VolumeHapticsLive

#endif
