#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs what is missing, builds, and runs the tests.
#
# usage: Testing/run.sh [--full] [BUILD_DIR]
#
# Without --full, there is a short form of the sanitizer runs and of the fuzzer, benchmarks are built and not run,
# there is no analyzer of clang-tidy, and tests with the label "full" are left out, which are slow for what they tell;
# with it, all C++ tests and the calls in any order run under the address and undefined-behaviour sanitizers, those of
# the device, the scene, the servo and several paths also under the thread sanitizer, the fuzzer searches for five
# minutes, the benchmarks print their ratios, and the evaluation its whole table.
#
# Without --full, it ends within 20 minutes: on a machine that is so slow that the wheel, ParaView's plugin,
# clang-tidy, the site, the fuzzer, or the sanitizers on more than the servo and its safety stage would not end by then,
# it says loudly that it leaves them out. Where even the servo under the sanitizers would take longer than 22 minutes, or
# the tests longer than 24, it leaves out the former, then all tests but the quick ones, as loudly.
#
# Tests of screens and packages wait, too: while they run, all that comes later is built.
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
left_out='device|full' # labels of tests that ran before, or do not run
left_out_of_device=full
optimised=(-DCMAKE_CXX_FLAGS_RELEASE=-O1\ -DNDEBUG) # takes two thirds of the time of -O3 to compile
tidy=tidy
fuzz_options=-O0
# Unity builds compile in half the time. With --full, all sources are also compiled as users do, one by one.
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
# Tests always render off to the side, whether or not there is a display. A live servo cuts the force off, as it must,
# when the machine stands still for 30 ms: if only tests fail that may have one, they are run once more, alone.
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
# Keeps what the tests wrote that failed just now, for the end of this run.
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
# Runs a command beside the following, in the time that this leaves over, once the one that was started before it has
# ended: a group of processes that ends with this one.
# All that it needs of Debian is installed before: there is one dpkg, and sudo could not ask for a password.
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
# Waits for what was started, tells what it wrote, and returns its status.
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
# Whether a run that goes on for so many seconds has ended by then. With --full there is time enough.
ends_by()
{
  [ $full = yes ] || [ $((SECONDS + $2)) -lt $(($1 * 60)) ]
}

# usage: fits PERCENT NAME
# Whether a part of this run ends before 19 minutes are over, and plans it if so. PERCENT is its time as a share of that
# of the first build, which tells how fast the machine is.
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

# The plugin needs Core and Devices as the build of the tests has them. The files of its unity build have the same paths
# in its folder as those of the tests in theirs.
export CCACHE_DIR=${CCACHE_DIR:-$build_dir-cache} CCACHE_BASEDIR=${CCACHE_BASEDIR:-$(dirname "$build_dir")}
cache=-DVolumeHaptics_COMPILER_CACHE=$(command -v ccache)

plugin_dir=$(dirname "$build_dir")/paraview

# The plugin in ParaView, whose traces are compared with those of the build in $build_dir.
build_paraview()
{
  local paraview
  paraview=$(echo "$plugin_dir-prefix"/usr/lib/*/cmake/paraview-*)
  export PATH=$plugin_dir-prefix/usr/bin:$PATH PYTHONPATH=$plugin_dir-prefix/usr/lib/python3/dist-packages
  build paraview "$plugin_dir" all -DParaView_DIR="$paraview" -DVolumeHaptics_REFERENCE_BUILD="$build_dir" "$cache"
}

# With less optimisation it compiles in half the time, but GCC then warns of a variable that is set.
build_wheel()
{
  if [ "$full" = no ]; then
    export SKBUILD_CMAKE_DEFINE="CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
    set -- -Wno-maybe-uninitialized
  fi
  CXXFLAGS="-Wall -Wextra -Werror $*" "$root/CMake/wheel/build.sh" "$wheel_dir" /usr/bin/python3
}

# The Qt of this Debian's ParaView: 6 from Debian 13 on.
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
# Tests with a device in real time run alone. Their failures are printed at the end, too.
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
sanitizer_seconds=$((build_seconds * 70 / 100)) # of the servo alone
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

# The servo with its safety stage and force gate runs under the sanitizers before anything else does.
loop_tests=VolumeHapticsLoopTests
without_services=-DVolumeHaptics_USE_BEAST=OFF # which none of the tests meets that run under sanitizers
sanitized='^VolumeHaptics[.]Core[.]Servo'
# Hundreds of simulated hands, and long walks through flows: these tests run no code that others do not run here, too.
# Loops that take half a minute under the thread sanitizer; with --full they run there, too.
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

# Some of the others wait, too.
echo "== Tests"
test_seconds=$SECONDS
run_tests "$build_dir" "$((2 * jobs))" "${chosen[@]}" || status=$?
test_seconds=$((SECONDS - test_seconds))

# usage: still_fits PERCENT NAME
# Whether tests end before 23 minutes are over, whatever was planned. PERCENT is their time as a share of that of the
# tests above.
still_fits()
{
  ends_by 23 $((test_seconds * $1 / 100)) && return
  skip "$2"
  return 1
}

# usage: test_sanitized
# Runs the tests with the sanitizers, whose builds are under way.
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
    # Not VTK.Endings: its tests fork, which the thread sanitizer can't follow in a process with threads.
    run_tests "$build_dir-thread" "$jobs" \
      -R '^VolumeHaptics[.](Core[.]Servo|VTK[.](Base|Device|Filter[.]FilterPaths|Regions|Scene|Setup)[.])' ||
      status=$?
  else
    # Run at most as many tests as there are processors: a loop that is made to wait for long repeats what it tests.
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
