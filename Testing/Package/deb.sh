#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the Debian packages, unpacks them, and uses them as users do: find_package() with a program of the examples,
# the Python package, and the programs. Compares the contents of each package with its purpose.
#
# usage: deb.sh SOURCE_DIR BUILD_DIR [PACKAGES]
#
#   PACKAGES  a folder with packages that CMake/packages/deb.sh has built before
#
# Exits with 77 if SOURCE_DIR is not a checkout of git: the committed sources are packed.
set -euo pipefail

source_dir=$1
build_dir=$2
work=$build_dir/Testing/Package/deb
packages=${3:-$work/packages}
root=$work/root

if ! git -C "$source_dir" rev-parse HEAD > /dev/null 2>&1; then
  echo "SKIPPED: $source_dir is no checkout of git"
  exit 77
fi
rm -rf "$work"
mkdir -p "$root"
if [ $# -lt 3 ]; then
  cache=$(sed -n 's/^VolumeHaptics_COMPILER_CACHE:[A-Z]*=//p' "$build_dir/CMakeCache.txt")
  if [ -n "$cache" ]; then
    export CMAKE_C_COMPILER_LAUNCHER=$cache CMAKE_CXX_COMPILER_LAUNCHER=$cache
  fi
  "$source_dir/CMake/packages/deb.sh" "$packages" > "$work/build.log" 2>&1 || { tail -n 50 "$work/build.log" >&2; exit 1; }
fi

fail()
{
  echo "$*" >&2
  exit 1
}

# usage: holds PACKAGE PATTERN...
# Fails unless one package has this name, and a file for each pattern.
holds()
{
  local package=$1 found
  found=$(find "$packages" -maxdepth 1 -name "${package}_*.deb")
  [[ -n $found && $found != *$'\n'* ]] || fail "not one package $package: $found"
  dpkg-deb --contents "$found" > "$work/$package.txt"
  dpkg-deb --field "$found" Depends >> "$work/depends.txt"
  shift
  for pattern in "$@"; do
    grep -qE " \./$pattern( -> |$)" "$work/$package.txt" || fail "$package holds no $pattern"
  done
  dpkg-deb --extract "$found" "$root"
}

series=$(sed -n 's/^  VERSION \([0-9]*[.][0-9]*\)[.].*/\1/p' "$source_dir/CMakeLists.txt" | head -n 1)
library="usr/lib/[^/]*/libvtkVolumeHaptics[.]so"
holds "libvtkvolumehaptics$series" "${library}[.]$series" "${library}[.]${series}[.][0-9]+"
holds libvtkvolumehaptics-dev "$library" 'usr/include/volumehaptics/vtkVolumeHapticsFilter[.]h' \
  'usr/lib/[^/]*/cmake/VolumeHaptics/VolumeHapticsConfig[.]cmake' 'usr/lib/[^/]*/vtk/hierarchy/VolumeHaptics/.*'
holds volumehaptics-tools usr/bin/volumehaptics-{explore,device,dicom,read,guard} 'usr/lib/[^/]*/volumehaptics/libvolumehaptics-autoload[.]so' \
  usr/share/man/man1/volumehaptics-{explore,device,guard}[.]1[.]gz 'usr/lib/udev/rules[.]d/70-volume-haptics[.]rules'

# Build against the three packages without Python, as an application does.
lib=$(dirname "$(find "$root/usr/lib" -name "libvtkVolumeHaptics.so.$series")")
cmake -S "$source_dir/Examples/Cxx" -B "$work/examples" -G Ninja -DCMAKE_PREFIX_PATH="$root/usr" > "$work/configure.log"
grep -q "^VolumeHaptics_DIR:PATH=$root/" "$work/examples/CMakeCache.txt" || fail "another VolumeHaptics was found"
cmake --build "$work/examples" --target first-touch > "$work/build-examples.log"
from_cxx=$("$work/examples/first-touch" "$source_dir/Data/HeadPhantom.vti")
echo "C++:    $from_cxx"
case $from_cxx in
  0\ N | '') fail "first-touch felt nothing" ;;
esac
"$root/usr/bin/volumehaptics-device" list | grep '^virtual' > /dev/null || fail "volumehaptics-device lists no virtual device"
"$root/usr/bin/volumehaptics-explore" --help | grep '^Usage: volumehaptics-explore' > /dev/null ||
  fail "volumehaptics-explore has no help"

# Read a file that makes the explorer exit if volumehaptics-read can't load the library.
refused=$("$root/usr/bin/volumehaptics-explore" "$source_dir/Testing/Data/FarPoint.vtk" --inspect 2>&1 || true)
grep -q 'its reader ended' <<< "$refused" || fail "volumehaptics-read reads nothing: $refused"

holds python3-volumehaptics usr/lib/python3/dist-packages/volumehaptics/{__init__.py,data/HeadPhantom.vti,pyvista.py} \
  'usr/lib/python3/dist-packages/volumehaptics/vtkVolumeHaptics.*[.]so'
from_python=$(PYTHONPATH=$root/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$lib PYTHONDONTWRITEBYTECODE=1 \
  /usr/bin/python3 "$source_dir/Examples/Python/first_touch.py" "$source_dir/Data/HeadPhantom.vti")
echo "Python: $from_python"
[ "${from_cxx%.*}" = "${from_python%%.*}" ] || fail "C++ and Python disagree"

# Check the dependencies that dpkg-shlibdeps and the rules must find.
for dependency in 'libvtk9[.][0-9]+' libvtk9-dev "libvtkvolumehaptics$series" python3-vtk9 python3-numpy; do
  grep -qE "(^|, )$dependency( |,|$)" "$work/depends.txt" || fail "no package depends on $dependency"
done
