#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# The main job in one command: installs what is missing, builds, gets a real head CT and explores it
# by touch. See usage() below.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build="$root/build/explore"
program="$build/bin/volumehaptics-explore"

usage()
{
  cat << 'EOF'
Usage: Examples/explore.sh [VOLUME] [options]

Opens a window in which VOLUME can be touched with the mouse or a device. Where there is no display, or
with --pictures, feels its way over it and writes a picture of the volume with the proxy's trail, a
plot of the force, the trace (.vtp, .csv) and a summary. VOLUME is a .vti .mhd .mha .nii .nii.gz .nrrd file or a
folder of DICOM slices; without one, a real head CT is fetched from Debian's package
invesalius-examples. On Debian, missing packages are installed (apt-get, with sudo if need be).
Everything is built and written in build/explore.

Some options, passed on to volumehaptics-explore, which lists all of them with --help:
  --pictures DIR    no window; where the results go (default build/explore/pictures)
  --preset NAME     materials, such as "CT contrast", "CT physical", "MRI"
  --estimator NAME  gradient: central, gaussian, bspline
  --method NAME     proxy, or for comparison another one, on the same path: paper, force-field, surface-proxy,
                    local-surface
  --size PX         width of the picture
  --live            pictures, and the same path through the servo loop, too, at 1 kHz in real time
  --device ID       of the window: virtual (the mouse), replay:FILE, ...
  --setup FILE      of the window: functions, settings and camera, loaded and saved
  --stereo MODE     of the window, such as anaglyph
EOF
}

say()
{
  printf '\n== %s\n' "$*"
}

# Runs a command with its output in a log; shows the log only if it fails.
quietly()
{
  local log="$build/$1"
  shift
  if ! "$@" > "$log" 2>&1
  then
    cat "$log" >&2
    echo "Failed: $*" >&2
    return 1
  fi
}

build_all()
{
  quietly configure.log cmake -S "$root" -B "$build/module" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_TESTING=OFF \
    -DVolumeHaptics_WRAP_PYTHON=OFF
  quietly build.log cmake --build "$build/module"
  quietly configure-examples.log cmake -S "$root/Examples/Cxx" -B "$build/examples" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_RUNTIME_OUTPUT_DIRECTORY="$build/bin" \
    -DVolumeHaptics_DIR="$build/module/lib/cmake/VolumeHaptics"
  quietly build-examples.log cmake --build "$build/examples"
}

# Unpacks Debian's example of InVesalius, without installing it. Sets $volume.
get_head_ct()
{
  local data="$build/data"
  local examples="$data/package/usr/share/doc/invesalius-examples"
  volume="$data/Cranium.mhd"
  if [[ ! -f "$volume" ]]
  then
    rm -rf "$data"
    mkdir -p "$data/package"
    if ! (cd "$data" && apt-get download -qq invesalius-examples 2> download.log)
    then
      # A machine that has never seen a package list.
      if [[ "$(id -u)" -eq 0 ]]
      then
        apt-get update -qq
      elif command -v sudo > /dev/null
      then
        sudo apt-get update -qq
      fi
      if ! (cd "$data" && apt-get download -qq invesalius-examples)
      then
        echo "The Debian package invesalius-examples could not be downloaded." >&2
        echo "Cure: check the network and /etc/apt/sources.list, or name a VOLUME of yours." >&2
        return 1
      fi
    fi
    dpkg -x "$data"/invesalius-examples_*.deb "$data/package"
    tar -xzf "$examples/examples/Cranium.inv3" -C "$data" --strip-components=1 --wildcards \
      '*/matrix.dat'
    if [[ "$(stat -c %s "$data/matrix.dat")" -ne $((256 * 256 * 108 * 2)) ]]
    then
      echo "invesalius-examples holds another head than the one known here." >&2
      echo "Cure: name a VOLUME of yours." >&2
      return 1
    fi
    # The rows run from the back to the front, the other way round than DICOM's: hence the -1.
    cat > "$volume.part" << 'EOF'
ObjectType = Image
NDims = 3
BinaryData = True
BinaryDataByteOrderMSB = False
CompressedData = False
TransformMatrix = 1 0 0 0 -1 0 0 0 1
Offset = 0 244.042905 0
ElementSpacing = 0.957031 0.957031 1.5
DimSize = 256 256 108
ElementType = MET_SHORT
ElementDataFile = matrix.dat
EOF
    mv "$volume.part" "$volume"
  fi
  echo "Cranium from Debian's invesalius-examples: (c) Centro de Tecnologia da Informacao Renato"
  echo "Archer, licence GPL-2. It stays in build/explore and is not part of this project."
  echo "Licence text: $examples/copyright"
}

explore()
{
  local status=0
  if [[ -z "${DISPLAY:-}" ]]
  then
    with_own_screen "$program" --pictures "$build/pictures" "$@"
    return
  fi
  local window=(--pictures "$build/pictures")
  if [[ " $* " != *" --live "* && " $* " != *" --pictures"* ]]
  then
    window=()
  fi
  "$program" ${window[@]+"${window[@]}"} "$@" || status=$?
  if [[ $status -eq 134 || $status -eq 139 ]]
  then
    # VTK's X11 windows crash (SIGABRT, SIGSEGV) on a display that is set and cannot be used.
    say "The display $DISPLAY is of no use: trying again without it"
    status=0
    with_own_screen "$program" --pictures "$build/pictures" "$@" || status=$?
  fi
  return "$status"
}

for word in "$@"
do
  if [[ "$word" == --help || "$word" == -h ]]
  then
    usage
    exit 0
  fi
done

# shellcheck source-path=SCRIPTDIR source=../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
say "Packages"
require_packages cmake ninja-build g++ libvtk9-dev xvfb xauth libgl1-mesa-dri pkg-config \
  libusb-1.0-0-dev libhidapi-dev
echo "Everything that is needed is installed."

mkdir -p "$build"
say "Building in $build"
build_all
echo "Built $program"

# The volume is the first word that is neither an option nor the value of one.
volume=""
options=()
while [[ $# -gt 0 ]]
do
  case "$1" in
    --live | -*=*)
      options+=("$1")
      ;;
    -*)
      options+=("$1" "${@:2:1}")
      if [[ $# -gt 1 ]]
      then
        shift
      fi
      ;;
    *)
      if [[ -z "$volume" ]]
      then
        volume="$1"
      else
        options+=("$1")
      fi
      ;;
  esac
  shift
done
if [[ -z "$volume" ]]
then
  say "Head CT"
  get_head_ct
fi

say "Exploring $volume"
explore "$volume" ${options[@]+"${options[@]}"}
