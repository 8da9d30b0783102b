# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the targets of TouchFiles.h, linked to the module, with VolumeHaptics_BUILD_FUZZERS (set by fuzz.sh). Only the
# code that reads files is instrumented. VTK and the rest of the module are not, because instrumented code takes minutes
# to optimise.
set(sanitizers "-fsanitize=address,undefined" -fno-sanitize=vptr -fno-sanitize-recover=all)
set(instrumented -O1 -gline-tables-only -fsanitize=fuzzer-no-link ${sanitizers})
get_target_property(library VTK::VolumeHaptics ALIASED_TARGET)
set(module "${PROJECT_SOURCE_DIR}/Module")
file(GLOB readers "${module}/VTK/Base/Nrrd*.cxx" "${module}/VTK/Material/Labels/*.cxx"
  "${module}/VTK/Reading/vtk*.cxx" "${module}/VTK/Regions/*.cxx" "${module}/VTK/Regions/Formats/*.cxx")
set_property(SOURCE ${readers} TARGET_DIRECTORY "${library}" APPEND PROPERTY COMPILE_OPTIONS ${instrumented})
foreach (objects IN ITEMS VolumeHapticsReading VolumeHapticsInputFiles)
  target_compile_options(${objects} PRIVATE ${instrumented})
endforeach ()
add_library(TouchFiles OBJECT "${CMAKE_CURRENT_LIST_DIR}/TouchFiles.cxx")
target_compile_features(TouchFiles PUBLIC cxx_std_17)
target_compile_options(TouchFiles PUBLIC ${instrumented})
target_link_libraries(TouchFiles PUBLIC VTK::VolumeHaptics VTK::CommonExecutionModel)
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/TouchFiles.h" targets REGEX "^void Touch")
list(TRANSFORM targets REPLACE "^void ([A-Za-z]+).*" "\\1")
foreach (target IN LISTS targets)
  add_executable(${target} "${CMAKE_CURRENT_LIST_DIR}/LibFuzzer.cxx")
  target_compile_definitions(${target} PRIVATE VOLUME_HAPTICS_FUZZ_TARGET=${target})
  target_link_options(${target} PRIVATE -fsanitize=fuzzer ${sanitizers})
  target_link_libraries(${target} PRIVATE TouchFiles)
endforeach ()
if (TARGET volumehaptics-read) # it loads the module, and so needs the module's sanitizers
  target_compile_options(volumehaptics-read PRIVATE ${sanitizers})
  target_link_options(volumehaptics-read PRIVATE ${sanitizers})
  # The code that limits the memory is not instrumented, but must allow for the sanitizers, which map terabytes.
  target_compile_definitions(VolumeHapticsPlatform PRIVATE VOLUME_HAPTICS_SANITIZED)
endif ()
if (TARGET volumehaptics-dicom) # GDCM reads in this process, which is not instrumented
  add_dependencies(TouchDicom volumehaptics-dicom)
endif ()
