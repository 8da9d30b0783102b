// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMHapticDeviceProxyInternals_h
#define vtkSMHapticDeviceProxyInternals_h

#include "HapticErrorCatcher.h"
#include "HapticImageLink.h"
#include "HapticOpacityLink.h"
#include "HapticRegionLink.h"
#include "HapticSessionWatch.h"
#include "HapticStateLog.h"
#include "HapticTouchLink.h"
#include "vtkSMHapticDeviceProxy.h"

#include "vtkHapticDevice.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <string>

struct vtkSMHapticDeviceProxy::vtkInternals
{
  explicit vtkInternals(VolumeHapticsLive::HapticSessionWatch::Calls calls)
    : Watch(std::move(calls))
  {
  }

  vtkNew<vtkHapticDevice> Device;
  VolumeHapticsLive::HapticErrorCatcher Errors;
  VolumeHapticsLive::HapticTouchLink Touch;
  VolumeHapticsLive::HapticImageLink Image;
  VolumeHapticsLive::HapticImageLink Surface;
  VolumeHapticsLive::HapticRegionLink Region; // where the data are on a server
  VolumeHapticsLive::HapticOpacityLink Opacity;
  VolumeHapticsLive::HapticSessionWatch Watch;
  VolumeHapticsLive::HapticStateLog Log;         // instead of a recording, for a region
  vtkSmartPointer<vtkVolumeProperty> Visibility; // of SetVisibility

  bool IsBusy = false;
  bool IsClosed = false; // the session is over
  bool IsLost = false;   // so is the server
  bool IsArmed = false;  // as ordered last
  bool IsRecording = false;
  double ArmedAt = 0.0;      // s, of the device
  double MaximumForce = 0.0; // N, taken over; 0: the device's own choice
  std::array<double, 3> Tip = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX }; // taken over
  double ViewTime = 0.0;                                                          // s, of the data
  std::string Notice;   // why it was stopped; until it is started again
  std::string Problem;  // of now; empty where all is well
  std::string Reported; // said as an error
};

#endif
