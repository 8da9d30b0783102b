// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts the times of ParaView's animation to time steps of a moving volume, for a filter in the
 * client.
 */
#ifndef HapticTimeStepLink_h
#define HapticTimeStepLink_h

#include "vtkHapticTimeStepSource.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkHapticDevice;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

/**
 * Moves the servo between the times of ParaView's animation. ParaView has the data of only one
 * time, which is the animation's time and is shown in a view. When that time changes, the servo
 * moves from the last image to the new one within the duration of the animation's last step. The
 * hand thus lags one step behind the view, but the volume does not jump, whether the VCR buttons go
 * forward or backward. No data are read twice. If the animation is faster than the servo, images
 * are skipped. If it stops, the volume stops, too.
 */
class HapticTimeStepLink
{
public:
  /**
   * Returns whether the data of a port have times, and the filter renders the motion between them.
   */
  static bool IsMoving(vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter);

  /** Begins a new volume, with the image at `time` as its first time step. */
  void Begin(
    vtkImageData* image, double time, vtkVolumeHapticsFilter* filter, vtkHapticDevice* device);
  /** Moves the servo from one image to another image with another time. */
  void Go(vtkImageData* from, vtkImageData* to, double time, vtkHapticDevice* device);
  /** Replaces both images between which the servo moves by other regions. */
  void Replace(vtkImageData* from, vtkImageData* to);
  /** Discards the volume, so that the next image begins a new one. */
  void Clear();

  /** Returns whether Begin() was called for this filter, without a later Clear(). */
  bool HasBegun(vtkVolumeHapticsFilter* filter) const
  {
    return this->Source && this->Filter == filter;
  }
  /** Returns whether the last image is the first one of the volume. */
  bool IsFirst() const { return this->IsBeginning; }
  /**
   * Returns whether the next image may be sent: because the servo has reached the last image, the
   * device does not run, or the data time has not changed for longer than Patience.
   */
  bool IsThere(vtkHapticDevice* device);
  /** Return the last image, its time, or the previous image's time. */
  vtkImageData* GetImage() const { return this->To; }
  double GetTime() const { return this->ToTime; }
  double GetTimeBefore() const { return this->FromTime; }

private:
  void Send();
  void SetDuration(double seconds, vtkHapticDevice* device);

  vtkSmartPointer<vtkHapticTimeStepSource> Source;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkImageData> From;
  vtkSmartPointer<vtkImageData> To;
  double FromTime = 0.0; // time of the data
  double ToTime = 0.0;
  double SentAt = 0.0;   // time at which the last step was sent (s), on this computer's clock
  double SeenTime = 0.0; // data time in the servo's latest states
  // servo time (s) since which SeenTime has not changed; 0 if unknown since the last step
  double SeenAt = 0.0;
  bool IsBeginning = false;
};

} // namespace VolumeHapticsLive

#endif
