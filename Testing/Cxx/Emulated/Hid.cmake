# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# HID devices: the carrier, and what each of them is like.
add_library(EmulatedHidDevices OBJECT EmulatedHid.cxx StickModel.cxx WoodenModel.cxx)
target_link_libraries(EmulatedHidDevices PUBLIC PkgConfig::UMOCKDEV)
foreach (test IN ITEMS
    HidClaim
    HidTogether
    Pid
    PidFault
    SpaceMouse
    SpaceMouseFault
    Wooden
    WoodenFault)
  volume_haptics_add_emulated_test(${test}
    LIBRARIES EmulatedHidDevices VolumeHapticsDevices VolumeHapticsCore)
endforeach ()
