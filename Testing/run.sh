#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs what is missing, builds everything and runs every test.
#
# usage: Testing/run.sh [--full] [BUILD_DIR]
#
# Without --full, a short form of the sanitizer runs and of the fuzzer precedes the tests; with it, all C++
# tests and the calls in any order run under the address and undefined-behaviour sanitizers, those of the device,
# the scene and the servo also under the thread sanitizer, the fuzzer searches for ten minutes, the benchmarks
# print their ratios, and the evaluation its whole table.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
full=no
build_dir=$root/build/test
for argument in "$@"; do
  case $argument in
    --full) full=yes ;;
    -h | --help) sed -n '5,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
    -*) echo "$0: unknown option $argument; try --help" >&2; exit 2 ;;
    *) build_dir=$argument ;;
  esac
done

# shellcheck source=../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
# shellcheck source=../Data/head-ct.sh
source "$root/Data/head-ct.sh"
require_packages cmake ninja-build g++ libvtk9-dev python3-vtk9 python3-numpy xvfb xauth \
  libgl1-mesa-dri libgtest-dev libbenchmark-dev pkg-config libusb-1.0-0-dev libhidapi-dev \
  libumockdev-dev umockdev python3-pytest openbox xdotool wmctrl x11-utils \
  python3-venv python3-dev libgl-dev debian-archive-keyring

jobs=$(nproc)
wheel_dir=$(dirname "$build_dir")/wheel

# usage: run_tests BUILD_DIR JOBS [OPTION OF CTEST...]
# Tests always render off to the side, whether or not there is a display. A live servo cuts the force off, as it must,
# when the machine stands still for 30 ms: if only tests of one fail, they are run once more, alone.
run_tests()
{
  local live='^[0-9]+:(VolumeHaptics[.](Applications|Core[.]ServoLoop|Devices[.]Emulated|ParaView|VTK[.](Charts|Emulated|'
  live+='Endings|Recording|Scene|Session|Setup))[.]|VTK::VolumeHapticsCxx-TestTouch)'
  local on=(--test-dir "$1" --output-on-failure --no-tests=error)
  with_own_screen ctest "${on[@]}" -j "$2" "${@:3}" && return
  if grep -vqE "$live" "$1/Testing/Temporary/LastTestsFailed.log"; then
    return 1
  fi
  echo "== Once more, alone: tests of a live servo, on a machine that may have stood still"
  with_own_screen ctest "${on[@]}" -j 1 --rerun-failed
}

# The plugin in ParaView, whose traces are compared with those of the build in $build_dir.
test_paraview()
{
  local plugin_dir prefix paraview
  plugin_dir=$(dirname "$build_dir")/paraview
  prefix=$plugin_dir-prefix
  echo "== ParaView's plugin in $plugin_dir"
  if ! require_packages paraview paraview-dev mpi-default-bin mpi-default-dev libdouble-conversion-dev \
    libx11-dev libxcursor-dev libfreetype-dev libglew-dev libgl-dev libopengl-dev \
    qtbase5-dev qttools5-dev libqt5svg5-dev libqt5opengl5-dev ||
    ! "$root/Plugin/paraview-prefix.sh" "$prefix"; then
    echo "!!!! SKIPPED: ParaView could not be installed, so its plugin was neither built nor tested !!!!" >&2
    return 0
  fi
  get_head_ct "$root/build/explore/data" ||
    echo "!!!! SKIPPED: no head CT, so traces are compared on the project's own volumes only !!!!" >&2
  paraview=$(echo "$prefix"/usr/lib/*/cmake/paraview-*)
  PATH=$prefix/usr/bin:$PATH PYTHONPATH=$prefix/usr/lib/python3/dist-packages \
    cmake -S "$root" --preset paraview -B "$plugin_dir" \
    -DParaView_DIR="$paraview" -DVolumeHaptics_REFERENCE_BUILD="$build_dir"
  cmake --build "$plugin_dir" -j "$jobs"
  run_tests "$plugin_dir" "$((2 * jobs))" -L '^paraview$'
  grep -h 'round trip' "$plugin_dir/Testing/Temporary/LastTest.log" || true
}

# The wheel takes a minute of waiting for packages, which the other builds fill: it is built beside them, in a group of
# processes that ends with this one. All that it needs of Debian is installed above, since there is one dpkg.
start_wheel()
{
  echo "== The wheel in $wheel_dir, beside the following"
  mkdir -p "$wheel_dir"
  # Unnamed types of one file look like a header's if several are compiled at once.
  CXXFLAGS="-Wall -Wextra -Werror -Wno-subobject-linkage" \
    setsid "$root/CMake/wheel/build.sh" "$wheel_dir" /usr/bin/python3 > "$wheel_dir/build.log" 2>&1 &
  wheel=$!
  trap 'kill -- -"$wheel" 2> /dev/null || true' EXIT
}

wait_for_wheel()
{
  local status=0
  echo "== The wheel in $wheel_dir"
  wait "$wheel" || status=$?
  trap - EXIT
  cat "$wheel_dir/build.log"
  if [ $status -eq 3 ]; then
    echo "!!!! SKIPPED: the wheel could not be built for want of the above, so it is not tested !!!!" >&2
    return 0
  fi
  return $status
}

start_wheel
"$root/Testing/lint.sh"

echo "== Building in $build_dir"
cmake -S "$root" --preset release -B "$build_dir" -DVolumeHaptics_WHEEL_FOLDER="$wheel_dir"
cmake --build "$build_dir" -j "$jobs"

echo "== Building with the address and undefined-behaviour sanitizers in $build_dir-sanitize"
cmake -S "$root" --preset asan -B "$build_dir-sanitize" \
  -DVolumeHaptics_WRAP_PYTHON="$([ $full = yes ] && echo ON || echo OFF)"
if [ $full = yes ]; then
  cmake --build "$build_dir-sanitize" -j "$jobs"
  run_tests "$build_dir-sanitize" "$jobs" -LE package
else
  cmake --build "$build_dir-sanitize" -j "$jobs" --target VolumeHapticsSanitizerTests
  run_tests "$build_dir-sanitize" "$jobs" -R '^VolumeHaptics[.](Core|Devices)[.]'
fi

echo "== Building with the thread sanitizer in $build_dir-thread"
cmake -S "$root" --preset tsan -B "$build_dir-thread"
export TSAN_OPTIONS=ignore_noninstrumented_modules=1 VTK_SMP_BACKEND_IN_USE=Sequential
if [ $full = yes ]; then
  cmake --build "$build_dir-thread" -j "$jobs" --target VolumeHapticsThreadTests
  # Not VTK.Endings: its tests fork, which the thread sanitizer can't follow in a process with threads.
  run_tests "$build_dir-thread" "$jobs" -R '^VolumeHaptics[.](Core[.]Servo|VTK[.](Charts|Recording|Scene|Session|Setup)[.])'
else
  cmake --build "$build_dir-thread" -j "$jobs" --target VolumeHapticsLoopTests
  run_tests "$build_dir-thread" "$jobs" -R '^VolumeHaptics[.]Core[.]Servo'
fi
unset TSAN_OPTIONS VTK_SMP_BACKEND_IN_USE

echo "== Fuzzing"
"$root/Testing/Fuzz/fuzz.sh" "$build_dir-fuzz" "$([ $full = yes ] && echo 600 || echo 20)"

if [ $full = yes ]; then
  echo "== Benchmarks"
  "$build_dir/bin/volumehaptics-benchmark"
  "$build_dir/bin/volumehaptics-servo-benchmark"
  echo "== Evaluation"
  with_own_screen "$build_dir/bin/volumehaptics-evaluation" --output "$build_dir/evaluation"
fi

test_paraview
wait_for_wheel

# Those with a device in real time wait more than they compute; of the others some wait, too.
echo "== Tests"
status=0
run_tests "$build_dir" "$((4 * jobs))" -L '^device$' || status=$?
run_tests "$build_dir" "$((2 * jobs))" -LE '^device$' || status=$?
exit $status
