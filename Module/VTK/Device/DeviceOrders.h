// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Carries out the orders of a vtkHapticDevice's owner.
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
 * Carries out what the functions of vtkHapticDevice document. Errors are reported by the device,
 * and its observers are called: they may stop it, close it, or release its last reference.
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
  /** Update the device's MaximumForce after these calls: it depends on the open device. */
  bool Open(const std::string& id, const DeviceOptions& options);
  bool CalibrateForce(double scale);
  ///@}
  void ForgetConfirmation();

  bool Start();
  bool Publish();
  /**
   * Publishes the model that Publish() left to the background when it is ready; call this often.
   */
  void Poll();
  /** Ends the background work for that model. */
  void EndPreparing();
  /** Publishes another region of the volume when it is there: see vtkHapticRegionSource. */
  void PollRegion();
  /** Publishes the next time steps of a volume that moves: see DataPlayback. */
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

  /** Reports an error of the device, unless the text is empty. */
  void ReportError(const std::string& error);
  /** Reports an error about the user's file of devices, if there is a new one. */
  void ReportMemoryTrouble();

private:
  bool StartServo();
  SafetyLimits MakeLimits() const;
  /**
   * Executes an order that lets force through. False, after an error, if the device is not ready or
   * the guard can't be set up.
   */
  bool LetForceThrough(const std::function<void()>& order);
  void AnnounceDisarmed();
  /** Publishes the surface around the tip, if there is one while the whole is being meshed. */
  void PublishRegion(double rate);
  /** Stores for the status what Publish() or Start() left to the background; null if nothing. */
  void SetAwaited(const char* work);

  vtkHapticDevice* const Device;
  DeviceSession& Session;
  ModelSource& Models;
  const char* Awaited = nullptr; ///< text of SetAwaited()
  bool IsAnnouncing = false;     ///< true while observers are told that the device was disarmed
};

} // namespace VolumeHaptics

#endif
