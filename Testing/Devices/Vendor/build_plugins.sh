#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds Examples/Vendor as users do, against stand-ins for the SDKs.
# usage: build_plugins.sh SOURCE_DIR BINARY_DIR
set -euo pipefail

source_dir=$1
binary_dir=$2
work=$binary_dir/one-line
rm -rf "$work"
for sdk in ForceDimension OpenHaptics; do
  mkdir -p "$work/$sdk"
  ln -s "$source_dir/Testing/Emulators/$sdk/include" "$work/$sdk/include"
  ln -s "$binary_dir/$sdk/lib" "$work/$sdk/lib"
done

cmake -S "$source_dir/Examples/Vendor" -B "$work/plugins" \
  -DFORCE_DIMENSION_SDK="$work/ForceDimension" -DOPENHAPTICS_SDK="$work/OpenHaptics" >"$work/configure.log"
cmake --build "$work/plugins" >"$work/build.log"
for plugin in forcedimension openhaptics; do
  nm -D --defined-only "$work/plugins/libvolumehaptics-$plugin.so" >"$work/symbols.txt"
  grep -q VolumeHapticsVendorGetPlugin "$work/symbols.txt" ||
    { echo "libvolumehaptics-$plugin.so is no plug-in" >&2; exit 1; }
done

# Without an SDK, the error names the missing option.
if cmake -S "$source_dir/Examples/Vendor" -B "$work/none" >/dev/null 2>"$work/none.txt"; then
  echo "a build without an SDK was configured" >&2
  exit 1
fi
grep -q 'FORCE_DIMENSION_SDK' "$work/none.txt"
