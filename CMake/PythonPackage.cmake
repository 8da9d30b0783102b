# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The Python package volumehaptics, usable from the build tree and from the install tree.
if (NOT DEFINED VolumeHaptics_PYTHON_SITE)
  vtk_module_python_default_destination(VolumeHaptics_PYTHON_SITE MAJOR_VERSION 3)
endif ()
set(python_options)
if (SKBUILD)
  set(python_options SOABI "${Python3_SOABI}") # the name says which Python it is for
endif ()
vtk_module_wrap_python(
  MODULES             ${modules}
  TARGET              VolumeHaptics::PythonWrapped
  INSTALL_EXPORT      VolumeHapticsPython
  PYTHON_PACKAGE      "volumehaptics"
  MODULE_DESTINATION  "${VolumeHaptics_PYTHON_SITE}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION   "${VolumeHaptics_CMAKE_DESTINATION}"
  BUILD_STATIC        OFF
  INSTALL_HEADERS     ON
  ${python_options})
configure_file(
  "${CMAKE_CURRENT_LIST_DIR}/__init__.py.in"
  "${CMAKE_BINARY_DIR}/${VolumeHaptics_PYTHON_SITE}/volumehaptics/__init__.py" @ONLY)
install(
  FILES       "${CMAKE_BINARY_DIR}/${VolumeHaptics_PYTHON_SITE}/volumehaptics/__init__.py"
  DESTINATION "${VolumeHaptics_PYTHON_SITE}/volumehaptics"
  COMPONENT   python)
