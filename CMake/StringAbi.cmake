# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Finds out which ABI of std::string VTK was compiled with. VTK's own wheels for Linux on x86-64 use the ABI from before
# C++11. VTK's CMake package does not record the ABI, so a test program that passes a string to VTK is linked.
include(CheckCXXSourceCompiles)
include(CMakePushCheckState)
if (NOT VolumeHaptics_STRINGS_OF STREQUAL VTK_DIR)
  unset(VolumeHaptics_STRINGS_ARE_VTKS CACHE)
  unset(VolumeHaptics_OLD_STRINGS_ARE_VTKS CACHE)
  set(VolumeHaptics_STRINGS_OF "${VTK_DIR}" CACHE INTERNAL "The VTK whose strings were looked at")
endif ()
cmake_push_check_state(RESET)
set(CMAKE_REQUIRED_LIBRARIES VTK::vtksys)
set(hands_a_string_over "
  #include <vtksys/SystemTools.hxx>
  int main(int, char* argv[]) { return vtksys::SystemTools::FileExists(std::string(argv[0])); }")
check_cxx_source_compiles("${hands_a_string_over}" VolumeHaptics_STRINGS_ARE_VTKS)
if (NOT VolumeHaptics_STRINGS_ARE_VTKS)
  set(CMAKE_REQUIRED_DEFINITIONS -D_GLIBCXX_USE_CXX11_ABI=0)
  check_cxx_source_compiles("${hands_a_string_over}" VolumeHaptics_OLD_STRINGS_ARE_VTKS)
  if (NOT VolumeHaptics_OLD_STRINGS_ARE_VTKS)
    message(FATAL_ERROR "A program with VTK ${VTK_VERSION} can't be linked: see CMakeFiles/CMakeError.log or "
      "CMakeFiles/CMakeConfigureLog.yaml. Is ${VTK_DIR} for this compiler?")
  endif ()
  add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
endif ()
cmake_pop_check_state()
