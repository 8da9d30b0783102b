#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the module inside another project's vtk_module_build(), the way VTK/Remote does.
# usage: superproject.sh SOURCE_DIR BUILD_DIR
set -euo pipefail

work=$2/Testing/Package/superproject
rm -rf "$work"
mkdir -p "$work"
cmake -S "$1/Testing/Package/Superproject" -B "$work" -G Ninja -DVolumeHaptics_ROOT_DIR="$1" \
  >"$work.configure.log"
cmake --build "$work" >"$work.build.log"
"$work/bin/superproject-check"
