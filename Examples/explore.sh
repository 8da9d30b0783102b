#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# Installs missing packages, builds the explorer, downloads a real head CT and opens it for touching. See usage() below.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build="$root/build/explore"
program="$build/module/bin/volumehaptics-explore"

usage()
{
  cat << 'EOF'
Usage: Examples/explore.sh [VOLUME] [options]

Opens a window in which VOLUME can be touched with the mouse or a device. Without a display, or
with --pictures, feels its way over it and writes a picture of the volume with the proxy's trail, a
plot of the force, the trace (.vtp, .csv) and a summary. VOLUME is a .vti .nii .nrrd file, a folder of DICOM slices, or
another format, also one larger than memory, that volumehaptics-explore --help lists; without one, a real head CT is
fetched from Debian's package invesalius-examples. On Debian, missing packages are installed (apt-get, with sudo if need be).
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
  --cut NAME        of the window: cut open by a plane or a box, with handles
  --sound           of the window: what is touched can be heard; --sound FILE.wav writes the sound along the path
EOF
}

say()
{
  printf '\n== %s\n' "$*"
}

# Runs a command and writes its output to a log, which is shown only if the command fails.
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
  quietly configure.log cmake -S "$root" --preset explore -B "$build/module"
  quietly build.log cmake --build "$build/module"
}

explore()
{
  # VTK's X11 windows crash on an unusable display, so test the display in a separate process first.
  if [[ -n "${DISPLAY:-}" ]] && ! quietly display.log "$program" --check-display 2> /dev/null
  then
    say "The display $DISPLAY can't be used (see $build/display.log): going on without it"
    unset DISPLAY
  fi
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
  "$program" ${window[@]+"${window[@]}"} "$@"
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
# shellcheck source-path=SCRIPTDIR source=../Data/head-ct.sh
source "$root/Data/head-ct.sh"
say "Packages"
require_packages cmake ninja-build g++ libvtk9-dev xvfb xauth libgl1-mesa-dri pkg-config \
  libusb-1.0-0-dev libhidapi-dev libboost-dev nlohmann-json3-dev libpulse-dev libgdcm-dev libblosc-dev libzstd-dev
echo "Everything that is needed is installed."

mkdir -p "$build"
say "Building in $build"
build_all
echo "Built $program"

# The volume is the first argument that is neither an option nor the value of an option.
volume=""
options=()
while [[ $# -gt 0 ]]
do
  case "$1" in
    --live | --large | -*=*)
      options+=("$1")
      ;;
    --sound)
      options+=("$1")
      if [[ "${2:-}" == *.[wW][aA][vV] ]]
      then
        options+=("$2")
        shift
      fi
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
  get_head_ct "$build/data"
  volume=$build/data/Cranium.mhd
fi

say "Exploring $volume"
explore "$volume" ${options[@]+"${options[@]}"}
