#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Configures other projects that use the sources by add_subdirectory() or the package by find_package(). Where a project
# has a mistake, looks for the cure in CMake's output.
# usage: projects.sh SOURCE_DIR BUILD_DIR
set -euo pipefail

source_dir=$1
build_dir=$2
work=$build_dir/Testing/Package/projects
rm -rf "$work"
mkdir -p "$work"
touch "$work/begin"

# usage: configure NAME LANGUAGES LINE...
configure()
{
  mkdir "$work/$1"
  printf '%s\n' "cmake_minimum_required(VERSION 3.19)" "project(Other LANGUAGES $2)" "add_library(other INTERFACE)" "${@:3}" > "$work/$1/CMakeLists.txt"
  cmake -S "$work/$1" -B "$work/$1/build" -G Ninja -DCMAKE_PREFIX_PATH="$build_dir" > "$work/$1.log" 2>&1
}

# usage: accept NAME LANGUAGES LINE...
accept()
{
  configure "$@" || { cat "$work/$1.log"; echo "$1: refused"; exit 1; }
}

# usage: refuse TEXT NAME LANGUAGES LINE...
refuse()
{
  if configure "${@:2}"; then
    echo "$2: accepted"
    exit 1
  fi
  # Join the lines first, because CMake wraps its messages.
  tr -s ' \n' ' ' < "$work/$2.log" | grep -F "$1" > /dev/null || { cat "$work/$2.log"; echo "$2: nothing like '$1'"; exit 1; }
}

# usage: refuse_itself TEXT OPTION...
# Configures the sources alone, and looks for the text in CMake's output.
refuse_itself()
{
  local log=$work/itself.log
  if cmake -S "$source_dir" -B "$work/itself" -G Ninja -DVolumeHaptics_WRAP_PYTHON=OFF "${@:2}" > "$log" 2>&1; then
    echo "$1: accepted"
    exit 1
  fi
  tr -s ' \n' ' ' < "$log" | grep -F "$1" > /dev/null || { cat "$log"; echo "nothing like '$1'"; exit 1; }
  rm -rf "$work/itself"
}

folder="add_subdirectory(\"$source_dir\" haptics)"
link="target_link_libraries(other INTERFACE VTK::VolumeHaptics)"
accept folder "C CXX" "$folder" "$link"
accept folder_after_vtk "C CXX" "find_package(VTK REQUIRED COMPONENTS CommonCore)" "$folder" "$link"
accept package_after_vtk "C CXX" "find_package(VTK REQUIRED COMPONENTS CommonCore)" \
  "find_package(VolumeHaptics REQUIRED)" "$link"
refuse "VolumeHaptics has no components, but Servo was asked for" components "C CXX" \
  "find_package(VolumeHaptics REQUIRED COMPONENTS Servo)"
refuse "enable C, by project(NAME LANGUAGES C CXX)" no_c CXX "find_package(VolumeHaptics REQUIRED)"

# VTK without the component or the header with which charts are drawn. VTK's own package takes a component whose variable is
# off for missing. A copy of that package, with links to all of VTK's headers but one, is a VTK that was installed without it.
cure="sudo apt-get install libvtk9-dev"
vtk=$(sed -n 's/^VTK_DIR:PATH=//p' "$build_dir/CMakeCache.txt")
refuse_itself "lacks the components ChartsCore, RenderingContext2D" -DVTK_DIR="$vtk" -DBUILD_TESTING=OFF \
  -DVTK_RenderingContext2D_FOUND=OFF
refuse_itself "$cure" -DVTK_DIR="$vtk" -DVTK_RenderingContext2D_FOUND=OFF
refuse_itself "VTK was not found. On Debian and Ubuntu: $cure" -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
refuse "lacks the components ChartsCore, RenderingContext2D" component "C CXX" "set(VTK_RenderingContext2D_FOUND OFF)" \
  "find_package(VolumeHaptics REQUIRED)"
prefix=${vtk%/lib/*}
if [ -d "$prefix/include/vtk-9.1" ]; then # Debian 12's layout
  copy=$work/prefix
  mkdir -p "$copy/include/vtk-9.1" "$(dirname "$copy${vtk#"$prefix"}")"
  cp -r "$vtk" "$copy${vtk#"$prefix"}"
  cp -rs "$prefix"/include/vtk-9.1/. "$copy/include/vtk-9.1"
  rm "$copy/include/vtk-9.1/vtkRenderingContext2DModule.h"
  ln -s "$prefix/bin" "$copy/bin"
  ln -s "$prefix/lib/python3" "$copy/lib/python3"
  for file in "$(dirname "$(dirname "$vtk")")"/libvtk*; do
    ln -s "$file" "$copy$(dirname "${file#"$prefix"}")"
  done
  refuse_itself "lacks the header vtkRenderingContext2DModule.h of the component RenderingContext2D" \
    -DVTK_DIR="$copy${vtk#"$prefix"}"
fi

# The source folder must stay unchanged, and the other project must get no unexpected settings.
written=$(find "$source_dir" -newer "$work/begin" -type f -not -path '*/.git/*' -not -path '*cache*' \
  -not -path "$source_dir/build/*" -not -path "$build_dir/*")
if [ -n "$written" ]; then
  echo "Written into the sources: $written"
  exit 1
fi
if grep -E '^(CMAKE_BUILD_TYPE:[A-Z]*=.|BUILD_TESTING:)' "$work/folder/build/CMakeCache.txt"; then
  echo "Settings of the whole project were changed"
  exit 1
fi
