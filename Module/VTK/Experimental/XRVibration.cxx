// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Experimental/XRVibration.h"

#if defined(VOLUME_HAPTICS_HAS_OPENXR)
#include "vtkOpenXRRenderWindowInteractor.h"
#endif

namespace VolumeHaptics
{

#if defined(VOLUME_HAPTICS_HAS_OPENXR)

bool CanVibrate(vtkRenderWindowInteractor* interactor)
{
  return vtkOpenXRRenderWindowInteractor::SafeDownCast(interactor) != nullptr;
}

bool ApplyVibration(vtkRenderWindowInteractor* interactor, const XRVibration& vibration)
{
  auto* const headset = vtkOpenXRRenderWindowInteractor::SafeDownCast(interactor);
  constexpr double nanoseconds = 1e9;
  constexpr float anyFrequency = 0.0F; // XR_FREQUENCY_UNSPECIFIED: the runtime chooses
  return headset &&
    headset->ApplyVibration(vibration.Action, vibration.Hand,
      static_cast<float>(vibration.Amplitude), static_cast<float>(nanoseconds * vibration.Duration),
      anyFrequency);
}

#else

bool CanVibrate(vtkRenderWindowInteractor*)
{
  return false;
}

bool ApplyVibration(vtkRenderWindowInteractor*, const XRVibration&)
{
  return false;
}

#endif

} // namespace VolumeHaptics
