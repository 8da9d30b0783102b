// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes a headset's controllers vibrate by VTK's module RenderingOpenXR. Without this module,
 * nothing vibrates.
 */
#ifndef XRVibration_h
#define XRVibration_h

#include <string>

class vtkRenderWindowInteractor;

namespace VolumeHaptics
{

struct XRVibration
{
  std::string Action;     ///< an action of the manifest, of the type "vibration"
  int Hand = 0;           ///< 0: left, 1: right
  double Amplitude = 0.0; ///< 0 to 1
  double Duration = 0.0;  ///< s; the next vibration may end this one earlier
};

/** Whether the interactor can make controllers vibrate. */
bool CanVibrate(vtkRenderWindowInteractor* interactor);

/**
 * Sends a vibration. Returns false if the interactor can't make controllers vibrate, or if the
 * runtime refuses; VTK reports the latter as an error.
 */
bool ApplyVibration(vtkRenderWindowInteractor* interactor, const XRVibration& vibration);

} // namespace VolumeHaptics

#endif
