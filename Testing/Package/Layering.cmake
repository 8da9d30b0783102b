# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Core <- Devices <- VTK <- everything else. Each rule: a folder, and what its files must not include.
cmake_minimum_required(VERSION 3.18)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

# Fails for every #include in the files that match the pattern.
function(forbid reason pattern)
  foreach (glob IN LISTS ARGN)
    file(GLOB files "${root}/${glob}")
    foreach (file IN LISTS files)
      file(STRINGS "${file}" includes REGEX "^[ \t]*#[ \t]*include")
      foreach (line IN LISTS includes)
        if (line MATCHES "${pattern}")
          file(RELATIVE_PATH name "${root}" "${file}")
          message(SEND_ERROR "${name}: ${line}\n  ${reason}")
        endif ()
      endforeach ()
    endforeach ()
  endforeach ()
endfunction()

# Headers of a folder, as a pattern of what an #include of one of them looks like.
function(headers_of folder variable)
  file(GLOB headers RELATIVE "${root}/${folder}" "${root}/${folder}/*.h")
  list(TRANSFORM headers REPLACE "\\." "\\\\.")
  list(JOIN headers "|" alternatives)
  set(${variable} "[\"</](${alternatives})[\">]" PARENT_SCOPE)
endfunction()

headers_of(Module/VTK vtk)
set(any_vtk "[\"</]vtk[A-Za-z0-9_]*\\.h")
set(core "Module/Core/*.h" "Module/Core/*.cxx")
set(device_files "Module/Devices/*.h" "Module/Devices/*.cxx" "Module/Devices/*/*.h" "Module/Devices/*/*.cxx")
set(filter "Module/VTK/vtkVolumeHapticsFilter.*" "Module/VTK/vtkVolumeHapticsAlgorithm.*"
  "Module/VTK/HapticModelBuilder.*" "Module/VTK/HapticTrace.*" "Module/VTK/HapticTipPath.*"
  "Module/VTK/HapticVolumeView.*" "Module/VTK/HapticFunctions.*")
set(module ${core} ${device_files} "Module/VTK/*.h" "Module/VTK/*.cxx")

forbid("Core must not know VTK." "${any_vtk}" ${core})
forbid("Core must not know the module's VTK side." "${vtk}" ${core})
forbid("Devices must not know VTK." "${any_vtk}" ${device_files})
forbid("Devices must not know the module's VTK side." "${vtk}" ${device_files})
forbid("Devices must not know solver parameters." "(HapticModel|ServoTick|PiecewiseTable)\\.h"
  ${device_files})
forbid("The filter must not know rendering or interaction."
  "vtk(Render|Interactor|Prop|Actor|Volume\\.|VolumeMapper|Camera|Haptic(Device|Representation|State))"
  ${filter})
forbid("The module must not know ParaView or Qt." "[\"<](vtkPV|vtkSM|vtkSI|pq|Q[A-Z])" ${module})
forbid("Installed headers must not show a device library." "(hidapi|libusb)" "Module/VTK/*.h" "Module/Core/*.h" "Module/Devices/*.h")
if (IS_DIRECTORY "${root}/Module/Devices")
  headers_of(Module/Devices devices)
  if (NOT devices STREQUAL "[\"</]()[\">]")
    forbid("Core must not know Devices." "${devices}" ${core})
    forbid("The filter must not know devices." "${devices}" ${filter})
  endif ()
endif ()

# A rule that matches nothing protects nothing: try the machinery on a file that breaks it.
file(STRINGS "${root}/Module/VTK/vtkVolumeHapticsFilter.h" probe REGEX "^#include")
if (NOT probe MATCHES "${any_vtk}")
  message(SEND_ERROR "The layering patterns no longer match a VTK include: ${probe}")
endif ()
