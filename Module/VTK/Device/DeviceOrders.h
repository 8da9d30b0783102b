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
 * Carries out the functions of vtkHapticDevice as its header documents them. Errors are reported by
 * the device, and its observers are called: they may stop it, close it, or release its last
 * reference.
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
   * Publishes the model that Publish() has left to the background, once it is ready. Call this
   * often.
   */
  void Poll();
  /** Ends the background work for that model. */
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

  /** Reports an error of the device, unless the text is empty. */
  void ReportError(const std::string& error);
  /** Reports an error about the user's file of devices, if there is a new one. */
  void ReportMemoryTrouble();

private:
  bool StartServo();
  SafetyLimits MakeLimits() const;
  /**
   * Executes an order that lets force through. Reports an error and returns false if the device is
   * not ready or if the guard cannot be set up.
   */
  bool LetForceThrough(const std::function<void()>& order);
  void AnnounceDisarmed();
  /**
   * While the whole surface is being meshed, publishes the mesh around the tip, if there is one.
   */
  void PublishRegion(double rate);
  /**
   * Stores, for the status, which work Publish() or Start() has left to the background; null means
   * no work.
   */
  void SetAwaited(const char* work);

  vtkHapticDevice* const Device;
  DeviceSession& Session;
  ModelSource& Models;
  const char* Awaited = nullptr; ///< text of SetAwaited()
  bool IsAnnouncing = false;     ///< true while observers of a disarming are called
};

} // namespace VolumeHaptics

#endif
