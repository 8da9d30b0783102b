#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Searches for bytes that break the tick, and for bytes from a Falcon that break its codec, with Clang's
# libFuzzer and the address and undefined-behaviour sanitizers. The codec gets a quarter of the time.
#
# usage: Testing/Fuzz/fuzz.sh BUILD_DIR SECONDS
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir=$1
seconds=$2
# shellcheck source=../../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages clang libclang-rt-14-dev
mkdir -p "$build_dir"/corpus{,-falcon}
options=(-std=c++17 -g -ffp-contract=off -fsanitize=fuzzer-no-link,address,undefined
  -fno-sanitize-recover=all -I"$root/Module/Core")
# The kernels are many: optimised they take minutes.
clang++ "${options[@]}" -O0 -c -o "$build_dir/FieldKernels.o" \
  "$root/Module/Core/FieldKernelsBaseline.cxx" &
objects=()
for source in "$root"/Module/Core/*.cxx; do
  file=$(basename "$source" .cxx)
  if [[ $file != FieldKernels* ]]; then
    clang++ "${options[@]}" -O1 -c -o "$build_dir/$file.o" "$source"
    objects+=("$build_dir/$file.o")
  fi
done
wait
clang++ "${options[@]}" -fsanitize=fuzzer -O1 -o "$build_dir/touch-anything" "${objects[@]}" \
  "$build_dir/FieldKernels.o" "$root"/Testing/Fuzz/{LibFuzzer,TouchAnything}.cxx
devices=$root/Module/Devices
clang++ "${options[@]}" -fsanitize=fuzzer -O1 -I"$devices" -o "$build_dir/touch-falcon" \
  "$devices"/Falcon{Homing,Kinematics,Loader,Protocol,Stream}.cxx "$build_dir/SafetyStage.o" \
  "$root"/Testing/Fuzz/{LibFuzzerFalcon,TouchFalcon}.cxx
# Rounded up: no seconds would be without an end.
"$build_dir/touch-falcon" -max_len=6000 -timeout=10 -max_total_time=$(( (seconds + 3) / 4 )) \
  -print_final_stats=1 "$build_dir/corpus-falcon"
"$build_dir/touch-anything" -max_len=6000 -timeout=10 -max_total_time=$(( (3 * seconds + 3) / 4 )) \
  -print_final_stats=1 "$build_dir/corpus"
