#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Cross-builds for Windows with MinGW-w64 and runs the tests under Wine. It ends with the count of passed tests, and
# lists the tests that can't run there.
#
#   Testing/windows.sh FOLDER
#
# FOLDER receives what is built. Needs Debian's packages cmake, ninja-build, g++-mingw-w64-x86-64-posix, wine64,
# googletest, libboost-dev and nlohmann-json3-dev. So far, the mathematics and the devices are built, with their tests.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  '' | -h | --help) sed -n '5,11s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
mkdir -p "$1"
folder=$(cd "$1" && pwd)
prefix=$folder/prefix
toolchain=(-G Ninja "-DCMAKE_TOOLCHAIN_FILE=$root/CMake/windows/mingw.cmake" "-DVolumeHaptics_WINDOWS_PREFIX=$prefix")
release=(-DCMAKE_BUILD_TYPE=Release '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG')
export WINEPREFIX=$folder/wine WINEDEBUG=-all
# What is built finds its libraries, which lie in several folders.
gcc=$(dirname "$(x86_64-w64-mingw32-g++-posix -print-file-name=libstdc++-6.dll)")
WINEPATH="$(printf '%s;' "Z:$gcc" "Z:/usr/x86_64-w64-mingw32/lib" "Z:$prefix/bin" "Z:$folder/build/bin")"
export WINEPATH=${WINEPATH//\//\\}

if [ ! -e "$prefix/lib/libgtest.a" ]; then
  cmake -S /usr/src/googletest -B "$folder/googletest" "${toolchain[@]}" "${release[@]}" -DBUILD_GMOCK=OFF \
    "-DCMAKE_INSTALL_PREFIX=$prefix" -DCMAKE_INSTALL_LIBDIR=lib
  cmake --build "$folder/googletest" --target install
fi
# Headers of libraries that have nothing else: those of the system, of which MinGW must not see more.
mkdir -p "$prefix/include"
ln -sfn /usr/include/boost "$prefix/include/boost"
ln -sfn /usr/include/nlohmann "$prefix/include/nlohmann"

cmake -S "$root" -B "$folder/build" "${toolchain[@]}" "${release[@]}" -DVolumeHaptics_USE_VTK=OFF \
  -DCMAKE_UNITY_BUILD=ON -DBUILD_TESTING=ON
cmake --build "$folder/build"

# Tests of which each has a reason: PATTERN of their names, and what they need.
cat > "$folder/left-out.txt" <<'LIST'
LIST
results=$folder/results.txt
ctest --test-dir "$folder/build" -j "$(nproc)" --output-on-failure "${@:2}" | tee "$results" || failed=1
passed=$(grep -c ' Passed ' "$results" || true)
echo "Passed under Wine: $passed"
exit "${failed:-0}"
