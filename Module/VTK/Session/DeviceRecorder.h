// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Begins, ends and recovers the recordings of a vtkHapticDevice.
 */
#ifndef DeviceRecorder_h
#define DeviceRecorder_h

#include "VTK/Session/DeviceSession.h"

#include <string>

class vtkHapticDevice;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** Errors and warnings are those of the device, which also announces long work. */
class DeviceRecorder
{
public:
  DeviceRecorder(vtkHapticDevice* device, DeviceSession& session)
    : Device(device)
    , Session(session)
  {
  }

  ///@{
  /** See the functions of vtkHapticDevice. */
  bool Start(const std::string& file, vtkVolumeHapticsFilter* filter);
  bool Recover(const std::string& part, const std::string& file);
  ///@}

  /**
   * See vtkHapticDevice::StopRecording. Unless isAnnounced, writing is not announced as long work.
   */
  bool Stop(bool isAnnounced);

  /** Whether there is a recording that this process has to end. */
  bool IsUnderWay() const;

  /** The file of the recording that is under way; empty without one. */
  const std::string& GetFile() const { return this->File; }

  /**
   * Reports an error, once for a recording, if the recording fails, for example with a full disk.
   */
  void TellTrouble();

private:
  bool Begin(const std::string& file, vtkVolumeHapticsFilter* filter);
  TickCollector* FindRecordable(const std::string& file) const;

  vtkHapticDevice* const Device;
  DeviceSession& Session;
  std::string File;
  bool IsTroubleTold = false;
};

} // namespace VolumeHaptics

#endif
