# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Which room may include which: one line a folder. A room may always include itself; nothing else that is not named,
# its own folders neither. Public headers, which are included by their bare names, and their classes where they are
# declared only ("class vtkHapticDevice;"), count as what they are: files of a room.
cmake_minimum_required(VERSION 3.18)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

# The arrows that go back up, until what they stand for is mended. FILE (without its ending) may name HEADER.
set(exceptions
  # Regions read from the filter how far it reads.
  VTK/Regions/vtkHapticRegionPlanner>VTK/Filter/vtkVolumeHapticsFilter.h
  VTK/Regions/vtkHapticRegionSource>VTK/Filter/vtkVolumeHapticsFilter.h
  # The list of kinds names each kind.
  Devices/Common/BuiltInKinds>Devices/Falcon/FalconKind.h
  Devices/Common/BuiltInKinds>Devices/Haply/HaplyKind.h
  Devices/Common/BuiltInKinds>Devices/Hfab/HfabKind.h
  Devices/Common/BuiltInKinds>Devices/Pad/PadKind.h
  Devices/Common/BuiltInKinds>Devices/Pid/PidKind.h
  Devices/Common/BuiltInKinds>Devices/SpaceMouse/SpaceMouseKind.h
  Devices/Common/BuiltInKinds>Devices/Vendor/VendorKind.h
  Devices/Common/BuiltInKinds>Devices/WoodenHaptics/WoodenKind.h
  Devices/Common/BuiltInKinds>Devices/Xr/XrKind.h)
set(unused_exceptions ${exceptions})
set(named_rooms)

# The room of each public header, by its class.
file(GLOB_RECURSE public RELATIVE "${root}/Module" "${root}/Module/VTK/vtk*.h")
foreach (header IN LISTS public)
  get_filename_component(class "${header}" NAME_WE)
  set("path_of_${class}" "${header}")
endforeach ()

# Private headers are written from Module: "Core/Math/Vector3.h"; public ones by their bare names. Fails for those that
# are in none of the rooms that follow, and are none of the files that follow. PUBLIC among them: any public header.
function(allow room)
  list(APPEND named_rooms "${room}")
  file(GLOB files RELATIVE "${root}/Module" "${root}/Module/${room}/*.h" "${root}/Module/${room}/*.cxx")
  if (NOT files)
    message(SEND_ERROR "No files in ${room}: the rule protects nothing.")
  endif ()
  foreach (file IN LISTS files)
    file(STRINGS "${root}/Module/${file}" lines
      REGEX "^[ \t]*(#[ \t]*include [\"<](Core|Devices|VTK|Applications|Qt)/|#[ \t]*include \"[A-Z]|#[ \t]*include [\"<]vtk|class vtk[A-Za-z0-9]+;)")
    foreach (line IN LISTS lines)
      set(header)
      if (line MATCHES "[\"<]((Core|Devices|VTK|Applications|Qt)/[^\">]*)[\">]")
        set(header "${CMAKE_MATCH_1}")
      elseif (line MATCHES "include \"([A-Z][^\"]*)\"")
        message(SEND_ERROR "${file}: ${line} names a private header without its room.")
      elseif (line MATCHES "(vtk[A-Za-z0-9]+)(\\.h[\">]|;)" AND NOT "PUBLIC" IN_LIST ARGN)
        set(header "${path_of_${CMAKE_MATCH_1}}") # none of VTK's own
      endif ()
      if (NOT header)
        continue ()
      endif ()
      get_filename_component(other "${header}" DIRECTORY)
      string(REGEX REPLACE "\\.[a-z]+$" "" stem "${file}")
      if ("${stem}>${header}" IN_LIST exceptions)
        list(REMOVE_ITEM unused_exceptions "${stem}>${header}")
      elseif (NOT other STREQUAL room AND NOT other IN_LIST ARGN AND NOT header IN_LIST ARGN)
        message(SEND_ERROR "${file} includes or declares ${header}. ${room} may include: ${ARGN}")
      endif ()
    endforeach ()
  endforeach ()
  set(named_rooms "${named_rooms}" PARENT_SCOPE)
  set(unused_exceptions "${unused_exceptions}" PARENT_SCOPE)
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

# Core: Math, Carving <- Field <- Model <- Law <- State <- Solvers, Tools <- Regions <- Servo; Safety, Realtime <- Servo.
set(field Core/Math Core/Carving Core/Field)
set(model ${field} Core/Field/Kernels Core/Model)
set(state ${model} Core/Law Core/State)
set(solvers ForceField LocalSurface Paper Precise Primitives SurfaceProxy)
list(TRANSFORM solvers PREPEND Core/Solvers/ OUTPUT_VARIABLE each_solver)
allow(Core/Math)
allow(Core/Carving)
allow(Core/Field Core/Math Core/Carving)
allow(Core/Field/Kernels ${field})
allow(Core/Field/Estimates ${field})
allow(Core/Proposal Core/Math Core/Field)
allow(Core/Model ${field})
allow(Core/Law ${model})
allow(Core/State ${model} Core/Law)
allow(Core/Solvers ${state})
# A solver must not know another one.
foreach (solver IN LISTS each_solver)
  allow(${solver} ${state} Core/Solvers)
endforeach ()
allow(Core/Tools/Needle ${state})
allow(Core/Tools/PointShell ${state})
allow(Core/Tools/Burr ${state} Core/Tools/PointShell)
allow(Core/Tools ${state} Core/Tools/Burr Core/Tools/Needle Core/Tools/PointShell)
allow(Core/Regions ${state} ${each_solver})
# What decides about force, and what waits for time, knows neither a volume nor a solver.
allow(Core/Safety Core/Math Core/Model/ForceCaps.h)
allow(Core/Realtime)
set(core ${state} Core/Field/Estimates Core/Proposal Core/Solvers ${each_solver} Core/Tools Core/Tools/Burr
  Core/Tools/Needle Core/Tools/PointShell Core/Regions Core/Safety Core/Realtime)
allow(Core/Servo ${core})
list(APPEND core Core/Servo)

set(device_basis Core/Math Core/Model/ForceCaps.h Core/Safety Core/Realtime)
allow(Devices/Common ${device_basis})
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

# VTK: Base <- Material <- Baking <- Tools, Modes <- Trace <- Regions <- Filter <- Device <- Setup, Measure <- Scene.
# How numbers are read in any locale.
set(numbers Core/Math/NumberText.h)
set(samples ${field} Core/Field/Estimates Core/Model)
allow(VTK/Base ${samples} Core/Realtime)
allow(VTK/Material/Labels ${numbers} VTK/Base)
allow(VTK/Material ${samples} Core/Proposal VTK/Base VTK/Material/Labels)
set(baking VTK/Base VTK/Material VTK/Material/Labels)
allow(VTK/Baking ${samples} ${baking})
list(APPEND baking VTK/Baking)
allow(VTK/Tools ${samples} Core/State ${baking})
allow(VTK/Modes ${samples} Core/Solvers/Primitives ${baking})
allow(VTK/Trace ${core} ${baking} VTK/Tools VTK/Modes)
allow(VTK/Trace/Paths ${core} ${baking} VTK/Tools VTK/Modes VTK/Trace)
allow(VTK/Regions/Formats ${numbers} VTK/Base)
list(APPEND baking VTK/Tools VTK/Modes)
allow(VTK/Regions ${samples} Core/State ${each_solver} Core/Regions Core/Realtime ${baking} VTK/Regions/Formats)
set(filter ${baking} VTK/Trace VTK/Trace/Paths VTK/Regions)
allow(VTK/Filter ${core} ${filter})
list(APPEND filter VTK/Filter)
allow(VTK/Device/Recording ${core} VTK/Base VTK/Tools VTK/Trace)
allow(VTK/Device/Playback ${core} ${filter})
set(device Devices/Common Devices/Replay Devices/Virtual Devices/Xr)
allow(VTK/Device ${core} ${device} ${filter} VTK/Device/Playback VTK/Device/Recording)
allow(VTK/Setup Core/Model ${filter})
allow(VTK/Measure Core/Math ${filter})
set(touched ${core} ${filter} VTK/Device VTK/Device/Playback VTK/Measure)
set(scene VTK/Scene/Base)
allow(VTK/Scene/Base ${touched})
allow(VTK/Scene/Frames ${touched} ${scene})
allow(VTK/Scene/Hand ${touched} ${scene})
allow(VTK/Scene/Volumes ${touched} ${scene})
allow(VTK/Scene/Display ${touched} ${scene} VTK/Scene/Hand)
allow(VTK/Scene/Slices ${touched} ${scene} VTK/Scene/Volumes VTK/Scene/Display)
allow(VTK/Scene/Editor VTK/Base VTK/Material VTK/Material/Labels ${scene})
allow(VTK/Scene/Interaction ${touched} ${scene} VTK/Scene/Frames VTK/Scene/Hand VTK/Scene/Volumes VTK/Scene/Display
  VTK/Scene/Slices VTK/Scene/Editor)
allow(VTK/Experimental Core/Realtime Devices/Pad VTK/Base VTK/Device ${scene})
# What programs with Qt compile: it sees public classes only, and no other room sees it.
allow(Qt PUBLIC)

# The programs see what any other project sees: the public classes. Only the explorer draws and writes traces with
# private classes of the library, of which it gets the objects, hands ticks on through a ring of headers alone, asks
# headers whether OpenGL runs on the processor and for the aspect of its renderers, sizes letters, shows a CT as the
# plugin does, and reads the heads of files, places grids and finds samples that are outside, and how Hounsfield units
# are stored, as the library does. All read numbers in any locale.
allow(Applications/DeviceTool PUBLIC ${numbers})
allow(Applications/Guard Devices/Falcon Devices/Guard Devices/Pad)
set(explorer Applications/Explorer)
set(chart VTK/Scene/Display/HapticForceChart.h VTK/Scene/Display/HapticForceTable.h)
set(writer VTK/Trace/TraceWriter.h)
set(ring Core/Servo/TraceRing.h)
set(software VTK/Scene/Frames/SoftwareOpenGL.h)
set(look VTK/Scene/Volumes/CTLook.h)
set(aspect VTK/Scene/Base/RendererAspect.h)
set(pixels VTK/Scene/Base/HapticPixels.h)
set(header VTK/Regions/Formats/HeaderText.h)
set(parts VTK/Regions/DataSetParts.h)
set(outside VTK/Base/OutsideFiller.h VTK/Base/HapticNoise.h)
set(memory VTK/Base/ArrayMemory.h)
set(exploration ${explorer}/Errors ${explorer}/Volume ${explorer}/Analysis ${explorer}/View ${explorer}/Path
  ${explorer}/Sound)
allow(${explorer}/Errors PUBLIC)
allow(${explorer}/Sound ${explorer}/Errors ${ring})
allow(${explorer}/Volume PUBLIC ${explorer}/Errors ${header} ${parts} ${outside} ${memory})
allow(${explorer}/Record PUBLIC ${explorer}/Errors)
allow(${explorer}/Analysis PUBLIC)
allow(${explorer}/View PUBLIC ${explorer}/Errors ${pixels} ${aspect} ${numbers})
allow(${explorer}/Path PUBLIC ${explorer}/Analysis ${explorer}/View)
allow(${explorer}/Exploration PUBLIC ${exploration})
list(APPEND exploration ${explorer}/Exploration)
allow(${explorer}/Scene PUBLIC ${exploration} ${software} ${look} ${aspect})
allow(${explorer}/Report PUBLIC ${exploration} ${chart} ${writer} ${aspect})
list(APPEND exploration ${explorer}/Record ${explorer}/Report ${explorer}/Scene)
allow(${explorer}/Live PUBLIC ${exploration} ${writer})
allow(${explorer} PUBLIC ${exploration} ${explorer}/Live ${numbers})

forbid("Core and Devices must not know VTK." "[\"</]vtk[A-Za-z0-9_]*\\.h" Core Devices)
forbid("Sound must not know VTK." "[\"</]vtk[A-Za-z0-9_]*\\.h" ${explorer}/Sound)
forbid("Devices must not know solver parameters." "(HapticModel|ServoTick|PiecewiseTable)\\.h" Devices)
forbid("The filter must not know devices, rendering or interaction."
  "vtk(Render|Interactor|Prop|Actor|Volume\\.|VolumeMapper|Camera|Haptic(Device|Representation|State))|Devices/"
  VTK/Base VTK/Material VTK/Baking VTK/Tools VTK/Modes VTK/Trace VTK/Regions VTK/Filter VTK/Measure)
forbid("The module must not know ParaView or Qt." "[\"<](vtkPV|vtkSM([A-OQ-Z]|P[a-z]|PV)|vtkSI|pq|Q[A-Z])" Core Devices VTK)
forbid("The plugin's filters must not know devices or views." "(HapticDevice|HapticView|[\"<](pq|Q[A-Z]))"
  ../Plugin/Filters)
forbid("The plugin's devices must not know views or Qt." "(HapticView|HapticController|HapticDock|[\"<](pq|Q[A-Z]))"
  ../Plugin/Live)
forbid("The plugin's views must not know Qt." "(HapticController|HapticDock|[\"<](pq|Q[A-Z]))" ../Plugin/View)
forbid("Installed headers must not show a device library." "(boost/|hidapi|libusb|nlohmann)"
  ${public} Core/Safety/DeviceBackend.h Devices/Common/DeviceKind.h)

# A rule that matches nothing protects nothing.
if (unused_exceptions)
  message(SEND_ERROR "These arrows back are gone: take them off the exceptions: ${unused_exceptions}")
endif ()
file(GLOB_RECURSE files RELATIVE "${root}/Module" "${root}/Module/*.h" "${root}/Module/*.cxx")
foreach (file IN LISTS files)
  get_filename_component(room "${file}" DIRECTORY)
  if (NOT room IN_LIST named_rooms)
    message(SEND_ERROR "${file} stands in a room without a line.")
    list(APPEND named_rooms "${room}")
  endif ()
endforeach ()
if (NOT DEFINED path_of_vtkVolumeHapticsFilter OR NOT path_of_vtkHapticBurr STREQUAL "VTK/Tools/vtkHapticBurr.h")
  message(SEND_ERROR "The public headers were not found: ${public}")
endif ()

# A room can be read in one go.
file(GLOB_RECURSE folders LIST_DIRECTORIES true RELATIVE "${root}" "${root}/Module/*" "${root}/Plugin/*")
foreach (folder IN LISTS folders)
  if (IS_DIRECTORY "${root}/${folder}")
    file(GLOB files LIST_DIRECTORIES false "${root}/${folder}/*")
    list(LENGTH files count)
    if (count GREATER 40)
      message(SEND_ERROR "${folder} has ${count} files, 40 are allowed: cut it where there are two subjects.")
    endif ()
  endif ()
endforeach ()
