// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The times of ParaView's animation as frames of a volume that moves, for a filter in the client.
 */
#ifndef HapticFrameLink_h
#define HapticFrameLink_h

#include "vtkHapticFrameSource.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkHapticDevice;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

/**
 * ParaView has the data of one time: that of its animation, which a view shows. When that time
 * changes, the servo goes from the last image to the new one, in the time that the animation took
 * for its last step: a step behind what is seen, but without a jump, whatever the VCR buttons do,
 * forward or backward. Nothing is read twice. If the animation is faster than that, images are left
 * out; if it stands still, so does the volume.
 */
class HapticFrameLink
{
public:
  /** Whether the data of a port have times, and the filter feels the motion between them. */
  static bool IsMoving(vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter);

  /** An image at a time, with which another volume begins. */
  void Begin(
    vtkImageData* image, double time, vtkVolumeHapticsFilter* filter, vtkHapticDevice* device);
  /** From one image to another one at another time. */
  void Go(vtkImageData* from, vtkImageData* to, double time, vtkHapticDevice* device);
  /** Other regions of the images between which it goes. */
  void Replace(vtkImageData* from, vtkImageData* to);
  /** The next image is the first one. */
  void Clear();

  /** Whether it has begun, for this filter. */
  bool HasBegun(vtkVolumeHapticsFilter* filter) const
  {
    return this->Source && this->Filter == filter;
  }
  /** Whether the last image is the first one. */
  bool IsFirst() const { return this->IsBeginning; }
  /** Whether the servo is at the last image, so that it can go on from there. */
  bool IsThere(vtkHapticDevice* device);
  /** The last image, and its time; and the time before. */
  vtkImageData* GetImage() const { return this->To; }
  double GetTime() const { return this->ToTime; }
  double GetTimeBefore() const { return this->FromTime; }

private:
  void Send();
  void SetDuration(double seconds, vtkHapticDevice* device);

  vtkSmartPointer<vtkHapticFrameSource> Source;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkImageData> From;
  vtkSmartPointer<vtkImageData> To;
  double FromTime = 0.0; // of the data
  double ToTime = 0.0;
  double SentAt = 0.0;   // s, of this computer
  double SeenTime = 0.0; // of the data, in the servo's latest states
  double SeenAt = 0.0;   // s, of the servo, since when; 0: not seen since the last step
  bool IsBeginning = false;
};

} // namespace VolumeHapticsLive

#endif
