// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Connects a filter in the client to the touched data, which are in this process or on a server.
 */
#ifndef HapticDataLink_h
#define HapticDataLink_h

#include "HapticImageLink.h"
#include "HapticRegionLink.h"
#include "HapticTimeStepLink.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <functional>

class vtkHapticDevice;
class vtkObject;
class vtkSMProxy;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;
class vtkVolumeProperty;

namespace VolumeHapticsLive
{

class HapticReport;

/**
 * Makes a filter in the client with the settings of a filter proxy whose data may be elsewhere.
 *
 * If the followed filter is in this process, it shares the tissue that a burr in the hand has
 * removed, so that its paths begin with the remaining tissue. Otherwise the filter in the client
 * stores the removed tissue itself, and receives the commands to undo, redo and restore, too.
 *
 * The client's filter belongs to a second proxy of the same kind, whose objects exist only in the
 * client. Every property of the first proxy is copied to it, except the inputs. Functions are
 * shared, because ParaView's piecewise functions also exist in the client.
 */
class HapticTouchLink
{
public:
  HapticTouchLink() = default;
  ~HapticTouchLink();
  HapticTouchLink(const HapticTouchLink&) = delete;
  void operator=(const HapticTouchLink&) = delete;

  /** Watch the settings of a proxy for changes; nullptr ends the watch. */
  void Watch(vtkSMProxy* touch);

  /**
   * Returns the filter in the client; null without a proxy, or if its object is not a
   * vtkVolumeHapticsFilter.
   */
  vtkVolumeHapticsFilter* GetFilter() const;
  vtkSMProxy* GetTouch() const;

  /**
   * Returns the source to which an input of the followed proxy is connected, and writes its port;
   * null if there is none.
   */
  vtkSMSourceProxy* GetInput(const char* name, unsigned int& port) const;

private:
  void RecordChange() { this->IsDirty = true; }
  /**
   * Passes a command about removed tissue to the client's filter, unless the followed filter is in
   * this process.
   */
  void PassCommand(vtkObject* touch, unsigned long event, void* name);
  void ShareRemoval();
  /** Returns the followed filter if it is in this process; otherwise null. */
  vtkVolumeHapticsFilter* GetTouched() const;
  void LetGo();
  void CopySettings();

  vtkWeakPointer<vtkSMProxy> Touch;
  vtkSmartPointer<vtkSMProxy> Twin;
  unsigned long Observer = 0;
  unsigned long CommandObserver = 0;
  bool IsDirty = false;
};

class HapticDataLink
{
public:
  /** @param lost called when the server does not answer */
  explicit HapticDataLink(std::function<void()> lost);

  /**
   * Applies changes of the pipeline, its time, and the device's properties Touch, FollowOpacity and
   * MaximumRegionVoxels. Reports problems to `report`.
   */
  void Update(vtkSMProxy* proxy, vtkHapticDevice* device, HapticReport& report);

  /** Returns the filter in the client; null while there is nothing to touch. */
  vtkVolumeHapticsFilter* GetFilter() const { return this->Touch.GetFilter(); }

  /** Returns whether a proxy is touched, or is the view that shows the touched data. */
  bool Uses(vtkSMProxy* proxy) const;

  /** See vtkSMHapticDeviceProxy::SetVisibility. */
  void SetVisibility(vtkVolumeProperty* property) { this->Visibility = property; }

  /** Returns the time (s) for fetching a region; 0 before the first region. */
  double GetLatency() const { return this->Region.GetLatency(); }

  /** Discards the last fetched region. */
  void ClearRegion() { this->Region.Clear(); }

  /** Returns whether the data of a proxy are in this process. */
  static bool IsLocal(vtkSMProxy* proxy);

private:
  void UpdateTime(vtkSMProxy* proxy, vtkSMSourceProxy* volume);
  void UpdateImage(
    vtkSMSourceProxy* volume, unsigned int port, vtkHapticDevice* device, HapticReport& report);
  void PollRegion(vtkSMProxy* proxy, vtkSMSourceProxy* volume, unsigned int port,
    vtkHapticDevice* device, HapticReport& report);

  const std::function<void()> Lost;
  HapticTouchLink Touch;
  HapticImageLink Image;
  HapticLargeLink Large;        // for a volume larger than memory
  HapticTimeStepLink TimeSteps; // for a volume with times
  HapticImageLink Surface;
  HapticImageLink Labels;
  HapticRegionLink Region; // for data on a server
  HapticOpacityLink Opacity;
  HapticCropLink Crop;
  vtkSmartPointer<vtkVolumeProperty> Visibility; // if set, replaces the opacity found by Opacity
  double ViewTime = 0.0;                         // time of the data (s)
};

} // namespace VolumeHapticsLive

#endif
