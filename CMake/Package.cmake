# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Makes find_package(VolumeHaptics) work from the build tree and from the install tree.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_BINARY_DIR}/${VolumeHaptics_CMAKE_DESTINATION}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/VolumeHapticsConfig.cmake.in"
  "${package_dir}/VolumeHapticsConfig.cmake"
  INSTALL_DESTINATION "${VolumeHaptics_CMAKE_DESTINATION}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/VolumeHapticsVtk.cmake" DESTINATION "${package_dir}")
write_basic_package_version_file(
  "${package_dir}/VolumeHapticsConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(
  FILES       "${package_dir}/VolumeHapticsConfig.cmake"
              "${package_dir}/VolumeHapticsConfigVersion.cmake"
              "${package_dir}/VolumeHapticsVtk.cmake"
  DESTINATION "${VolumeHaptics_CMAKE_DESTINATION}"
  COMPONENT   development)

# The folder in which udev looks for rules. It is set separately because the folder of the libraries may be named after
# the architecture.
if (NOT DEFINED VolumeHaptics_UDEV_DESTINATION)
  set(VolumeHaptics_UDEV_DESTINATION lib/udev/rules.d)
endif ()
install(
  FILES       "${CMAKE_CURRENT_LIST_DIR}/../Data/udev/70-volume-haptics.rules"
  DESTINATION "${VolumeHaptics_UDEV_DESTINATION}"
  COMPONENT   runtime)
