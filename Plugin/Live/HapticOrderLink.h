// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Executes the orders in the properties Running, Armed and Recording of a device's proxy.
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
 * The properties are the user's orders. While Armed is 0, a device that was armed in another way is
 * disarmed. The device stores its current order, so an order to arm is never repeated here. Armed
 * becomes 0 when the device is disarmed in another way, such as by a key or a closed window, and
 * after a fault. All orders become 0 when the device stops; the user then has to repeat them.
 */
class HapticOrderLink
{
public:
  /** The names of the properties. */
  static constexpr const char* Names[] = { "Armed", "Recording", "Running" };

  /**
   * @param canReachServer returns whether the server can be reached; otherwise, nothing is armed
   */
  HapticOrderLink(vtkSMHapticDeviceProxy* proxy, vtkHapticDevice* device, HapticReport& report,
    std::function<bool()> canReachServer);
  ~HapticOrderLink() { this->Leave(); }
  HapticOrderLink(const HapticOrderLink&) = delete;
  HapticOrderLink& operator=(const HapticOrderLink&) = delete;

  /** Ends the link when the proxy is deleted; its properties no longer follow the device. */
  void Leave();

  /** Open and start the device if Running is 1 and the device does not run. */
  void ApplyRunning(vtkVolumeHapticsFilter* filter);
  /** Pass the filter to the servo if it has changed. */
  void Publish(vtkVolumeHapticsFilter* filter);
  /** Arm, disarm, record or stop according to the properties, and apply limits and tip. */
  void Apply();
  /** Execute only orders to disarm or stop, while the proxy is busy. */
  void ApplyCuts();
  /** Disarms the device after a fault; stops it if the server is lost. */
  void HandleFault(bool isServerLost);
  /** Write the device's new states to a log, if a log is open. */
  void Continue() { this->Recording.Continue(this->Device); }

  /**
   * Remove the force, stop the device, and reset the properties. `why` becomes the notice; "" for
   * no notice.
   */
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
  double MaximumForce = 0.0; // N: limit that was last applied; 0: the device's own limit
  // last applied position of the tip
  std::array<double, 3> Tip = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
};

} // namespace VolumeHapticsLive

#endif
