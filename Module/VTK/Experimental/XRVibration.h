// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The vibration of a headset's controllers, by VTK's module RenderingOpenXR. Built without it,
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
  std::string Action;     ///< of the manifest, of the type "vibration"
  int Hand = 0;           ///< 0: left, 1: right
  double Amplitude = 0.0; ///< 0 to 1
  double Duration = 0.0;  ///< s; the next one ends it, too
};

/** Whether the interactor can make controllers vibrate. */
bool CanVibrate(vtkRenderWindowInteractor* interactor);

/** False if it can't, or if the runtime refuses; VTK has told the error then. */
bool ApplyVibration(vtkRenderWindowInteractor* interactor, const XRVibration& vibration);

} // namespace VolumeHaptics

#endif
