// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the slices of ParaView's Orthographic Slice Views follow the tip of a device.
 */
#ifndef HapticSlices_h
#define HapticSlices_h

class vtkSMSession;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Sets the property SlicePosition of all such views of a session when the tip has moved, and draws
 * the views: in a fifth of the time at most, so that they never delay the view with the hand. While
 * the tip rests, the user may move the slices.
 */
class HapticSlices
{
public:
  /** Call it often. Positions outside the filter's image become the nearest ones in it. */
  void Follow(vtkSMSession* session, vtkVolumeHapticsFilter* filter, const double tip[3]);

private:
  double Last[3] = { 0.0, 0.0, 0.0 }; ///< the tip that the slices have followed
  bool IsKnown = false;
  double NextTime = 0.0; ///< s
};

} // namespace VolumeHaptics

#endif
