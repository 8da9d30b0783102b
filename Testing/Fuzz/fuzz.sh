#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Searches for bytes that break the tick or what reads the devices' bytes, with Clang's libFuzzer and the
# address and undefined-behaviour sanitizers. The targets share the seconds.
#
# usage: Testing/Fuzz/fuzz.sh BUILD_DIR SECONDS
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir=$1
seconds=$2
# shellcheck source=../../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages clang libclang-rt-14-dev
targets=(TouchAnything TouchDescriptor TouchFalcon)
mkdir -p "$build_dir"
options=(-std=c++17 -g -ffp-contract=off "-fsanitize=fuzzer-no-link,address,undefined"
  -fno-sanitize-recover=all -I"$root/Module")
# The kernels are many: optimised they take minutes.
clang++ "${options[@]}" -O0 -c -o "$build_dir/FieldKernels.o" \
  "$root/Module/Core/Field/FieldKernelsBaseline.cxx" &
objects=()
# Without what needs a device library.
while read -r source; do
  file=$(basename "$source" .cxx)
  if [[ $file != FieldKernels* ]]; then
    while [[ $(jobs -rp | wc -l) -ge $(nproc) ]]; do
      wait -n
    done
    clang++ "${options[@]}" -O1 -c -o "$build_dir/$file.o" "$source" &
    objects+=("$build_dir/$file.o")
  fi
done < <(find "$root"/Module/{Core,Devices} -name '*.cxx' -not -path '*/Transport/Usb/*' -not -name '*Driver.cxx' \
  -not -name '*Kind.cxx' -not -name 'Hid[DP]*.cxx' -not -name 'FalconRounds.cxx' -not -name 'FalconSerial.cxx')
# One after the other, so that a failure is seen.
for job in $(jobs -p); do
  wait "$job"
done
# Rounded up: no seconds would be without an end.
share=$(((seconds + ${#targets[@]} - 1) / ${#targets[@]}))
for target in "${targets[@]}"; do
  mkdir -p "$build_dir/corpus-$target"
  clang++ "${options[@]}" -fsanitize=fuzzer -O1 -DVOLUME_HAPTICS_FUZZ_TARGET="$target" \
    -o "$build_dir/$target" "${objects[@]}" "$build_dir/FieldKernels.o" \
    "$root/Testing/Fuzz/LibFuzzer.cxx" "$root/Testing/Fuzz/$target.cxx"
  "$build_dir/$target" -max_len=6000 -timeout=10 -max_total_time="$share" \
    -print_final_stats=1 "$build_dir/corpus-$target"
done
