// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Connects a filter in the client with the touched data, on this process or on a server.
 */
#ifndef HapticDataLink_h
#define HapticDataLink_h

#include "HapticCropLink.h"
#include "HapticFrameLink.h"
#include "HapticImageLink.h"
#include "HapticLargeLink.h"
#include "HapticOpacityLink.h"
#include "HapticRegionLink.h"
#include "HapticTouchLink.h"

#include "vtkSmartPointer.h"

#include <functional>

class vtkHapticDevice;
class vtkSMProxy;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;
class vtkVolumeProperty;

namespace VolumeHapticsLive
{

class HapticReport;

class HapticDataLink
{
public:
  /** `lost` is called as soon as the server does not answer. */
  explicit HapticDataLink(std::function<void()> lost);

  /**
   * Follow changes of the device's properties Touch, FollowOpacity and MaximumRegionVoxels, of the
   * pipeline, and of its time. Problems go to the report.
   */
  void Follow(vtkSMProxy* proxy, vtkHapticDevice* device, HapticReport& report);

  /** The filter in the client; null while there is nothing to touch. */
  vtkVolumeHapticsFilter* GetFilter() const { return this->Touch.GetFilter(); }

  /** Whether a proxy is touched, or is the view that shows the touched data. */
  bool Uses(vtkSMProxy* proxy) const;

  /** See vtkSMHapticDeviceProxy::SetVisibility. */
  void SetVisibility(vtkVolumeProperty* property) { this->Visibility = property; }

  /** The time (s) of fetching a region; 0 before the first. */
  double GetLatency() const { return this->Region.GetLatency(); }

  /** Forget the last fetched region. */
  void ClearRegion() { this->Region.Clear(); }

  /** Whether the data are on this process. */
  static bool IsLocal(vtkSMProxy* proxy);

private:
  void FollowTime(vtkSMProxy* proxy, vtkSMSourceProxy* volume);
  void FollowImage(
    vtkSMSourceProxy* volume, unsigned int port, vtkHapticDevice* device, HapticReport& report);
  void FollowRegion(vtkSMProxy* proxy, vtkSMSourceProxy* volume, unsigned int port,
    vtkHapticDevice* device, HapticReport& report);

  const std::function<void()> Lost;
  HapticTouchLink Touch;
  HapticImageLink Image;
  HapticLargeLink Large;  // if the volume is larger than memory
  HapticFrameLink Frames; // if the volume has times
  HapticImageLink Surface;
  HapticImageLink Labels;
  HapticRegionLink Region; // if the data are on a server
  HapticOpacityLink Opacity;
  HapticCropLink Crop;
  vtkSmartPointer<vtkVolumeProperty> Visibility; // replaces the opacity that Opacity finds
  double ViewTime = 0.0;                         // s, time of the data
};

} // namespace VolumeHapticsLive

#endif
