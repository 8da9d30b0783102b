#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Measures what the solvers PAPER and PRECISE reach, prints the table and writes a report with plots.
#
# usage: Testing/evaluate.sh [--quick] [--volume FILE.mhd] [--output FOLDER]
#
# Installs what is missing and builds in build/test. The report goes to build/evaluation. The head CT that
# Examples/explore.sh has fetched is measured, too, unless --volume names another.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  -h | --help) sed -n '5,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
# shellcheck source=../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages cmake ninja-build g++ libvtk9-dev python3-vtk9 xvfb xauth libgl1-mesa-dri libgtest-dev

options=(--output "$root/build/evaluation")
head_ct=$root/build/explore/data/Cranium.mhd
[ -f "$head_ct" ] && options+=(--volume "$head_ct")

cmake -S "$root" --preset dev -B "$root/build/test" > /dev/null
cmake --build "$root/build/test" --target volumehaptics-evaluation
with_own_screen "$root/build/test/bin/volumehaptics-evaluation" "${options[@]}" "$@"
