#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs what is missing, builds, and runs the tests.
#
# usage: Testing/run.sh [--full] [BUILD_DIR]
#
# Without --full, the sanitizer runs and the fuzzer are short, benchmarks are built and not run, and clang-tidy runs
# without its analyzer. Tests with the label "full" are left out, which are slow for what they tell. With --full, all
# C++ tests and the calls in any order run under the address and undefined-behaviour sanitizers, and those of the
# device, the scene, the servo and several paths also under the thread sanitizer. The fuzzer searches for five minutes,
# the benchmarks print their ratios, and the evaluation prints its whole table.
#
# Without --full, a run ends within 20 minutes. On a slow machine, it leaves out what would not end by then, and says so
# loudly: the wheel, ParaView's plugin, clang-tidy, the site, the fuzzer, and the sanitizers except on the servo and its
# safety stage. If even the servo under the sanitizers would take longer than 22 minutes, or the tests longer than 24,
# it leaves out all sanitizers, or all tests but the quick ones.
#
# Tests of screens and packages mostly wait. While they run, everything that comes later is built.
# shellcheck disable=SC2317 # functions that start() calls
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
full=no
build_dir=$root/build/test
for argument in "$@"; do
  case $argument in
    --full) full=yes ;;
    -h | --help) sed -n '5,20s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
    -*) echo "$0: unknown option $argument; try --help" >&2; exit 2 ;;
    *) build_dir=$argument ;;
  esac
done

# shellcheck source=../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
# shellcheck source=../Data/head-ct.sh
source "$root/Data/head-ct.sh"
require_packages cmake ninja-build g++ libvtk9-dev python3-vtk9 python3-numpy xvfb xauth \
  libgl1-mesa-dri libgtest-dev libbenchmark-dev pkg-config libusb-1.0-0-dev libhidapi-dev ccache libboost-dev nlohmann-json3-dev \
  libpulse-dev pulseaudio libumockdev-dev umockdev python3-pytest python3-zarr hdf5-tools openbox xdotool wmctrl x11-utils \
  tesseract-ocr imagemagick libgdcm-dev libblosc-dev libzstd-dev libvtk9-qt-dev chromium chromium-driver \
  python3-venv python3-dev python3-wxgtk4.0 doxygen libgl-dev debian-archive-keyring clang dbus libdbus-1-3 python3-gi
require_packages "libclang-rt-$(clang -dumpversion | cut -d. -f1)-dev"
[[ $(cat /etc/debian_version) != 12.* ]] || require_packages clang-tidy-14 clang-format-14 codespell # elsewhere from PyPI
[ $full = no ] || require_packages python3-tk invesalius f3d # programs of Testing/Hosts
jobs=$(nproc)
left_out='device|full' # labels of tests that ran before, or that do not run
left_out_of_device=full
optimised=(-DCMAKE_CXX_FLAGS_RELEASE=-O1\ -DNDEBUG) # takes two thirds of the time of -O3 to compile
tidy=tidy
fuzz_options=-O0
# Unity builds compile in half the time. With --full, all sources are also compiled individually, as users do.
unity=ON
if [ $full = yes ]; then
  unity=OFF
  left_out=device
  left_out_of_device=none
  optimised=()
  tidy="tidy analyze"
  fuzz_options=-O1
fi
wheel_dir=$(dirname "$build_dir")/wheel

# usage: run_tests BUILD_DIR JOBS [OPTION OF CTEST...]
# Runs tests. They render off the screen, with or without a display. When the machine stands still for 30 ms, a live
# servo must cut the force. So if only tests fail to which this may happen, they run once more, alone.
run_tests()
{
  local on=(--test-dir "$1" --output-on-failure --no-tests=error)
  with_own_screen ctest "${on[@]}" -j "$2" "${@:3}" && return
  keep_failures "$1"
  if cut -d: -f2- "$1/Testing/Temporary/LastTestsFailed.log" | grep -vxF "$(list_live_tests "$1")"; then
    return 1
  fi
  echo "== Once more, alone: tests of a live servo, on a machine that may have stood still"
  with_own_screen ctest "${on[@]}" -j 1 --rerun-failed && return
  keep_failures "$1"
  return 1
}

# usage: list_live_tests BUILD_DIR
list_live_tests()
{
  ctest --test-dir "$1" -N -L '^(device|scene|paraview|wheel)$' | sed -n 's/^ *Test *#[0-9]*: //p'
}

# usage: keep_failures BUILD_DIR
# Keeps the output of the tests that have just failed, for the end of this run.
failures=$build_dir-failures.log
keep_failures()
{
  local name
  while read -r name; do
    echo "== Failed, in $1: $name"
    awk -v begin="Testing: $name" '/^[0-9]+\/[0-9]+ Testing: / { on = substr($0, index($0, "Testing: ")) == begin } on' \
      "$1/Testing/Temporary/LastTest.log" | tail -n 60
  done < <(cut -d: -f2- "$1/Testing/Temporary/LastTestsFailed.log") >> "$failures"
}

declare -A beside
stop_all()
{
  local group
  for group in "${beside[@]}"; do
    kill -- -"$group" 2> /dev/null || true
  done
  if [ -s "$failures" ]; then
    echo "== All that failed, be it for once"
    cat "$failures"
  fi
}
trap stop_all EXIT
rm -f "$failures"

# usage: start NAME COMMAND [ARGUMENT...]
# Runs a command in the background, with low priority, once the command that was started before it has ended. Its
# processes end with this script. Debian's packages that it needs must be installed before: there is only one dpkg, and
# sudo could not ask for a password.
last_started=
start()
{
  echo "== Beside the following: $1"
  mkdir -p "$build_dir"
  set -m
  (
    renice -n 15 -p "$BASHPID" > /dev/null
    [ -z "$last_started" ] || tail --pid="$last_started" -f /dev/null
    set -e
    "${@:2}"
  ) < /dev/null > "$build_dir-$1.log" 2>&1 &
  set +m
  last_started=$!
  beside[$1]=$last_started
}

# usage: finish NAME
# Waits for a command that was started, prints its output, and returns its status.
finish()
{
  local status=0
  wait "${beside[$1]}" || status=$?
  unset "beside[$1]"
  echo "== Was beside the above: $1"
  cat "$build_dir-$1.log"
  return $status
}

# usage: skip NAME
skip()
{
  echo "!!!! SKIPPED: $1, for which this machine is too slow: $((SECONDS / 60)) minutes are over; see --full !!!!" >&2
}

# usage: ends_by MINUTES SECONDS
# Succeeds if a step of SECONDS ends before MINUTES of this run have passed. With --full, it always succeeds.
ends_by()
{
  [ $full = yes ] || [ $((SECONDS + $2)) -lt $(($1 * 60)) ]
}

# usage: fits PERCENT NAME
# Succeeds if a step ends before 19 minutes of this run have passed, and then adds the step to the plan. PERCENT is its
# time relative to the first build, which measures the speed of this machine.
planned=0 # seconds
fits()
{
  local cost=$((build_seconds * $1 / 100))
  if ends_by 19 $((planned + cost)); then
    planned=$((planned + cost))
    return
  fi
  skip "$2"
  return 1
}

# usage: configure PRESET BUILD_DIR [OPTION OF CMAKE...]
configure()
{
  cmake -S "$root" --preset "$1" -B "$2" "${@:3}"
}

# usage: build PRESET BUILD_DIR [TARGET [OPTION OF CMAKE...]]
build()
{
  configure "$1" "$2" "${@:4}"
  cmake --build "$2" -j "$jobs" --target "${3:-all}"
}

# The plugin needs Core and Devices from the tests' build. Both unity builds have the same relative paths, so that they
# share the compiler cache.
export CCACHE_DIR=${CCACHE_DIR:-$build_dir-cache} CCACHE_BASEDIR=${CCACHE_BASEDIR:-$(dirname "$build_dir")}
cache=-DVolumeHaptics_COMPILER_CACHE=$(command -v ccache)

plugin_dir=$(dirname "$build_dir")/paraview

# Builds the plugin in ParaView. Its traces are compared with those of the build in $build_dir.
build_paraview()
{
  local paraview
  paraview=$(echo "$plugin_dir-prefix"/usr/lib/*/cmake/paraview-*)
  export PATH=$plugin_dir-prefix/usr/bin:$PATH PYTHONPATH=$plugin_dir-prefix/usr/lib/python3/dist-packages
  build paraview "$plugin_dir" all -DParaView_DIR="$paraview" -DVolumeHaptics_REFERENCE_BUILD="$build_dir" "$cache"
}

# Builds the wheel. With less optimisation, it compiles in half the time, but GCC then warns about a variable that is in
# fact set.
build_wheel()
{
  if [ "$full" = no ]; then
    export SKBUILD_CMAKE_DEFINE="CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
    set -- -Wno-maybe-uninitialized
  fi
  CXXFLAGS="-Wall -Wextra -Werror $*" "$root/CMake/wheel/build.sh" "$wheel_dir" /usr/bin/python3
}

# Use the Qt of this Debian's ParaView, which is Qt 6 since Debian 13.
qt=(qtbase5-dev qttools5-dev libqt5svg5-dev libqt5opengl5-dev python3-pyqt5)
if apt-cache depends paraview | grep libqt6core > /dev/null; then
  qt=(qt6-base-dev qt6-tools-dev qt6-5compat-dev libgl1-mesa-dev python3-pyqt6)
fi
paraview=yes
if require_packages paraview paraview-dev mpi-default-bin mpi-default-dev libdouble-conversion-dev \
  libx11-dev libxcursor-dev libfreetype-dev libglew-dev libgl-dev libopengl-dev "${qt[@]}" &&
  "$root/Plugin/paraview-prefix.sh" "$plugin_dir-prefix"; then
  get_head_ct "$root/build/explore/data" ||
    echo "!!!! SKIPPED: no head CT, so traces are compared on the project's own volumes only !!!!" >&2
else
  paraview=no
  echo "!!!! SKIPPED: ParaView could not be installed, so its plugin is neither built nor tested !!!!" >&2
fi
start lint "$root/Testing/lint.sh" format columns spelling python shell documents

echo "== Building in $build_dir"
build_seconds=$SECONDS
configure release "$build_dir" -DVolumeHaptics_WHEEL_FOLDER="$wheel_dir" \
  -DVolumeHaptics_BUILD_EXPLORER=ON -DVolumeHaptics_BUILD_BENCHMARKS=ON -DCMAKE_UNITY_BUILD=$unity "${optimised[@]}" "$cache"
finish lint
cmake --build "$build_dir" -j "$jobs"
build_seconds=$((SECONDS - build_seconds))
# Run the tests with a device in real time separately. Their failures are printed again at the end.
echo "== Tests with devices"
status=0
run_tests "$build_dir" "$((3 * jobs))" -L '^device$' -LE "^($left_out_of_device)\$" || status=$?

if [ $full = yes ]; then
  echo "== Benchmarks"
  "$build_dir/bin/volumehaptics-benchmark"
  "$build_dir/bin/volumehaptics-servo-benchmark"
  echo "== Evaluation"
  with_own_screen "$build_dir/bin/volumehaptics-evaluation" --output "$build_dir/evaluation"
fi

chosen=(-LE "^($left_out|wheel)\$")
test_seconds=$((build_seconds * 125 / 100))
sanitizer_seconds=$((build_seconds * 70 / 100)) # time of the servo's tests alone
sanitizers=yes
if ! ends_by 22 $((test_seconds + sanitizer_seconds)); then
  sanitizers=no
  sanitizer_seconds=0
  skip "the sanitizers"
fi
if ! ends_by 24 "$test_seconds"; then
  chosen+=(-L '^quick$')
  skip "all tests but the quick ones"
fi
planned=$((test_seconds + sanitizer_seconds))

# First build the servo with its safety stage and force gate under the sanitizers.
loop_tests=VolumeHapticsLoopTests
without_services=-DVolumeHaptics_USE_BEAST=OFF # no test under the sanitizers uses these services
sanitized='^VolumeHaptics[.]Core[.]Servo'
# $scans: hundreds of simulated hands, and long walks through flows. Other tests here run the same code. $slow_loops:
# loops that take half a minute under the thread sanitizer. With --full, both run.
slow_loops='ToolLoop[.](WhateverIsPublishedStaysWithinTheLimits|WhatIsKeptBeginsAReplay)$'
scans='(FindsNoHonestDevice|NoHonestDeviceIsCalledWrong|TheReboundIsNeverFasterThanWithoutTheStage)$'
scans+='|ModesInASwirl[.]StepByTheSpringAsFarAsTheFieldAllows/[0-9]|OfWeakFlowsAndFrontsAreWithinABoundOfTheirStrength$'
if [ $full = yes ]; then
  loop_tests=VolumeHapticsThreadTests
  without_services=
  start sanitize build asan "$build_dir-sanitize" all -DVolumeHaptics_WRAP_PYTHON=ON
elif [ $sanitizers = yes ]; then
  safety_tests=VolumeHapticsSafetyTests
  if fits 22 "the address and undefined-behaviour sanitizers, but for the servo"; then
    safety_tests=VolumeHapticsSanitizerTests
    sanitized='^VolumeHaptics[.](Core|Devices)[.]'
  fi
  start sanitize build asan "$build_dir-sanitize" $safety_tests "$without_services"
fi
[ $sanitizers = no ] || start thread build tsan "$build_dir-thread" $loop_tests $without_services
wheel=no
if fits 50 "the wheel"; then
  wheel=yes
  start wheel build_wheel
fi
if fits 15 "clang-tidy"; then
  # shellcheck disable=SC2086 # words
  start tidy "$root/Testing/lint.sh" $tidy
fi
if [ $paraview = yes ] && ! fits 100 "ParaView's plugin"; then
  paraview=no
fi
[ $paraview = no ] || start paraview build_paraview
site=no
if fits 17 "the documentation's site"; then
  site=yes
  start site "$root/Testing/lint.sh" site
fi
fuzz=no
if fits 22 "the fuzzer"; then
  fuzz=yes
  start fuzz "$root/Testing/Fuzz/fuzz.sh" build "$build_dir-fuzz" $fuzz_options
fi

# Start more jobs than processors, because some of the tests also wait.
echo "== Tests"
test_seconds=$SECONDS
run_tests "$build_dir" "$((2 * jobs))" "${chosen[@]}" || status=$?
test_seconds=$((SECONDS - test_seconds))

# usage: still_fits PERCENT NAME
# Succeeds if a step of tests ends before 23 minutes of this run have passed, whatever was planned. PERCENT is its time
# relative to the tests above.
still_fits()
{
  ends_by 23 $((test_seconds * $1 / 100)) && return
  skip "$2"
  return 1
}

# usage: test_sanitized
# Runs the tests under the sanitizers, once their builds have ended.
test_sanitized()
{
  finish sanitize
  echo "== Tests with the address and undefined-behaviour sanitizers in $build_dir-sanitize"
  if [ $full = yes ]; then
    run_tests "$build_dir-sanitize" "$jobs" -LE package || status=$?
  else
    run_tests "$build_dir-sanitize" "$((2 * jobs))" -R "$sanitized" -E "$scans" || status=$?
  fi

  finish thread
  echo "== Tests with the thread sanitizer in $build_dir-thread"
  export TSAN_OPTIONS=ignore_noninstrumented_modules=1 VTK_SMP_BACKEND_IN_USE=Sequential
  if [ $full = yes ]; then
    # Leave out VTK.Endings, whose tests fork: the thread sanitizer can't trace a fork of a process with threads.
    run_tests "$build_dir-thread" "$jobs" \
      -R '^VolumeHaptics[.](Core[.]Servo|VTK[.](Base|Device|Filter[.]FilterPaths|Regions|Scene|Setup)[.])' ||
      status=$?
  else
    # Run at most as many tests as there are processors, because a loop that is delayed repeats its test.
    run_tests "$build_dir-thread" "$jobs" -R '^VolumeHaptics[.]Core[.]Servo' -E "$slow_loops" || status=$?
  fi
  unset TSAN_OPTIONS VTK_SMP_BACKEND_IN_USE
}
[ $sanitizers = no ] || test_sanitized

if [ $wheel = yes ] && still_fits 35 "the wheel's tests"; then
  built=0
  finish wheel || built=$?
  if [ $built -eq 3 ]; then
    echo "!!!! SKIPPED: the wheel could not be built for want of the above, so it is not tested !!!!" >&2
  elif [ $built -ne 0 ]; then
    exit $built
  else
    echo "== Tests of the wheel"
    run_tests "$build_dir" "$((2 * jobs))" -L '^wheel$' -LE "^($left_out)\$" || status=$?
  fi
fi

[ $site = no ] || finish site || status=$?
if [ -n "${beside[tidy]:-}" ]; then
  finish tidy || status=$?
fi

if [ $paraview = yes ] && still_fits 40 "the tests of ParaView's plugin"; then
  finish paraview
  echo "== Tests of ParaView's plugin in $plugin_dir"
  run_tests "$plugin_dir" "$((jobs + 1))" -L '^paraview$' -LE "^($left_out)\$" || status=$?
  grep -h 'round trip' "$plugin_dir/Testing/Temporary/LastTest.log" || true
fi

if [ $fuzz = yes ] && still_fits 5 "the fuzzer's search"; then
  finish fuzz
  echo "== Fuzzing"
  "$root/Testing/Fuzz/fuzz.sh" search "$build_dir-fuzz" "$([ $full = yes ] && echo 300 || echo 10)"
fi
exit $status
