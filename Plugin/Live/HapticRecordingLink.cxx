// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticRecordingLink.h"

#include "vtkHapticDevice.h"

namespace VolumeHapticsLive
{

void HapticRecordingLink::Start(
  const char* file, bool isWhole, vtkHapticDevice* device, std::string& error)
{
  this->IsRecording =
    isWhole ? device->GetRecorder()->Start(file) : this->Log.Start(file, device, error);
}

void HapticRecordingLink::Stop(vtkHapticDevice* device, std::string& error)
{
  this->Log.Continue(device);
  this->Log.IsOpen() ? this->Log.Stop(device, error) : device->GetRecorder()->Stop();
  this->IsRecording = false;
}

void HapticRecordingLink::Close(vtkHapticDevice* device, std::string& error)
{
  this->Log.Stop(device, error);
  this->IsRecording = false;
}

} // namespace VolumeHapticsLive
