# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Checks that all files with a version number have the version of CMakeLists.txt. The library's soname and its Debian
# package contain its first two numbers.
cmake_minimum_required(VERSION 3.18)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
file(READ "${root}/CMakeLists.txt" text)
string(REGEX MATCH "project\\(VolumeHaptics[ \n]+VERSION (([0-9]+[.][0-9]+)[.][0-9]+)\n" found "${text}")
if (NOT found)
  message(FATAL_ERROR "CMakeLists.txt has no version.")
endif ()
set(version "${CMAKE_MATCH_1}")
set(series "${CMAKE_MATCH_2}")

# Each line must occur at least once, and never with a different number.
foreach (line IN ITEMS
    "CITATION.cff|\nversion: |${version}"
    "CMake/packages/conda/recipe.yaml|\n  version: |${version}"
    "CMake/packages/debian/control|libvtkvolumehaptics|${series}"
    "Documentation/building.md|libvtkvolumehaptics|${series}"
    "Documentation/install.md|libvtkvolumehaptics|${series}"
    "Examples/Cxx/CMakeLists.txt|find_package\\(VolumeHaptics |${series}"
    "CHANGELOG.md|\n## |${version}")
  string(REPLACE "|" ";" line "${line}")
  list(GET line 0 file)
  list(GET line 1 before)
  list(GET line 2 wanted)
  file(READ "${root}/${file}" text)
  string(REGEX MATCHALL "${before}[0-9][0-9.]*[0-9]" names "${text}")
  if (file STREQUAL "CHANGELOG.md") # compares only the newest version
    list(SUBLIST names 0 1 names)
  endif ()
  if (NOT names)
    message(SEND_ERROR "${file} names no version.")
  endif ()
  foreach (name IN LISTS names)
    string(REGEX MATCH "[0-9][0-9.]*$" name "${name}")
    if (NOT name STREQUAL wanted)
      message(SEND_ERROR "${file} names version ${name}; CMakeLists.txt has ${version}.")
    endif ()
  endforeach ()
endforeach ()

set(list "CMake/packages/debian/libvtkvolumehaptics${series}.install")
if (NOT EXISTS "${root}/${list}")
  message(SEND_ERROR "There is no ${list}, which lists the files of the Debian package of version ${version}.")
endif ()
