# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Checks that the examples in Documentation are identical to the files that other tests build and run.
cmake_minimum_required(VERSION 3.18)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
foreach (example IN ITEMS
    "Documentation/first-touch.md|Examples/Cxx/FirstTouch.cxx|{\n|"
    "Documentation/first-touch.md|Examples/Python/first_touch.py|import vtkLineSource\n|"
    "Documentation/window.md|Examples/Cxx/DropIn.cxx|  vtkNew<vtkVolumeHapticsFilter>|\n\n  window->Render")
  string(REPLACE "|" ";" example "${example}")
  list(GET example 0 document)
  list(GET example 1 file)
  list(GET example 2 start)
  list(GET example 3 end)
  file(READ "${root}/${document}" text)
  file(READ "${root}/${file}" code)
  # Compare only the code after the includes, or only the part that a reader adds to an application.
  string(FIND "${code}" "${start}" from)
  string(SUBSTRING "${code}" ${from} -1 code)
  if (end)
    string(FIND "${code}" "${end}" to)
    string(SUBSTRING "${code}" 0 ${to} code)
  endif ()
  string(FIND "${text}" "${code}" found)
  if (from LESS 0 OR found LESS 0)
    message(SEND_ERROR "${document} does not show ${file} as it is.")
  endif ()
endforeach ()
