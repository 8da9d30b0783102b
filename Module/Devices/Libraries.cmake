# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The libraries through which devices are reached: VolumeHaptics_DEVICE_LIBRARIES. Each is used if it is found.
find_package(Threads REQUIRED)
find_package(PkgConfig QUIET)
if (PKG_CONFIG_FOUND)
  pkg_check_modules(LIBUSB QUIET libusb-1.0)
  # The kernel's own interface rather than a second USB stack: the kernel's driver stays bound.
  pkg_check_modules(HIDAPI QUIET hidapi-hidraw)
  if (NOT HIDAPI_FOUND)
    pkg_check_modules(HIDAPI QUIET hidapi)
  endif ()
endif ()

# Headers only. Boost.Beast has had what is used of it since 1.70.
find_path(BEAST_INCLUDE_DIR boost/beast/core/tcp_stream.hpp)
find_path(NLOHMANN_INCLUDE_DIR nlohmann/json.hpp)
mark_as_advanced(BEAST_INCLUDE_DIR NLOHMANN_INCLUDE_DIR)
set(BEAST_FOUND OFF)
if (BEAST_INCLUDE_DIR AND NLOHMANN_INCLUDE_DIR)
  set(BEAST_FOUND ON)
endif ()

set(VolumeHaptics_DEVICE_LIBRARIES)
# Makes the option VolumeHaptics_USE_NAME, on if the library is found; an error if it is asked for and not found.
macro (volume_haptics_use name found devices package)
  if (${found})
    option(VolumeHaptics_USE_${name} "Talk to ${devices}" ON)
  else ()
    option(VolumeHaptics_USE_${name} "Talk to ${devices}" OFF)
  endif ()
  if (VolumeHaptics_USE_${name})
    if (NOT ${found})
      message(FATAL_ERROR "VolumeHaptics_USE_${name} is on, but the library is not found. "
        "Install it (on Debian: apt-get install ${package}), or turn the option off.")
    endif ()
    list(APPEND VolumeHaptics_DEVICE_LIBRARIES ${${name}_LINK_LIBRARIES})
  else ()
    message(STATUS "Without ${devices}: VolumeHaptics_USE_${name} is off (on Debian: apt-get install ${package})")
  endif ()
endmacro ()
volume_haptics_use(LIBUSB LIBUSB_FOUND "the Novint Falcon, through libusb" "pkg-config libusb-1.0-0-dev")
volume_haptics_use(HIDAPI HIDAPI_FOUND
  "WoodenHaptics, force-feedback sticks and 3Dconnexion mice, through hidapi" "pkg-config libhidapi-dev")
volume_haptics_use(BEAST BEAST_FOUND "Haply's Inverse3 and Minverse, through Boost.Beast"
  "libboost-dev nlohmann-json3-dev")
