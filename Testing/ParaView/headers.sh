#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Compiles the plugin's sources against the headers of another ParaView; uses of deprecated names are errors.
#
# usage: Testing/ParaView/headers.sh fetch SUITE FOLDER   # Debian's packages of the suite, such as forky, unpacked
#        Testing/ParaView/headers.sh check FOLDER BUILD   # BUILD: a build of the plugin, with the headers that it makes
#
# Headers come from the packages paraview-dev, qt6-base-dev and, if that ParaView has no VTK of its own, libvtk9-dev,
# from the mirror that apt-get uses here. Nothing is installed. A check fetches nothing, links nothing and runs nothing:
# it finds names and signatures that have changed.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
case ${1:-} in
  fetch | check) [ $# -eq 3 ] || { echo "$0: two arguments are needed; try --help" >&2; exit 2; } ;;
  -h | --help) sed -n '5,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
  *) echo "$0: unknown step ${1:-}; try --help" >&2; exit 2 ;;
esac

fetch()
{
  local suite=$1 mirror package
  mkdir -p "$2"
  cd "$2"
  mkdir -p apt/lists/partial apt/cache/archives/partial
  # shellcheck disable=SC2016 # apt-get expands it
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Label: Debian' 'Identifier: Packages' | sed -n 1p)
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" > apt/sources.list
  cat > apt/apt.conf << EOF
Dir::Etc::sourcelist "$PWD/apt/sources.list";
Dir::Etc::sourceparts "-";
Dir::State::lists "$PWD/apt/lists";
Dir::Cache "$PWD/apt/cache";
APT::Sandbox::User "root";
EOF
  apt-get -c apt/apt.conf -qq update
  for package in paraview-dev qt6-base-dev libvtk9-dev; do
    if [ $package = libvtk9-dev ] && [ -f "$(echo usr/include/paraview-*)/vtkObject.h" ]; then
      continue
    fi
    apt-get -c apt/apt.conf -qq download "$package"
    dpkg-deb -x "$package"_*.deb .
    rm "$package"_*.deb
  done
  rm -r apt
}

check()
{
  local headers build folder paraview qt failed=0
  headers=$(cd "$1" && pwd)/usr/include
  build=$(cd "$2" && pwd)
  paraview=("$headers"/paraview-*)
  qt=("$headers"/*/qt6)
  if [ ! -d "${paraview[0]}" ] || [ ! -d "${qt[0]}" ]; then
    echo "There are no headers of ParaView and Qt 6 in $1. Cure: $0 fetch SUITE $1" >&2
    exit 2
  fi
  if [ ! -d "$build/Plugin/Live" ]; then
    echo "$2 is no build of the plugin. Cure: cmake --preset paraview -DParaView_DIR=..., and cmake --build" >&2
    exit 2
  fi
  # Search the plugin's generated headers first, then third-party headers, whose warnings do not count.
  local options=(-std=c++17 -fPIC -fsyntax-only -Werror=deprecated -Werror=deprecated-declarations -DVTK_LEGACY_REMOVE
    "-I$build/settings" "-I$build/Module/VTK" "-I$root/Module")
  for folder in "$root"/Plugin/*/ "$root"/Plugin/Live/Regions/; do
    options+=("-I$folder" "-I$build/Plugin/$(basename "$folder")")
  done
  while read -r folder; do
    options+=("-I$folder")
  done < <(find "$root/Module/VTK" -type d)
  for folder in "${paraview[0]}" "${paraview[0]}"/vtkqttesting "$headers"/vtk-* "${qt[0]}" "${qt[0]}"/*/; do
    [ ! -d "$folder" ] || options+=(-isystem "$folder")
  done
  if command -v mpicxx > /dev/null; then # Debian's VTK needs MPI
    read -r -a folder <<< "$(mpicxx --showme:compile)"
    options+=("${folder[@]}")
  fi
  local count=0 source
  while read -r source; do
    count=$((count + 1))
    "${CXX:-c++}" "${options[@]}" "$source" || { failed=$((failed + 1)); echo "FAILED: $source" >&2; }
  done < <(find "$root/Plugin" -name '*.cxx' | sort)
  echo "$((count - failed)) of $count sources compile with $(basename "${paraview[0]}")"
  [ $failed -eq 0 ]
}

"$@"
