#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the module inside another project's vtk_module_build(), as VTK/Remote does. Leaves out the libraries of
# devices, which such a project may not want.
# usage: superproject.sh SOURCE_DIR BUILD_DIR
set -euo pipefail

work=$2/Testing/Package/superproject
rm -rf "$work"
mkdir -p "$work"
# Link this repository as a remote module: a folder in the other project's source tree.
cp -r "$1/Testing/Package/Superproject" "$work/source"
ln -s "$1" "$work/source/Remote"
cmake -S "$work/source" -B "$work/build" -G Ninja -DCMAKE_UNITY_BUILD=ON \
  -DCMAKE_CXX_FLAGS_DEBUG= -DVolumeHaptics_USE_LIBUSB=OFF -DVolumeHaptics_USE_HIDAPI=OFF \
  -DVolumeHaptics_USE_BEAST=OFF >"$work/configure.log"
cmake --build "$work/build" >"$work/build.log"
"$work/build/bin/superproject-check"
