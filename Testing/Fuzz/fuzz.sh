#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Searches for bytes that break the tick, or the code that reads devices' bytes or files. Uses Clang's libFuzzer with
# the address and undefined-behaviour sanitizers.
#
# usage: Testing/Fuzz/fuzz.sh build BUILD_DIR [-O0]         # -O0: builds in half the time, searches at a third of the pace
#        Testing/Fuzz/fuzz.sh search BUILD_DIR SECONDS      # all targets together search for SECONDS
set -euo pipefail

step=${1:-}
case $step in
  build | search) ;;
  -h | --help) sed -n '5,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
  *) echo "$0: unknown step $step; try --help" >&2; exit 2 ;;
esac
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir=$2
optimisation=${3:--O1} # of a build
# Collect the targets, which are the functions in the headers.
mapfile -t readers < <(sed -n 's/^void \(Touch[A-Za-z]*\)(.*/\1/p' "$root/Testing/Fuzz/TouchFiles.h")
mapfile -t plain < <(find "$root/Testing/Fuzz" -name 'Touch*.h' -not -name TouchFiles.h -printf '%f\n' |
  sed 's/\.h$//' | sort)
targets=("${plain[@]}" "${readers[@]}")

# Run all targets in parallel. At the end, print the result of each target, and fail if one of them failed.
if [ "$step" = search ]; then
  processes=()
  for target in "${targets[@]}"; do
    mkdir -p "$build_dir/corpus-$target"
    program=$build_dir/$target
    seeds=$build_dir/formats/seeds/$target # exists for the targets that read files
    [ -e "$program" ] || program=$build_dir/readers/bin/$target
    [ -d "$seeds" ] || seeds=
    longest=60000
    [ "$target" != TouchHaply ] || longest=1048576 # length of the longest message that is accepted
    # Limit the size of an allocation, because a reader must refuse data that announce more bytes than they have. Leaks
    # are not reported, because VTK's readers leak after some errors.
    ASAN_OPTIONS=detect_leaks=0 "$program" -max_len="$longest" -timeout=10 -max_total_time="$3" -malloc_limit_mb=300 \
      -print_final_stats=1 "$build_dir/corpus-$target" ${seeds:+"$seeds"} > "$build_dir/$target.log" 2>&1 &
    processes+=($!)
  done
  status=0
  for index in "${!targets[@]}"; do
    wait "${processes[$index]}" || status=$?
    cat "$build_dir/${targets[$index]}.log"
  done
  exit $status
fi

# shellcheck source=../../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages clang nlohmann-json3-dev
require_packages "libclang-rt-$(clang -dumpversion | cut -d. -f1)-dev"
mkdir -p "$build_dir"
options=(-std=c++17 -g -ffp-contract=off "-fsanitize=fuzzer-no-link,address,undefined"
  -fno-sanitize-recover=all -I"$root/Module")
# Compile the many kernels without optimisation, which would take minutes.
clang++ "${options[@]}" -O0 -c -o "$build_dir/FieldKernels.o" \
  "$root/Module/Core/Field/Kernels/FieldKernelsBaseline.cxx" &
objects=()
# Compile Core, Devices and the files in labels.txt, except for sources that need a device library or VTK.
while read -r source; do
  file=$(basename "$source" .cxx)
  if [[ $file != FieldKernels* ]]; then
    while [[ $(jobs -rp | wc -l) -ge $(nproc) ]]; do
      wait -n
    done
    clang++ "${options[@]}" "$optimisation" -c -o "$build_dir/$file.o" "$source" &
    objects+=("$build_dir/$file.o")
  fi
done < <(sed "s|^|$root/Module/VTK/|" "$root/Testing/Fuzz/labels.txt"
  find "$root"/Module/{Core,Devices} -name '*.cxx' -not -path '*/Transport/Usb/*' -not -path '*/WebSocket/*' -not -name '*Driver.cxx' \
  \( -name XrKind.cxx -o -not -name '*Kind.cxx' \) -not -name DeviceRegistry.cxx -not -name ReaderProcess.cxx -not -name 'HaplyService.cxx' -not -name 'Hid[DP]*.cxx' -not -name 'FalconRounds.cxx' -not -name 'FalconSerial.cxx' \
  -not -name VibrationKinds.cxx -not -name VibrationDevice.cxx -not -path '*/Vibration/*Service.cxx')
"$root/Testing/Data/Formats/formats.sh" "$build_dir" seeds
# Build the targets that read files, including those that use VTK's readers.
cmake -S "$root" -B "$build_dir/readers" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O0 -DCMAKE_UNITY_BUILD=ON \
  -DBUILD_TESTING=OFF -DVolumeHaptics_WRAP_PYTHON=OFF -DVolumeHaptics_BUILD_TOOLS=OFF -DVolumeHaptics_USE_RENDERING=OFF \
  -DVolumeHaptics_BUILD_FUZZERS=ON "-DVolumeHaptics_COMPILER_CACHE=$(command -v ccache || true)" > "$build_dir/readers.log"
cmake --build "$build_dir/readers" --target "${readers[@]}" >> "$build_dir/readers.log" || {
  tail -50 "$build_dir/readers.log"
  exit 1
}
# Wait for each job, so that the failure of any job counts.
for job in $(jobs -p); do
  wait "$job"
done
for target in "${plain[@]}"; do
  clang++ "${options[@]}" -fsanitize=fuzzer "$optimisation" -DVOLUME_HAPTICS_FUZZ_TARGET="$target" \
    -o "$build_dir/$target" "${objects[@]}" "$build_dir/FieldKernels.o" \
    "$root/Testing/Fuzz/LibFuzzer.cxx" "$root/Testing/Fuzz/$target.cxx"
done
