#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Makes a folder with ParaView, its development files and its Python, beside VTK's own Python package.
#
# usage: Plugin/paraview-prefix.sh PREFIX
#
# Debian's python3-paraview can't be installed together with python3-vtk9, which libvtk9-dev needs, and
# ParaView's CMake files insist on it. So it is unpacked into PREFIX, beside links to the installed packages
# paraview and paraview-dev. A prefix that is there already, of the same version, is left alone.
#
#   cmake ... -DParaView_DIR=$(echo PREFIX/usr/lib/*/cmake/paraview-*)
#   PATH=PREFIX/usr/bin:$PATH PYTHONPATH=PREFIX/usr/lib/python3/dist-packages pvpython ...
set -euo pipefail

case ${1:-} in
  "" | -*) sed -n '5,14s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; [ "${1:-}" = --help ]; exit ;;
esac
mkdir -p "$1"
prefix=$(cd "$1" && pwd)

version=$(dpkg-query -W -f='${Version}' paraview-dev 2> /dev/null) || version=
if [ -z "$version" ]; then
  echo "ParaView is not installed. Cure: apt-get install --no-install-recommends paraview paraview-dev" >&2
  exit 1
fi
if [ "$(cat "$prefix/version" 2> /dev/null)" = "$version" ]; then
  exit 0
fi

# Also remove the remains of an interrupted attempt.
rm -rf "${prefix:?}/usr" "$prefix/package" "$prefix/version"
mkdir -p "$prefix/package"
if ! (cd "$prefix/package" && apt-get download -qq "python3-paraview=$version" 2> download.log); then
  cat "$prefix/package/download.log" >&2
  echo "The Debian package python3-paraview could not be downloaded." >&2
  echo "Cure: bring the package lists up to date with apt-get update, and look at the network." >&2
  exit 1
fi
dpkg -x "$prefix"/package/python3-paraview_*.deb "$prefix"

# Debian 13 adds the ABI to the names of Python's modules, but its CMake files look for names without it.
find "$prefix/usr/lib/python3" -name '*.cpython-*.so' | while read -r module; do
  ln -sfn "$(basename "$module")" "${module%%.cpython-*}.so"
done

# CMake files find everything else relative to themselves, so copy them, and link to the other files.
paths=$(dpkg -L paraview paraview-dev)
find_paths() { grep -E "^/usr/($1)\$" <<< "$paths"; }
find_paths 'lib/[^/]+/cmake/paraview-[^/]+' | while read -r folder; do
  mkdir -p "$prefix$(dirname "$folder")"
  cp -a "$folder" "$prefix$folder"
done
find_paths '(include|lib/[^/]+-linux-gnu)/paraview-[^/]+' | while read -r folder; do
  mkdir -p "$prefix$(dirname "$folder")"
  ln -s "$folder" "$prefix$folder"
done
for folder in /usr/bin /usr/lib/*-linux-gnu; do
  mkdir -p "$prefix$folder"
  find_paths "${folder#/usr/}/[^/]+" | while read -r path; do [ -d "$path" ] || printf '%s\0' "$path"; done |
    xargs -0 -r ln -sfn -t "$prefix$folder"
done
printf '%s\n' "$version" > "$prefix/version"
echo "ParaView $version is in $prefix"
