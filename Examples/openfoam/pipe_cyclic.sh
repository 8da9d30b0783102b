#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# Computes OpenFOAM's tutorial pipeCyclic, a swirling flow in a pipe, within seconds. See usage() below.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
tutorial=/usr/share/doc/openfoam-examples/examples/incompressible/simpleFoam/pipeCyclic
export WM_PROJECT_DIR=/usr/share/openfoam
# shellcheck source=../../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"

usage()
{
  cat << 'EOF'
Usage: Examples/openfoam/pipe_cyclic.sh [FOLDER]

Copies the tutorial from Debian's package openfoam-examples to FOLDER (default build/pipe_cyclic), computes it with
the package openfoam, and prints how it is felt. On Debian, missing packages are installed. A folder in which it was
computed stays as it is: remove it to compute it again.
EOF
}

# Runs an OpenFOAM program in the case folder, and shows its log only if it fails.
run()
{
  echo "$1"
  if ! (cd "$case" && "$@" > "log.$1" 2>&1)
  then
    tail -n 30 "$case/log.$1" >&2
    echo "Failed: $* (its log: $case/log.$1)" >&2
    return 1
  fi
}

if [[ "${1:-}" == -* ]]
then
  usage
  [[ "$1" == --help || "$1" == -h ]]
  exit
fi
case="${1:-$root/build/pipe_cyclic}"
feel="Feel it: python3 Examples/Python/felt_fields.py openfoam $case/pipe_cyclic.foam"
if [[ -e "$case/computed" ]]
then
  echo "$feel"
  exit
fi
require_packages openfoam openfoam-examples
if [[ ! -d "$tutorial" ]]
then
  echo "openfoam-examples has no folder $tutorial. Was dpkg told to leave out documentation (path-exclude)?" >&2
  echo "Cure: remove that line in /etc/dpkg/dpkg.cfg.d, and run: apt-get install --reinstall openfoam-examples" >&2
  exit 1
fi
if [[ -e "$case" && ! -e "$case/pipe_cyclic.foam" ]]
then
  echo "$case exists, and no case of this script is in it. Cure: name another folder." >&2
  exit 1
fi
rm -rf "$case"
mkdir -p "$(dirname "$case")"
cp -r "$tutorial" "$case"
cp -r "$case/0.orig" "$case/0"
touch "$case/pipe_cyclic.foam"
# The tutorial's inlet is C++ code that needs a compiler and OpenFOAM's headers. Replace it by an equal condition: 1 m/s
# along the pipe, and a rotation of -2 rad/s around it.
run foamDictionary 0/U -disableFunctionEntries -entry boundaryField.inlet -set \
  '{ type cylindricalInletVelocity; origin (0 0 0); centre (0 0 0); axis (1 0 0);
     axialVelocity constant 1; radialVelocity constant 0; rpm constant -19.098593171027; value uniform (1 0 0); }'
run blockMesh
run topoSet
run refineHexMesh c0 -overwrite
run simpleFoam
touch "$case/computed"
echo "$feel"
