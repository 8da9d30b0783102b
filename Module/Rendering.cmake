# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The parts of the module that draw or follow a mouse. Without them the filter, the property, the setup, the path
# source, regions, the device and the Python package remain, and the library links neither OpenGL nor charts nor
# interaction. VTK::RenderingCore stays: it has vtkVolumeProperty and vtkCamera, and needs no graphics library.
option(VolumeHaptics_USE_RENDERING "Build what draws the scene and what follows the mouse" ON)

set(VolumeHaptics_RENDERING_ROOMS # in Module/VTK
  Experimental
  Scene)
set(VolumeHaptics_RENDERING_MODULES # of VTK
  ChartsCore
  CommonComputationalGeometry
  InteractionStyle
  RenderingAnnotation
  RenderingContext2D
  RenderingOpenGL2
  RenderingOpenXR
  RenderingVolume
  RenderingVolumeOpenGL2
  glad
  glew)

# The file that vtk_module_scan() reads. A vtk.module has no conditions; without rendering, a copy without the above
# is made in the build tree.
function (volume_haptics_module_file variable)
  set(file "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../vtk.module")
  get_filename_component(file "${file}" ABSOLUTE)
  if (NOT VolumeHaptics_USE_RENDERING)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" text)
    foreach (module IN LISTS VolumeHaptics_RENDERING_MODULES)
      string(REGEX REPLACE "\n +VTK::${module}(\n)" "\\1" text "${text}")
    endforeach ()
    set(file "${CMAKE_BINARY_DIR}/Headless/vtk.module")
    file(WRITE "${file}" "${text}")
  endif ()
  set(${variable} "${file}" PARENT_SCOPE)
endfunction ()
