// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Records the touch: by the device's own recording, or by a log if a region from a server is
 * touched.
 */
#ifndef HapticRecordingLink_h
#define HapticRecordingLink_h

#include "HapticStateLog.h"

#include <string>

class vtkHapticDevice;

namespace VolumeHapticsLive
{

class HapticRecordingLink
{
public:
  /**
   * Starts a recording or, if the device does not touch the whole volume (isWhole is false), a log.
   * IsOn() then returns whether this succeeded.
   */
  void Start(const char* file, bool isWhole, vtkHapticDevice* device, std::string& error);
  void Stop(vtkHapticDevice* device, std::string& error);
  bool IsOn() const { return this->IsRecording; }

  /** Write the device's new states to the log, if it is open. */
  void Continue(vtkHapticDevice* device) { this->Log.Continue(device); }

  /**
   * Closes the log. Call this after vtkHapticDevice::Stop(), which ends the device's own recording.
   */
  void Close(vtkHapticDevice* device, std::string& error);

private:
  HapticStateLog Log;
  bool IsRecording = false;
};

} // namespace VolumeHapticsLive

#endif
