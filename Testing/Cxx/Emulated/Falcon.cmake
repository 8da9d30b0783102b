# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The Novint Falcon through libusb.
add_library(EmulatedFalcon STATIC
  EmulatedIoctls.cxx
  EmulatedPlug.cxx
  FalconMechanics.cxx
  FalconModel.cxx
  FalconModelState.cxx)
target_link_libraries(EmulatedFalcon PUBLIC PkgConfig::UMOCKDEV Threads::Threads)

foreach (test IN ITEMS
    FalconBytes
    FalconDirection
    FalconFault
    FalconFirmware
    FalconHomingAgain
    FalconListing
    FalconMechanics
    FalconPanel
    FalconPermission
    FalconSession
    FalconSleep
    FalconUnplug
    FalconZero)
  volume_haptics_add_emulated_test(${test}
    LIBRARIES EmulatedFalcon VolumeHapticsDevices VolumeHapticsCore ${CMAKE_DL_LIBS})
endforeach ()

# It runs a driver under a clock of its own.
target_include_directories(EmulatedFalconSleepTest SYSTEM PRIVATE ${LIBUSB_INCLUDE_DIRS})
