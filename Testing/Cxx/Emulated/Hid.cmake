# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# HID devices: the carrier, and what each of them is like.
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
    SOURCES EmulatedHid.cxx StickModel.cxx WoodenModel.cxx
    LIBRARIES VolumeHapticsDevices VolumeHapticsCore)
endforeach ()
