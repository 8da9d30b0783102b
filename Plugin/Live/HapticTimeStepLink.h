// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Turns the times of ParaView's animation into time steps of a moving volume, for a filter in the
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
 * Moves the servo between the times of ParaView's animation. ParaView has the data of one time
 * only, the animation's time, which a view shows. When that time changes, the servo moves from the
 * last image to the new one, in the duration of the animation's last step. So the hand feels the
 * previous step of the view, but the volume does not jump, whether the VCR buttons go forward or
 * backward. No data are read twice. If the animation is faster than the servo, images are left out.
 * If it stands still, so does the volume.
 */
class HapticTimeStepLink
{
public:
  /**
   * Returns whether the data of a port have times, and the filter feels the motion between them.
   */
  static bool IsMoving(vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter);

  /** Begins a new volume with an image at a time. */
  void Begin(
    vtkImageData* image, double time, vtkVolumeHapticsFilter* filter, vtkHapticDevice* device);
  /** Moves the servo from one image to another image, which has another time. */
  void Go(vtkImageData* from, vtkImageData* to, double time, vtkHapticDevice* device);
  /** Replaces the two images between which the servo moves by other regions. */
  void Replace(vtkImageData* from, vtkImageData* to);
  /** Forgets the volume, so that the next image begins a new one. */
  void Clear();

  /** Returns whether Begin() was called for this filter, and Clear() was not called since. */
  bool HasBegun(vtkVolumeHapticsFilter* filter) const
  {
    return this->Source && this->Filter == filter;
  }
  /** Returns whether the last image is the first one of the volume. */
  bool IsFirst() const { return this->IsBeginning; }
  /**
   * Returns whether the next image may be sent: because the servo has reached the last image,
   * because the device does not run, or because the data time has stood still for longer than
   * Patience.
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
  double SentAt = 0.0;   // time when the last step was sent (s), by this computer's clock
  double SeenTime = 0.0; // data time in the servo's latest states
  // servo time since which SeenTime has not changed (s); 0 if not known since the last step
  double SeenAt = 0.0;
  bool IsBeginning = false;
};

} // namespace VolumeHapticsLive

#endif
