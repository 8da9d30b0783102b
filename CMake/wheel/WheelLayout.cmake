# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The layout of a wheel: all files are in the folder volumehaptics, beside the folder vtkmodules of VTK's wheel.
set(BUILD_TESTING OFF) # tests run on the installed wheel
set(VolumeHaptics_BUILD_EXPLORER ON CACHE BOOL "Build and install the explorer, volumehaptics-explore")
# With PulseAudio, the wheel would have to contain its library and all of that library's dependencies, in a version that
# suits the user's server.
set(VolumeHaptics_USE_PULSE OFF CACHE BOOL "Let the explorer be heard through PulseAudio or PipeWire")
set(VolumeHaptics_PYTHON_SITE ".")
set(VolumeHaptics_PROGRAM_RPATH "$ORIGIN/..:$ORIGIN/../../vtkmodules")
set(CMAKE_INSTALL_BINDIR volumehaptics/bin)
set(CMAKE_INSTALL_LIBDIR volumehaptics)
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../vtkmodules")
# Otherwise the linker computes the build's identifier from the build's folders, and leaves room for their names.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
set(VolumeHaptics_UDEV_DESTINATION volumehaptics/udev)

# Licence notices, from the Debian packages, of the libraries that are header-only or that CMake/wheel/build.sh copies
# into the wheel.
foreach (package IN ITEMS libblosc1 libboost-dev libcharls2 libexpat1 libgdcm3.0 libgdcm3.0t64 libhidapi-hidraw0
    libjson-c5 liblz4-1 libopenjp2-7 libsnappy1v5 libssl3 libssl3t64 libudev1 libusb-1.0-0 libuuid1 libzstd1
    nlohmann-json3-dev)
  if (EXISTS "/usr/share/doc/${package}/copyright")
    install(
      FILES       "/usr/share/doc/${package}/copyright"
      DESTINATION volumehaptics/licenses
      RENAME      "${package}.txt"
      COMPONENT   runtime)
  endif ()
endforeach ()
