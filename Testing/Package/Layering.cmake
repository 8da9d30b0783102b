# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Checks which room (folder of sources) may include which, with one line for each room. A room may include itself and
# the rooms in its line; even its own subfolders must be listed. Public headers are included by their bare names. They
# count as files of their room, as do forward declarations of their classes ("class vtkHapticDevice;").
cmake_minimum_required(VERSION 3.18)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

set(named_rooms)

# Map each public header's class to the header's path.
file(GLOB_RECURSE public RELATIVE "${root}/Module" "${root}/Module/VTK/vtk*.h")
foreach (header IN LISTS public)
  get_filename_component(class "${header}" NAME_WE)
  set("path_of_${class}" "${header}")
endforeach ()

# allow(ROOM NAME...): fails if a file of ROOM includes a header that is neither in one of the named rooms nor one of
# the named files. Private headers are included by their path in Module ("Core/Math/Vector3.h"), and public headers by
# their bare names. The name PUBLIC allows all public headers.
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
      if (NOT other STREQUAL room)
        set_property(GLOBAL APPEND PROPERTY "uses_${room}" "${other}")
      endif ()
      if (NOT other STREQUAL room AND NOT other IN_LIST ARGN AND NOT header IN_LIST ARGN)
        message(SEND_ERROR "${file} includes or declares ${header}. ${room} may include: ${ARGN}")
      endif ()
    endforeach ()
  endforeach ()
  set(named_rooms "${named_rooms}" PARENT_SCOPE)
endfunction()

# forbid(REASON PATTERN FOLDER...): fails for every #include in the folders' files that matches the pattern.
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

# Rooms of Core, each of which may include those to its left: Math, Carving <- Field <- Model <- Law <- State <-
# Solvers, Tools <- Regions <- Servo; Safety, Realtime <- Servo.
set(field Core/Math Core/Carving Core/Field)
set(model ${field} Core/Field/Kernels Core/Model)
set(state ${model} Core/Law Core/State)
file(GLOB each_solver RELATIVE "${root}/Module" "${root}/Module/Core/Solvers/*/*.h")
list(TRANSFORM each_solver REPLACE "/[^/]*$" "")
list(REMOVE_DUPLICATES each_solver)
list(REMOVE_ITEM each_solver Core/Solvers/Methods)
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
# A solver must not include another solver.
foreach (solver IN LISTS each_solver)
  allow(${solver} ${state} Core/Solvers)
endforeach ()
# A tool must not include another tool, except that the burr's head is a point shell. No other room of Core may include
# a tool.
file(GLOB each_tool RELATIVE "${root}/Module" "${root}/Module/Core/Tools/*")
set(head_of_Core/Tools/Burr Core/Tools/PointShell)
foreach (tool IN LISTS each_tool)
  allow(${tool} ${state} ${head_of_${tool}})
endforeach ()
# Only the list of methods includes every method.
allow(Core/Solvers/Methods ${state} Core/Solvers ${each_solver})
list(APPEND each_solver Core/Solvers Core/Solvers/Methods)
allow(Core/Regions ${state} ${each_solver})
# The code that decides about force, and the code that waits for time, must not include volumes or solvers.
allow(Core/Safety Core/Math Core/Model/ForceCaps.h)
# Only Platform may depend on the operating system. Other code uses Platform, or the clock and priority of Realtime.
allow(Core/Platform)
allow(Core/Realtime Core/Platform)
set(core ${state} Core/Field/Estimates Core/Proposal ${each_solver} Core/Regions Core/Safety Core/Realtime Core/Platform)
allow(Core/Servo ${core})
list(APPEND core Core/Servo)

set(device_basis Core/Math Core/Model/ForceCaps.h Core/Safety Core/Realtime Core/Platform)
allow(Devices/Common ${device_basis})
allow(Devices/Transport/Usb ${device_basis} Devices/Common)
allow(Devices/Transport/Hid ${device_basis} Devices/Common)
allow(Devices/Transport/Evdev)
allow(Devices/Transport/Serial ${device_basis})
allow(Devices/Transport/Local)
allow(Devices/Transport/WebSocket ${device_basis})
allow(Devices/Guard ${device_basis} Devices/Common)
allow(Devices/Falcon ${device_basis} Devices/Common Devices/Guard Devices/Transport/Usb)
allow(Devices/Haply ${device_basis} Devices/Common Devices/Transport/Local Devices/Transport/WebSocket)
allow(Devices/Hfab ${device_basis} Devices/Common Devices/Transport/Serial)
allow(Devices/Pad ${device_basis} Devices/Common Devices/Guard Devices/Transport/Evdev Devices/Transport/Hid)
allow(Devices/Pid ${device_basis} Devices/Common Devices/Transport/Hid)
allow(Devices/SpaceMouse ${device_basis} Devices/Common Devices/Transport/Hid)
allow(Devices/Vibration ${device_basis} Devices/Common Devices/Guard Devices/Pad Devices/Transport/Local Devices/Transport/WebSocket
  Devices/Virtual)
allow(Devices/Wheel ${device_basis} Devices/Common Devices/Transport/Evdev)
allow(Devices/WoodenHaptics ${device_basis} Devices/Common Devices/Transport/Hid)
allow(Devices/Vendor ${device_basis} Devices/Common)
allow(Devices/Virtual ${device_basis})
allow(Devices/Replay ${device_basis})
allow(Devices/Xr ${device_basis} Devices/Common Devices/Pad Devices/Virtual)
# Only the list of kinds includes every kind of device.
allow(Devices/Kinds ${device_basis} Devices/Common Devices/Falcon Devices/Haply Devices/Hfab Devices/Pad Devices/Pid
  Devices/SpaceMouse Devices/Vendor Devices/Vibration Devices/Wheel Devices/WoodenHaptics Devices/Xr)

# Rooms of VTK, each of which may include those to its left: Base <- Material <- Baking <- Tools, Modes <- Trace <-
# Regions <- Filter <- Device <- Setup, Measure <- Scene.
# NumberText.h reads numbers in any locale.
set(numbers Core/Math/NumberText.h)
# Runs long work in the background of the GUI thread.
set(work Core/Realtime/BackgroundWork.h)
set(samples ${field} Core/Field/Estimates Core/Model)
# Opens several files as one, and replaces files atomically.
set(files Core/Platform/HapticFiles.h Core/Platform/FileReplacement.h)
allow(VTK/Base ${samples} Core/Realtime Core/Platform)
allow(VTK/Material/Labels ${numbers} Core/Platform VTK/Base)
allow(VTK/Material ${samples} ${files} ${work} Core/Proposal VTK/Base VTK/Material/Labels)
set(baking VTK/Base VTK/Material VTK/Material/Labels)
allow(VTK/Baking ${samples} ${work} ${baking})
list(APPEND baking VTK/Baking)
allow(VTK/Tools ${samples} ${files} ${work} Core/State ${each_tool} ${baking})
allow(VTK/Modes ${samples} ${files} Core/Solvers/Primitives ${baking})
# Recordings store the contacts of shaped tools.
set(contacts Core/Tools/PointShell)
allow(VTK/Trace ${core} ${contacts} ${baking} VTK/Tools VTK/Modes)
allow(VTK/Trace/Paths ${core} ${contacts} ${baking} VTK/Tools VTK/Modes VTK/Trace)
allow(VTK/Regions/Formats ${numbers} Core/Platform VTK/Base)
list(APPEND baking VTK/Tools VTK/Modes)
allow(VTK/Regions ${samples} ${files} Core/State ${each_solver} Core/Regions Core/Realtime ${baking} VTK/Regions/Formats)
# Reads files and folders into memory. DICOM is a separate room at the same level.
allow(VTK/Reading Core/Platform VTK/Base VTK/Material/Labels VTK/Baking VTK/Regions VTK/Regions/Formats VTK/Reading/Dicom)
allow(VTK/Reading/Dicom ${numbers} Core/Platform VTK/Base VTK/Material/Labels VTK/Baking VTK/Regions VTK/Reading)
set(filter ${baking} VTK/Trace VTK/Trace/Paths VTK/Regions)
allow(VTK/Filter ${core} ${filter})
list(APPEND filter VTK/Filter)
allow(VTK/Device/Recording ${core} ${contacts} VTK/Base VTK/Tools VTK/Trace)
allow(VTK/Device/Playback ${core} ${filter})
set(device Devices/Common Devices/Kinds Devices/Replay Devices/Virtual Devices/Xr)
allow(VTK/Device ${core} ${device} ${filter} VTK/Device/Playback VTK/Device/Recording)
allow(VTK/Setup Core/Model ${files} ${filter})
allow(VTK/Measure Core/Math ${files} ${filter})
set(touched ${core} ${filter} VTK/Device VTK/Device/Playback VTK/Measure)
set(scene VTK/Scene/Base)
allow(VTK/Scene/Base ${touched})
allow(VTK/Scene/Frames ${touched} ${scene})
allow(VTK/Scene/Hand ${touched} ${scene})
allow(VTK/Scene/Volumes ${touched} ${scene})
allow(VTK/Scene/Display ${touched} ${scene} VTK/Scene/Hand)
allow(VTK/Scene/Slices ${touched} ${scene} VTK/Scene/Volumes VTK/Scene/Display)
allow(VTK/Scene/Editor ${work} VTK/Base VTK/Material VTK/Material/Labels ${scene})
allow(VTK/Scene/Interaction ${touched} ${scene} VTK/Scene/Frames VTK/Scene/Hand VTK/Scene/Volumes VTK/Scene/Display
  VTK/Scene/Slices VTK/Scene/Editor)
allow(VTK/Experimental Core/Realtime ${files} Devices/Pad VTK/Base VTK/Device ${scene})
# Programs compile this room with their own Qt. It may use public classes only, and no other room may include it.
allow(Qt PUBLIC)

# Programs may use public classes only, like other projects. The explorer also uses private headers: to draw its chart,
# write traces, pass on ticks through a ring, detect OpenGL on the processor, read the aspect of its renderers and the
# size of letters, dock its bar, show a CT as the plugin does, and read files as the library does. All programs read
# numbers in any locale.
allow(Applications/DeviceTool PUBLIC ${numbers})
allow(Applications/Autoload PUBLIC)
allow(Applications/Dicom Core/Platform VTK/Reading/Dicom/DicomMessage.h)
allow(Applications/Read)
allow(Applications/Guard Devices/Falcon Devices/Guard Devices/Pad Devices/Vibration)
set(explorer Applications/Explorer)
set(chart VTK/Scene/Display/HapticForceChart.h VTK/Scene/Display/HapticForceTable.h)
set(writer VTK/Trace/TraceWriter.h)
set(ring Core/Servo/TraceRing.h)
set(software VTK/Scene/Frames/SoftwareOpenGL.h)
set(look VTK/Scene/Volumes/CTLook.h)
set(aspect VTK/Scene/Base/RendererAspect.h)
set(pixels VTK/Scene/Base/HapticPixels.h)
set(reading VTK/Reading VTK/Reading/Dicom)
set(exploration ${reading} ${explorer}/Analysis ${explorer}/View ${explorer}/Path
  ${explorer}/Sound)
allow(${explorer}/Sound ${reading} ${ring})
allow(${explorer}/Record PUBLIC ${reading})
allow(${explorer}/Analysis PUBLIC)
allow(${explorer}/View PUBLIC ${reading} ${pixels} ${aspect} ${numbers})
allow(${explorer}/Bar PUBLIC ${pixels} VTK/Scene/Base/KeyRepeat.h VTK/Scene/Base/WindowDock.h ${explorer}/View)
allow(${explorer}/Path PUBLIC ${explorer}/Analysis ${explorer}/View)
allow(${explorer}/Exploration PUBLIC ${exploration})
list(APPEND exploration ${explorer}/Exploration)
allow(${explorer}/Scene PUBLIC ${exploration} ${explorer}/Bar ${software} ${look} ${aspect})
allow(${explorer}/Report PUBLIC ${exploration} ${chart} ${writer} ${aspect})
list(APPEND exploration ${explorer}/Record ${explorer}/Report ${explorer}/Scene)
allow(${explorer}/Live PUBLIC ${exploration} ${explorer}/Bar ${writer} ${pixels})
allow(${explorer} PUBLIC ${exploration} ${explorer}/Live ${numbers})

forbid("Core and Devices must not know VTK." "[\"</]vtk[A-Za-z0-9_]*\\.h" Core Devices)
forbid("Sound must not know VTK." "[\"</]vtk[A-Za-z0-9_]*\\.h" ${explorer}/Sound)
forbid("Devices must not know solver parameters." "(HapticModel|ServoTick|PiecewiseTable)\\.h" Devices)
forbid("The filter must not know devices, rendering or interaction."
  "vtk(Render|Interactor|Prop|Actor|Volume\\.|VolumeMapper|Camera|Haptic(Device|Representation|State))|Devices/"
  VTK/Base VTK/Material VTK/Baking VTK/Tools VTK/Modes VTK/Trace VTK/Regions VTK/Filter VTK/Measure)
# No code outside VTK/Tools may name its classes, except those with the points of a shell, which the filter spreads in
# the background.
set(tools "${public}")
list(FILTER tools INCLUDE REGEX "^VTK/Tools/")
list(FILTER tools EXCLUDE REGEX "vtkHaptic(Tool|ShapedTool|Removal)\\.h$")
list(TRANSFORM tools REPLACE ".*/(vtk.*)\\.h" "\\1")
string(REPLACE ";" "|" tools "${tools}")
forbid("A tool is known by its kind only: VTK/Tools/ToolKind.h." "(${tools})\\.h" VTK/Base VTK/Material VTK/Baking VTK/Modes
  VTK/Trace VTK/Regions VTK/Device VTK/Setup VTK/Measure VTK/Scene VTK/Experimental)
forbid("The module must not know ParaView or Qt." "[\"<](vtkPV|vtkSM([A-OQ-Z]|P[a-z]|PV)|vtkSI|pq|Q[A-Z])" Core Devices VTK)
forbid("The plugin's filters must not know devices or views." "(HapticDevice|HapticView|[\"<](pq|Q[A-Z]))"
  ../Plugin/Filters)
forbid("The plugin's devices must not know views or Qt." "(HapticView|HapticController|HapticDock|[\"<](pq|Q[A-Z]))"
  ../Plugin/Live)
forbid("The plugin's views must not know Qt." "(HapticController|HapticDock|[\"<](pq|Q[A-Z]))" ../Plugin/View)
forbid("What the systems differ in goes through Core/Platform."
  "<(unistd|fcntl|poll|pthread|sched|dlfcn|termios|spawn|pwd|grp|windows|io)\\.h>|<(sys|linux|mach|netinet|arpa)/"
  Core/Carving Core/Field Core/Law Core/Math Core/Model Core/Proposal Core/Regions Core/Safety Core/Servo Core/Solvers
  Core/State Core/Tools Devices/Common Devices/Falcon Devices/Hfab Devices/Kinds Devices/Pid Devices/Replay
  Devices/SpaceMouse Devices/Transport/WebSocket Devices/Vendor Devices/Virtual Devices/WoodenHaptics Devices/Xr
  VTK/Base VTK/Baking VTK/Device/Playback VTK/Device/Recording VTK/Experimental VTK/Filter VTK/Material VTK/Measure
  VTK/Modes VTK/Regions VTK/Setup VTK/Tools VTK/Trace)
forbid("Installed headers must not show a device library." "(boost/|hidapi|libusb|nlohmann)"
  ${public} Core/Safety/DeviceBackend.h Devices/Common/DeviceKind.h)

# Fail for a rule that matches nothing, because such a rule protects nothing.
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

# Compare the table of rooms in architecture.md with the rooms of public classes and their includes. `cmake -DWRITE=ON
# -P` updates the table.
set(begin "| room of `Module/VTK` | public classes | uses |\n| --- | --- | --- |\n")
set(table "${begin}")
foreach (room IN LISTS named_rooms)
  set(classes "${public}")
  list(FILTER classes INCLUDE REGEX "^${room}/[^/]+$")
  list(TRANSFORM classes REPLACE ".*/(.*)\\.h" "`\\1`")
  list(REMOVE_ITEM classes "`vtkVolumeHapticsCompat`") # private
  if (classes AND room MATCHES "^VTK/")
    get_property(uses GLOBAL PROPERTY "uses_${room}")
    list(FILTER uses INCLUDE REGEX "^VTK/")
    list(REMOVE_DUPLICATES uses)
    list(SORT uses)
    list(TRANSFORM uses REPLACE "^VTK/" "")
    string(REPLACE ";" ", " classes "${classes}")
    string(REPLACE ";" ", " uses "${uses}")
    string(REPLACE "VTK/" "" name "${room}")
    string(APPEND table "| `${name}` | ${classes} | ${uses} |\n")
  endif ()
endforeach ()
set(document "${root}/Documentation/architecture.md")
file(READ "${document}" text)
string(FIND "${text}" "${begin}" first)
if (first EQUAL -1)
  message(FATAL_ERROR "${document} has no table that begins with\n${begin}")
endif ()
string(SUBSTRING "${text}" 0 ${first} before)
string(SUBSTRING "${text}" ${first} -1 after)
string(FIND "${after}" "\n\n" end)
math(EXPR end "${end} + 1")
string(SUBSTRING "${after}" 0 ${end} shown)
string(SUBSTRING "${after}" ${end} -1 after)
if (WRITE)
  file(WRITE "${document}" "${before}${table}${after}")
elseif (NOT shown STREQUAL table)
  message(SEND_ERROR "The table of arrows in ${document} is not that of the code. "
    "Write it: cmake -DWRITE=ON -P Testing/Package/Layering.cmake")
endif ()

# Limit the size of each room, so that it can be read in one go.
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

# Limit the code of Module/VTK to its present size. Blank lines and comments do not count.
file(GLOB_RECURSE files "${root}/Module/VTK/*")
list(LENGTH files count)
set(lines 0)
foreach (file IN LISTS files)
  if (file MATCHES "\\.(h|cxx)$")
    file(READ "${file}" text)
    string(REGEX REPLACE "\n[ \t]*(//|/\\*|\\* |\\*/|\\*\n)[^\n]*" "" code "\n${text}")
    string(REGEX REPLACE "[\n \t]*\n" "\n" code "${code}")
    string(REGEX REPLACE "[^\n]" "" code "${code}")
    string(LENGTH "${code}" length)
    math(EXPR lines "${lines} + ${length} - 1")
  endif ()
endforeach ()
message(STATUS "Module/VTK: ${count} files, ${lines} lines of code")
if (count GREATER 450 OR lines GREATER 70000)
  message(SEND_ERROR "Module/VTK has ${count} files with ${lines} lines of code; 450 and 70,000 are allowed.")
endif ()
