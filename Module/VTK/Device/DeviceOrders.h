// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Carries out the calls of vtkHapticDevice.
 */
#ifndef DeviceOrders_h
#define DeviceOrders_h

#include "VTK/Device/DeviceSession.h"
#include "VTK/Device/ModelSource.h"

#include <functional>
#include <string>

class vtkHapticDevice;

namespace VolumeHaptics
{

/**
 * Implements the functions of vtkHapticDevice as its header documents them. Reports errors through
 * the device, whose observers may stop it, close it, or release its last reference.
 */
class DeviceOrders
{
public:
  DeviceOrders(vtkHapticDevice* device, DeviceSession& session, ModelSource& models)
    : Device(device)
    , Session(session)
    , Models(models)
  {
  }

  ///@{
  /**
   * Open or close the device. Afterwards, update MaximumForce, which depends on the open device.
   */
  bool Open(const std::string& id, const DeviceOptions& options);
  bool CalibrateForce(double scale);
  ///@}
  void ForgetConfirmation();

  bool Start();
  bool Publish();
  /**
   * Publishes the model that Publish() left to the background, once it is ready. Call this often.
   */
  void Poll();
  /** Stops the background work of Prepare(). */
  void EndPreparing();
  /** Publishes the next region of the volume once it has been read: see vtkHapticRegionSource. */
  void PollRegion();
  /** Publishes the next time steps of a moving volume: see DataPlayback. */
  void PollTimeSteps();
  /** Sends the device's limits to the running servo. */
  void SendLimits();

  void Arm();
  void Disarm();
  void FadeOut();
  void Home();
  void SetClutch(bool on);

  void BeginLongWork(const char* what, double expectedSeconds);
  void EndLongWork();

  /** Reports an error through the device, unless the text is empty. */
  void ReportError(const std::string& error);
  /** Reports a new error about the user's file of devices, if there is one. */
  void ReportMemoryTrouble();

private:
  bool StartServo();
  SafetyLimits MakeLimits() const;
  /**
   * Executes an order that enables force. Reports an error and returns false if the device is not
   * ready or the guard cannot be set up.
   */
  bool LetForceThrough(const std::function<void()>& order);
  void AnnounceDisarmed();
  /**
   * While the whole surface is being meshed, publishes the mesh of the region around the tip, if
   * there is one.
   */
  void PublishRegion(double rate);
  /**
   * Stores, for the status, what Publish() or Start() has left to the background; null means
   * nothing.
   */
  void SetAwaited(const char* work);

  vtkHapticDevice* const Device;
  DeviceSession& Session;
  ModelSource& Models;
  const char* Awaited = nullptr; ///< last value of SetAwaited()
  bool IsAnnouncing = false;     ///< true while observers of DisableEvent are called
};

} // namespace VolumeHaptics

#endif
