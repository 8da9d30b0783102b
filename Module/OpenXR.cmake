# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Adds headsets whose controllers vibrate, by a module that VTK has had since 9.2. Neither Debian's VTK nor the wheels
# on PyPI have it.
set(found OFF)
if (VolumeHaptics_USE_RENDERING AND TARGET VTK::RenderingOpenXR)
  set(found ON)
endif ()
option(VolumeHaptics_USE_OPENXR "Make controllers of headsets vibrate, through VTK's module RenderingOpenXR" ${found})
if (VolumeHaptics_USE_OPENXR AND NOT found)
  message(FATAL_ERROR "VolumeHaptics_USE_OPENXR is on, but VTK has no module RenderingOpenXR, or the option "
    "VolumeHaptics_USE_RENDERING is off. Build VTK 9.2 or later with -DVTK_MODULE_ENABLE_VTK_RenderingOpenXR=YES, or "
    "turn the option off.")
endif ()
