#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds Debian packages of the committed sources, with dpkg-buildpackage, for the VTK of this Debian.
#
# usage: CMake/packages/deb.sh [FOLDER]
#
# Writes *.deb to FOLDER (default build/deb): the library, its headers, the Python package, and the programs with the
# rules of udev. Installs missing build tools.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
case ${1:-} in
  -h | --help) sed -n '5,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
folder=$(realpath -m "${1:-$root/build/deb}")
# shellcheck source=../install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages build-essential dpkg-dev debhelper dh-python fakeroot cmake ninja-build g++ libvtk9-dev python3-vtk9 python3-dev \
  python3-numpy zlib1g-dev pkg-config libusb-1.0-0-dev libhidapi-dev libboost-dev nlohmann-json3-dev libpulse-dev \
  libgdcm-dev libblosc-dev libzstd-dev git

version=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt" | head -n 1)
source_dir=$folder/vtk-volume-haptics-$version
rm -rf "$source_dir"
mkdir -p "$source_dir"
git -C "$root" archive HEAD | tar -x -C "$source_dir"
cp -r "$source_dir/CMake/packages/debian" "$source_dir"
cd "$source_dir/debian"
sed "s/@VERSION@/$version/; s/@DATE@/$(git -C "$root" log -1 --format=%cD)/" changelog.in > changelog
rm changelog.in
# Indent the licence as Debian's copyright file requires, with dots for empty lines.
sed 's/^$/./; s/^/ /' ../LICENSE > license
sed -i -e '/@LICENSE@/{r license' -e 'd}' copyright
rm license
cd ..
dpkg-buildpackage --build=binary --no-sign
ls "$folder"/*.deb
