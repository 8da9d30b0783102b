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
 * Armed is 0. The device itself reports its present order; an order to arm is never repeated here.
 * Armed goes back to 0 when something else disarms the device, such as a key or a closed window,
 * and after a fault. All orders go back to 0 when the device is stopped. The user then has to order
 * again.
 */
class HapticOrderLink
{
public:
  /** The names of the properties. */
  static constexpr const char* Names[] = { "Armed", "Recording", "Running" };

  /** `canReachServer` returns whether the server can be reached; if not, nothing is armed. */
  HapticOrderLink(vtkSMHapticDeviceProxy* proxy, vtkHapticDevice* device, HapticReport& report,
    std::function<bool()> canReachServer);
  ~HapticOrderLink() { this->Leave(); }
  HapticOrderLink(const HapticOrderLink&) = delete;
  HapticOrderLink& operator=(const HapticOrderLink&) = delete;

  /** Ends the link when the proxy is being deleted: its properties no longer follow the device. */
  void Leave();

  /** Open and start the device if Running is 1 and it does not run. */
  void ApplyRunning(vtkVolumeHapticsFilter* filter);
  /** Pass the filter to the servo, if it has changed. */
  void Publish(vtkVolumeHapticsFilter* filter);
  /** Arm, disarm, record or stop, and take over limits and tip. */
  void Apply();
  /** Disarm only, for an order that comes while the proxy is busy. */
  void ApplyCuts();
  /** Disarms the device after a fault; stops it if the server is lost. */
  void HandleFault(bool isServerLost);
  /** Write the device's new states to a log. */
  void Continue() { this->Recording.Continue(this->Device); }

  /** Remove the force, stop, and reset the properties. The notice has the reason; "" for none. */
  void Stop(const std::string& why);

private:
  int GetInt(const char* name) const;
  void Reset(const char* name);
  void ApplyDisarm();
  void ApplyLimits();
  void ApplyTip();
  void ApplyRecording(bool record);
  void EndForce();

  vtkSMHapticDeviceProxy* const Proxy;
  vtkHapticDevice* const Device;
  HapticReport& Report;
  const std::function<bool()> CanReachServer;
  HapticRecordingLink Recording;
  vtkNew<vtkCallbackCommand> DisarmObserver;
  double MaximumForce = 0.0; // N, last applied; 0: the device's own choice
  std::array<double, 3> Tip = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX }; // last applied
};

} // namespace VolumeHapticsLive

#endif
