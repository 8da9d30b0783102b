# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Which room may include which: one line a folder. A room may always include itself; nothing else that is not named.
cmake_minimum_required(VERSION 3.18)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

# The private headers that a file of the module includes are written from Module: "Core/Math/Vector3.h". Fails for
# those that are in none of the rooms that follow, and are none of the files that follow.
function(allow room)
  file(GLOB_RECURSE files RELATIVE "${root}/Module" "${root}/Module/${room}/*.h" "${root}/Module/${room}/*.cxx")
  if (NOT files)
    message(SEND_ERROR "No files in ${room}: the rule protects nothing.")
  endif ()
  foreach (file IN LISTS files)
    file(STRINGS "${root}/Module/${file}" includes REGEX "^[ \t]*#[ \t]*include \"(Core|Devices|VTK|Applications)/")
    foreach (line IN LISTS includes)
      string(REGEX REPLACE ".*\"(.*)\".*" "\\1" header "${line}")
      set(allowed FALSE)
      foreach (other IN LISTS room ARGN)
        if (header MATCHES "^${other}(/|$)")
          set(allowed TRUE)
        endif ()
      endforeach ()
      if (NOT allowed)
        message(SEND_ERROR "${file} includes ${header}. ${room} may include: ${ARGN}")
      endif ()
    endforeach ()
  endforeach ()
endfunction()

# Fails for every #include of the files in the folders that follow that matches the pattern.
function(forbid reason pattern)
  foreach (folder IN LISTS ARGN)
    file(GLOB_RECURSE files "${root}/Module/${folder}/*.h" "${root}/Module/${folder}/*.cxx")
    if (IS_DIRECTORY "${root}/Module/${folder}" AND NOT files)
      message(SEND_ERROR "No files in ${folder}: the rule protects nothing.")
    elseif (NOT files)
      file(GLOB files "${root}/Module/${folder}")
    endif ()
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

set(solver_basis Core/Math Core/Carving Core/Field Core/Model)
allow(Core/Math)
allow(Core/Carving)
allow(Core/Field Core/Math Core/Carving)
allow(Core/Model Core/Math Core/Carving Core/Field)
allow(Core/Proposal Core/Math Core/Field)
allow(Core/Solvers ${solver_basis})
allow(Core/Tools/PointShell ${solver_basis} Core/Solvers)
allow(Core/Regions ${solver_basis} Core/Solvers)
allow(Core/Tools/Burr ${solver_basis} Core/Solvers Core/Tools/PointShell)
allow(Core/Tools ${solver_basis} Core/Solvers)
allow(Core/Servo ${solver_basis} Core/Solvers Core/Tools Core/Regions)

set(device_basis Core/Math Core/Model/ForceCaps.h Core/Servo)
# The list of kinds names each kind.
allow(Devices/Common ${device_basis} Devices/Falcon/FalconKind.h Devices/Haply/HaplyKind.h Devices/Hfab/HfabKind.h
  Devices/Pad/PadKind.h Devices/Pid/PidKind.h Devices/SpaceMouse/SpaceMouseKind.h Devices/Vendor/VendorKind.h Devices/WoodenHaptics/WoodenKind.h
  Devices/Xr/XrKind.h)
allow(Devices/Transport/Usb ${device_basis} Devices/Common)
allow(Devices/Transport/Hid ${device_basis} Devices/Common)
allow(Devices/Transport/Serial ${device_basis})
allow(Devices/Transport/WebSocket ${device_basis})
allow(Devices/Guard ${device_basis} Devices/Common)
allow(Devices/Falcon ${device_basis} Devices/Common Devices/Guard Devices/Transport/Usb)
allow(Devices/Haply ${device_basis} Devices/Common Devices/Transport/WebSocket)
allow(Devices/Hfab ${device_basis} Devices/Common Devices/Transport/Serial)
allow(Devices/Pad ${device_basis} Devices/Common Devices/Guard Devices/Transport/Hid)
allow(Devices/Pid ${device_basis} Devices/Common Devices/Transport/Hid)
allow(Devices/SpaceMouse ${device_basis} Devices/Common Devices/Transport/Hid)
allow(Devices/WoodenHaptics ${device_basis} Devices/Common Devices/Transport/Hid)
allow(Devices/Vendor ${device_basis} Devices/Common)
allow(Devices/Virtual ${device_basis})
allow(Devices/Replay ${device_basis})
allow(Devices/Xr ${device_basis} Devices/Common Devices/Pad Devices/Virtual)

allow(VTK/Baking Core/Math Core/Carving Core/Field Core/Model Core/Solvers VTK/Files VTK/Work)
allow(VTK/Proposal Core/Math Core/Field Core/Proposal VTK/Baking VTK/Work)
allow(VTK/Files)
# How numbers are read in any locale.
set(numbers Core/Math/NumberText.h)
allow(VTK/Labels VTK/Files ${numbers})
allow(VTK/Headset VTK/Files)
allow(VTK/Large Core/Math Core/Field Core/Model Core/Regions Core/Solvers Core/Servo/ServoClock.h VTK/Baking VTK/Files VTK/Work)
allow(VTK/Trace Core VTK/Baking VTK/Files)
allow(VTK/Measure Core/Math VTK/Baking VTK/Files VTK/Labels VTK/Trace)
allow(VTK/Filter Core VTK/Baking VTK/Files VTK/Trace VTK/Work)
allow(VTK/Recording Core VTK/Files VTK/Trace)
# Threads and memory for work on volumes: of the core, only the clock.
allow(VTK/Work Core/Servo/ServoClock.h)
allow(VTK/Session Core Devices VTK/Baking VTK/Files VTK/Filter VTK/Trace VTK/Recording VTK/Work)
allow(VTK/Scene Core VTK/Baking VTK/Filter VTK/Measure VTK/Session VTK/Work)
allow(VTK/Docks)
# Letters are sized to the screen's dots per inch everywhere.
set(pixels VTK/Charts/HapticPixels.h)
allow(VTK/Slices VTK/Filter VTK/Scene/CarvedImage.h VTK/Scene/FilterCarving.h ${pixels})
allow(VTK/Charts VTK/Baking/HapticFunctions.h VTK/Proposal VTK/Work)
allow(VTK/Setup Core/Model VTK/Baking VTK/Files)
# What programs with Qt compile: it sees public classes only, and no other room sees it.
allow(Qt)

# The programs see what any other project sees: the public classes. Only the explorer draws and writes traces with
# private classes of the library, of which it gets the objects, hands ticks on through a ring of headers alone, asks
# headers whether OpenGL runs on the processor and for the aspect of its renderers, sizes letters, shows a CT as the
# plugin does, and reads the heads of files, places grids and finds samples that are outside, and how Hounsfield units
# are stored, as the library does. All read numbers in any locale.
allow(Applications/DeviceTool ${numbers})
allow(Applications/Guard Devices/Falcon Devices/Guard Devices/Pad)
set(explorer Applications/Explorer)
set(chart VTK/Charts/HapticForceChart.h VTK/Charts/HapticForceTable.h)
set(writer VTK/Trace/TraceWriter.h)
set(ring Core/Servo/TraceRing.h)
set(software VTK/Scene/SoftwareOpenGL.h)
set(look VTK/Scene/CTLook.h)
set(aspect VTK/Docks/RendererAspect.h)
set(header VTK/Large/HeaderText.h)
set(parts VTK/Large/DataSetParts.h)
set(outside VTK/Baking/OutsideFiller.h VTK/Baking/HapticNoise.h)
set(memory VTK/Work/ArrayMemory.h)
allow(${explorer} ${chart} ${writer} ${ring} ${software} ${pixels} ${look} ${aspect} ${header} ${parts} ${outside} ${memory}
  ${numbers})
allow(${explorer}/Errors)
allow(${explorer}/Sound ${explorer}/Errors ${ring})
allow(${explorer}/Volume ${explorer}/Errors ${header} ${parts} ${outside} ${memory})
allow(${explorer}/Record ${explorer}/Errors)
allow(${explorer}/Analysis)
allow(${explorer}/View ${explorer}/Errors ${pixels} ${aspect} ${numbers})
allow(${explorer}/Path ${explorer}/Analysis ${explorer}/View)
set(exploration ${explorer}/Errors ${explorer}/Volume ${explorer}/Analysis ${explorer}/View ${explorer}/Path)
list(APPEND exploration ${explorer}/Sound)
allow(${explorer}/Exploration ${exploration})
list(APPEND exploration ${explorer}/Exploration)
allow(${explorer}/Scene ${exploration} ${software} ${look} ${aspect})
allow(${explorer}/Report ${exploration} ${chart} ${writer} ${aspect})
allow(${explorer}/Live ${exploration} ${explorer}/Record ${explorer}/Report ${explorer}/Scene ${writer})

set(solvers ForceField LocalSurface Paper Precise Primitives SurfaceProxy)
foreach (solver IN LISTS solvers)
  set(others ${solvers})
  list(REMOVE_ITEM others ${solver})
  string(REPLACE ";" "|" others "${others}")
  forbid("A solver must not know another one." "Core/Solvers/(${others})/" Core/Solvers/${solver})
endforeach ()
file(GLOB shared RELATIVE "${root}/Module" "${root}/Module/Core/Solvers/*.h" "${root}/Module/Core/Solvers/*.cxx")
forbid("The files that solvers share must not know a solver." "Core/Solvers/[A-Za-z]+/" ${shared})
forbid("Core and Devices must not know VTK." "[\"</]vtk[A-Za-z0-9_]*\\.h" Core Devices)
forbid("Sound must not know VTK." "[\"</]vtk[A-Za-z0-9_]*\\.h" ${explorer}/Sound)
forbid("Devices must not know solver parameters." "(HapticModel|ServoTick|PiecewiseTable)\\.h" Devices)
forbid("The filter must not know devices, rendering or interaction."
  "vtk(Render|Interactor|Prop|Actor|Volume\\.|VolumeMapper|Camera|Haptic(Device|Representation|State))|Devices/"
  VTK/Baking VTK/Filter VTK/Large VTK/Measure VTK/Proposal VTK/Files VTK/Trace
  VTK/vtkHapticRegionSource.h VTK/vtkHapticRegionSource.cxx
  VTK/vtkVolumeHapticsFilter.h VTK/vtkVolumeHapticsFilter.cxx
  VTK/vtkVolumeHapticsAlgorithm.h VTK/vtkVolumeHapticsAlgorithm.cxx)
forbid("The module must not know ParaView or Qt." "[\"<](vtkPV|vtkSM([A-OQ-Z]|P[a-z]|PV)|vtkSI|pq|Q[A-Z])" Core Devices VTK)
forbid("The plugin's filters must not know devices or views." "(HapticDevice|HapticView|[\"<](pq|Q[A-Z]))"
  ../Plugin/Filters)
forbid("The plugin's devices must not know views or Qt." "(HapticView|HapticController|HapticDock|[\"<](pq|Q[A-Z]))"
  ../Plugin/Live)
forbid("The plugin's views must not know Qt." "(HapticController|HapticDock|[\"<](pq|Q[A-Z]))" ../Plugin/View)
file(GLOB public RELATIVE "${root}/Module" "${root}/Module/VTK/vtk*.h")
forbid("Installed headers must not show a device library." "(boost/|hidapi|libusb|nlohmann)"
  ${public} Core/Servo/DeviceBackend.h Devices/Common/DeviceKind.h)

# A rule that matches nothing protects nothing: try the machinery on a file that breaks it.
file(STRINGS "${root}/Module/VTK/vtkVolumeHapticsFilter.h" probe REGEX "^#include")
if (NOT probe MATCHES "[\"</]vtk[A-Za-z0-9_]*\\.h")
  message(SEND_ERROR "The patterns no longer match a VTK include: ${probe}")
endif ()
