# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# HID devices: the carrier, and what each of them is like.
set(hid_libraries VolumeHapticsDevices VolumeHapticsCore)
volume_haptics_add_emulated_test(Wooden
  SOURCES EmulatedHid.cxx WoodenModel.cxx
  LIBRARIES ${hid_libraries})
