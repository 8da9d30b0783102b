#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the wheel volumehaptics beside VTK's, with libusb, hidapi and GDCM carried inside.
#
# usage: CMake/wheel/build.sh [FOLDER [PYTHON]]
#
# Writes volumehaptics-*.whl to FOLDER (default build/wheel), for the CPython PYTHON (default python3). Debian packages that
# are missing are installed. The headers of VTK come from the wheel vtk-sdk; if pip finds none, it is assembled in
# FOLDER/sdk. The same commit makes the same bytes. Exits with 3 if pip reaches no registry, or if there is no vtk-sdk.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
case ${1:-} in
  -h | --help) sed -n '5,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
mkdir -p "${1:-$root/build/wheel}"
folder=$(cd "${1:-$root/build/wheel}" && pwd)
python=${2:-python3}

# shellcheck source=../install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages ninja-build g++ python3-venv python3-dev pkg-config libusb-1.0-0-dev libhidapi-dev libblosc-dev libzstd-dev zlib1g-dev \
  libgdcm-dev libboost-dev nlohmann-json3-dev libgl-dev debian-archive-keyring

vtk=$(sed -n 's/^dependencies = .*"vtk==\([0-9.]*\)".*/\1/p' "$root/pyproject.toml")
tools=$folder/tools
rm -rf "$tools" "$folder"/volumehaptics-*.whl "$folder/plain"
"$python" -m venv "$tools"
# Install the pinned versions that the last tested wheel was built with, the same as in pyproject.toml.
if ! "$tools/bin/pip" install -q --require-hashes -r "$root/CMake/wheel/requirements.txt"; then
  echo "pip reaches no registry of Python packages: no wheel" >&2
  exit 3
fi
# Give all files in the wheel the time of the commit, if there is one, so that the build is reproducible.
SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct 2> /dev/null || stat -c %Y "$root/CMakeLists.txt")
export SOURCE_DATE_EPOCH
mkdir -p "$folder/sdk"
if ! ls "$folder"/sdk/vtk_sdk-"$vtk"-*.whl > /dev/null 2>&1 &&
  ! "$tools/bin/pip" download -q --no-deps -d "$folder/sdk" "vtk-sdk==$vtk" 2> "$folder/vtk-sdk.log"; then
  echo "pip finds no vtk-sdk $vtk for $("$python" --version); assembling one"
  "$tools/bin/python" "$root/CMake/wheel/assemble_vtk_sdk.py" "$vtk" "$folder/sdk"
fi
"$tools/bin/pip" wheel -q --no-deps --find-links "$folder/sdk" -w "$folder/plain" "$root"

# VTK's libraries come from VTK's own wheel. This wheel contains all other libraries that are missing from some Linux
# systems.
PATH=$tools/bin:$PATH auditwheel repair --exclude 'libvtk*.so' -w "$folder" "$folder"/plain/volumehaptics-*.whl \
  > "$folder/auditwheel.log" 2>&1 || { cat "$folder/auditwheel.log" >&2; exit 1; }
echo "Built $(ls "$folder"/volumehaptics-*.whl)"
