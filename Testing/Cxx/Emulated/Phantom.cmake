# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Applications with emulated devices, on the head phantom; and the console tool.
foreach (test IN ITEMS PhantomFalcon PhantomSignal PhantomStick PhantomTwoHands PhantomWooden)
  volume_haptics_add_emulated_test(${test}
    LIBRARIES EmulatedFalcon EmulatedHidDevices VolumeHapticsApiRig VTK::IOXML)
  target_compile_definitions(Emulated${test}Test PRIVATE
    HEAD_PHANTOM="${PROJECT_SOURCE_DIR}/Data/HeadPhantom.vti")
endforeach ()

if (VolumeHaptics_BUILD_TOOLS)
  foreach (test IN ITEMS DeviceTool StickTool WoodenTool)
    volume_haptics_add_emulated_test(${test}
      LIBRARIES EmulatedFalcon EmulatedHidDevices VolumeHapticsDeviceTool)
  endforeach ()
endif ()
