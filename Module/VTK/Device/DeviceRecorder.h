// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Begins, ends and recovers the recordings of a vtkHapticDevice.
 */
#ifndef DeviceRecorder_h
#define DeviceRecorder_h

#include "VTK/Base/BackgroundWork.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Device/DeviceSession.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkHapticDevice;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Begins, ends and recovers recordings. Errors and warnings are reported by the device, which also
 * announces long work.
 */
class DeviceRecorder
{
public:
  DeviceRecorder(vtkHapticDevice* device, DeviceSession& session);
  ~DeviceRecorder();

  ///@{
  /** See the functions of vtkHapticDevice. */
  bool Start(const std::string& file, vtkVolumeHapticsFilter* filter);
  bool Recover(const std::string& part, const std::string& file);
  ///@}

  /** See vtkHapticDevice::StopRecording. Writing is announced as long work only if isAnnounced. */
  bool Stop(bool isAnnounced);

  /** Whether there is a recording that this process has to end. */
  bool IsUnderWay() const;

  /** The file of the recording that is under way; empty without one. */
  const std::string& GetFile() const { return this->File; }

  /**
   * Hands over the volume's hashes when they are known; call this often while a recording is under
   * way. Reports an error, once for each recording, if the recording fails, for example with a full
   * disk.
   */
  void Follow();

private:
  using HashKey = std::array<TouchedArray::Key, 2>; ///< keys of scalars and labels

  bool Begin(const std::string& file, vtkVolumeHapticsFilter* filter);
  /** Returns the hashes of what a filter touches now; null until they are known. */
  const RecordingHashes* FindHashes(vtkVolumeHapticsFilter* filter);
  /**
   * Hands over the hashes at the end of a recording. Waits for them, except while a hand would
   * wait, too.
   */
  void AwaitHashes(HapticRecording& recording);
  void TellTrouble();
  TickCollector* FindRecordable(const std::string& file) const;

  vtkHapticDevice* const Device;
  DeviceSession& Session;
  std::string File;
  vtkSmartPointer<vtkVolumeHapticsFilter> Felt; ///< set until its hashes are handed over
  KeyedWork<HashKey, RecordingHashes> Hashing;
  bool IsTroubleTold = false;
};

} // namespace VolumeHaptics

#endif
