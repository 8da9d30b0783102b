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
  volume_haptics_add_emulated_test(DeviceTool
    LIBRARIES EmulatedFalcon VolumeHapticsDeviceTool)
  volume_haptics_add_emulated_test(WoodenTool
    SOURCES EmulatedHid.cxx WoodenModel.cxx
    LIBRARIES VolumeHapticsDeviceTool)
  volume_haptics_add_emulated_test(StickTool
    SOURCES EmulatedHid.cxx StickModel.cxx
    LIBRARIES VolumeHapticsDeviceTool)
endif ()
