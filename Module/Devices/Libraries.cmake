# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Sets VolumeHaptics_DEVICE_LIBRARIES to the libraries that communicate with devices. Each is used if it is found.
find_package(Threads REQUIRED)
find_package(PkgConfig QUIET)
if (PKG_CONFIG_FOUND)
  pkg_check_modules(LIBUSB QUIET libusb-1.0)
  # Prefer the kernel's hidraw interface to hidapi's own USB stack, so that the kernel's driver stays bound.
  pkg_check_modules(HIDAPI QUIET hidapi-hidraw)
  if (NOT HIDAPI_FOUND)
    pkg_check_modules(HIDAPI QUIET hidapi)
  endif ()
endif ()

# These libraries consist of headers only. Boost.Beast 1.70 is the first version with everything that is used here.
find_path(BEAST_INCLUDE_DIR boost/beast/core/tcp_stream.hpp)
find_path(NLOHMANN_INCLUDE_DIR nlohmann/json.hpp)
mark_as_advanced(BEAST_INCLUDE_DIR NLOHMANN_INCLUDE_DIR)
set(BEAST_FOUND OFF)
if (BEAST_INCLUDE_DIR AND NLOHMANN_INCLUDE_DIR)
  set(BEAST_FOUND ON)
endif ()

include("${CMAKE_CURRENT_LIST_DIR}/../UseLibrary.cmake")
set(VolumeHaptics_DEVICE_LIBRARIES)
volume_haptics_use(VolumeHaptics_DEVICE_LIBRARIES LIBUSB LIBUSB_FOUND
  "Talk to the Novint Falcon, through libusb" "pkg-config libusb-1.0-0-dev")
volume_haptics_use(VolumeHaptics_DEVICE_LIBRARIES HIDAPI HIDAPI_FOUND
  "Talk to WoodenHaptics, force-feedback sticks, 3Dconnexion mice and DualSense pads, through hidapi"
  "pkg-config libhidapi-dev")
volume_haptics_use(VolumeHaptics_DEVICE_LIBRARIES BEAST BEAST_FOUND
  "Talk to Haply's arms, bHaptics, WEART and Hapbeat, through Boost.Beast" "libboost-dev nlohmann-json3-dev")
