# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Lists the tests of back ends with emulated devices by the library that they need. Both programs with these tests
# include this file: ../CMakeLists.txt for umockdev, ../../VirtualMachine/CMakeLists.txt for a virtual machine with its
# own kernel.
set(libusb_tests FalconBytes FalconDirection FalconFault FalconFirmware FalconHomingAgain FalconListing FalconPanel
  FalconSession FalconSleep FalconUnplug FalconZero)
set(hidapi_tests HidClaim HidTogether Pid PidFault PidFirmware SpaceMouse SpaceMouseFault Wooden WoodenFault)
# Tests for umockdev only. In the virtual machine, permissions have another test, timing differs, and the device does
# not learn that a program has closed it.
set(umockdev_libusb_tests FalconGuard FalconGuardEnds FalconLate FalconPermission FalconTries)
set(umockdev_evdev_tests Pad PadFault Wheel)
set(umockdev_hidapi_tests DualSense PidStuck PidTime)
