#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Cross-builds for Windows with MinGW-w64 and runs the tests under Wine. Prints the tests that can't run there, each with
# its reason, and ends with the count of passed tests.
#
#   Testing/windows.sh FOLDER
#
# FOLDER receives the build. Needs Debian's packages cmake, ninja-build, g++-mingw-w64-x86-64-posix, wine64, googletest,
# libboost-dev, nlohmann-json3-dev and pkg-config, and builds libusb and hidapi from Debian's source packages. The
# mathematics and the devices are built, with their tests; what uses VTK is not.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  '' | -h | --help) sed -n '5,13s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
mkdir -p "$1"
folder=$(cd "$1" && pwd)
prefix=$folder/prefix
build=$folder/build
settings=(-G Ninja "-DCMAKE_TOOLCHAIN_FILE=$root/CMake/windows/mingw.cmake" "-DVolumeHaptics_WINDOWS_PREFIX=$prefix"
  -DCMAKE_BUILD_TYPE=Release '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG')
wine=$(command -v wine64 || command -v wine64-stable || echo /usr/lib/wine/wine64)
export WINEPREFIX=$folder/wine WINEDEBUG=-all TEST_TMPDIR=$folder
# Pass the path of the compiler's libraries to Wine.
gcc=$(dirname "$(x86_64-w64-mingw32-g++-posix -print-file-name=libstdc++-6.dll)")
WINEPATH="Z:$gcc;Z:/usr/x86_64-w64-mingw32/lib;Z:$prefix/bin;Z:$build/bin"
export WINEPATH=${WINEPATH//\//\\}

if [ ! -e "$prefix/lib/libgtest.a" ]; then
  cmake -S /usr/src/googletest -B "$folder/googletest" "${settings[@]}" -DBUILD_GMOCK=OFF \
    "-DCMAKE_INSTALL_PREFIX=$prefix" -DCMAKE_INSTALL_LIBDIR=lib
  cmake --build "$folder/googletest" --target install
fi
# Build the libraries for USB and HID devices.
if [ ! -e "$prefix/lib/pkgconfig/libusb-1.0.pc" ]; then
  [ -d "$folder/libusb/source" ] || "$root/CMake/windows/source.sh" libusb-1.0 "$folder/libusb"
  mkdir -p "$folder/libusb/build"
  cd "$folder/libusb/build"
  ../source/configure -q --host=x86_64-w64-mingw32 CC=x86_64-w64-mingw32-gcc-posix --disable-static "--prefix=$prefix"
  make -s
  make -s install
  cd "$OLDPWD"
fi
if [ ! -e "$prefix/lib/pkgconfig/hidapi.pc" ]; then
  [ -d "$folder/hidapi/source" ] || "$root/CMake/windows/source.sh" hidapi "$folder/hidapi"
  cmake -S "$folder/hidapi/source" -B "$folder/hidapi/build" "${settings[@]}" "-DCMAKE_INSTALL_PREFIX=$prefix" \
    -DCMAKE_INSTALL_LIBDIR=lib
  cmake --build "$folder/hidapi/build" --target install
fi
# Use only the system's header-only libraries, and no other system headers.
mkdir -p "$prefix/include"
ln -sfn /usr/include/boost "$prefix/include/boost"
ln -sfn /usr/include/nlohmann "$prefix/include/nlohmann"
cmake -S "$root" -B "$build" "${settings[@]}" -DVolumeHaptics_USE_VTK=OFF -DCMAKE_UNITY_BUILD=ON -DBUILD_TESTING=ON
cmake --build "$build"

# Lists the test files that can't run under Wine: PATTERN in Testing, and the reason.
reasons=(
  'Core/Realtime/RealtimeKit|RealtimeKit is a service of Linux'
  'Core/Realtime/WatchedSleep|only Linux lets a thread wake another one on its own processor'
  'Core/Servo/Memory|only Linux tells which pages are locked'
  'Core/Servo/SampleKeeper|only Linux tells which pages are in memory'
  'Devices/Common/DeviceFork|Windows does not fork'
  'Devices/Common/DevicePriority|RealtimeKit is a service of Linux'
  'Devices/Emulated/|umockdev, which plays USB and HID devices, is of Linux'
  'Devices/Guard/|the guard is a process of Linux'
  'Devices/Haply/HaplyFault|the played service ends its connections by calls of POSIX'
  'Devices/Haply/HaplySession|the played service ends its connections by calls of POSIX'
  'Devices/Hfab/|the played board is at a pseudoterminal'
  'Devices/Pad/EvdevReader|evdev is of Linux'
  'Devices/Vendor/VendorLoader|owners, permissions and links of files are those of POSIX'
)
failed=()
while IFS= read -r file; do
  name=${file#"$root/Testing/"}
  if grep -qsF "$name" "$build/build.ninja" || grep -rqsF "$name" "$build/Testing" --include='unity_*.cxx'; then
    continue
  fi
  reason=
  for row in "${reasons[@]}"; do
    [[ $name == "${row%%|*}"* ]] && reason=${row#*|}
  done
  if [ -z "$reason" ]; then
    failed+=("$name is not built, without a reason")
  fi
  sed -nE "s/^TEST(_F|_P)?\(([A-Za-z0-9_]+), ([A-Za-z0-9_]+)\).*/Not there: \2.\3: ${reason:-no reason}/p" "$file"
done < <(find "$root/Testing/Core" "$root/Testing/Devices" -name '*Test.cxx' | sort)

# Run each suite in a separate process. Wine wakes a thread at most once a millisecond, so fast loops take long.
passed=0
mkdir -p "$folder/results"
while IFS= read -r name; do
  program=$build/bin/$name.exe
  count=0
  while IFS= read -r suite; do
    result=$folder/results/$name.${suite//\//-}txt
    timeout 900 "$wine" "$program" "--gtest_filter=$suite*" > "$result" 2>&1 < /dev/null || failed+=("$name $suite $result")
    # Print the reason for a skipped test, which is in the preceding line.
    awk '/^\[ +SKIPPED \] .* ms\)/ { print "Skipped: " $4 ": " text } { text = $0 }' "$result" | tr -d '\r'
    count=$((count + $(grep -acE '^\[       OK \] ' "$result" || true)))
  done < <("$wine" "$program" --gtest_list_tests 2>&1 | tr -d '\r' | grep -E '^[A-Za-z].*\.' | sed 's/ .*//')
  echo "$name: $count passed"
  passed=$((passed + count))
done < <(ninja -C "$build" -t targets all | sed -nE 's#^bin/([A-Za-z]+Test)[.]exe: .*#\1#p' | sort)
for text in ${failed[@]+"${failed[@]}"}; do
  echo "Failed: $text"
done
echo "$passed tests passed under $("$wine" --version)"
[ ${#failed[@]} -eq 0 ]
