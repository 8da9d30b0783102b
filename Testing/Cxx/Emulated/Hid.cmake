# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# HID devices: the carrier, and what each of them is like.
set(hid_libraries VolumeHapticsDevices VolumeHapticsCore)
set(hid_carrier EmulatedHid.cxx)
foreach (test IN ITEMS Wooden)
  volume_haptics_add_emulated_test(${test}
    SOURCES ${hid_carrier} WoodenModel.cxx
    LIBRARIES ${hid_libraries})
endforeach ()
foreach (test IN ITEMS Pid)
  volume_haptics_add_emulated_test(${test}
    SOURCES ${hid_carrier} StickModel.cxx
    LIBRARIES ${hid_libraries})
endforeach ()
volume_haptics_add_emulated_test(SpaceMouse
  SOURCES ${hid_carrier}
  LIBRARIES ${hid_libraries})
