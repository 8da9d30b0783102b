#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs a wheel as its users do and runs the Python tests against it.
#
# usage: Testing/Wheel/test.sh FOLDER REFERENCE_BUILD PYTHON
#
# FOLDER is what CMake/wheel/build.sh made, and new virtual environments are put there: one with VTK alone, one with
# PyVista. REFERENCE_BUILD is a build with the system's VTK, whose traces the wheel's have to equal.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(cd "$1" && pwd)
reference=$(cd "$2" && pwd)
python=$3
wheel=$(ls "$folder"/volumehaptics-*.whl)
unset PYTHONPATH
export PIP_FIND_LINKS=$folder/sdk PIP_DISABLE_PIP_VERSION_CHECK=1

# The files of an environment's packages, but for what Python compiled on its own.
list_packages()
{
  "$1/bin/python" - << 'EOF'
import pathlib, sysconfig
site = pathlib.Path(sysconfig.get_path("purelib"))
print(*sorted(str(path.relative_to(site)) for path in site.rglob("*") if path.suffix != ".pyc"), sep="\n")
EOF
}

# A new environment NAME with the wheel and the packages REQUIREMENT...
make_environment()
{
  rm -rf "${folder:?}/$1"
  "$python" -m venv "$folder/$1"
  "$folder/$1/bin/pip" install -q "${@:2}" "$wheel"
  VOLUMEHAPTICS_BUILD=$("$folder/$1/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
  VOLUMEHAPTICS_VERSION=$("$folder/$1/bin/pip" show volumehaptics | sed -n 's/^Version: //p')
  export VOLUMEHAPTICS_BUILD VOLUMEHAPTICS_VERSION VOLUMEHAPTICS_REFERENCE_BUILD=$reference
}

# From elsewhere, so that nothing of the repository is imported by accident.
run_pytest()
{
  (cd "$folder" && "$folder/$1/bin/python" -m pytest -q -p no:cacheprovider "${@:2}")
}

echo "== $(basename "$wheel") beside VTK alone"
make_environment with-vtk pytest
run_pytest with-vtk "$root/Testing/Python" -ra
run_pytest with-vtk "$root/Testing/Wheel" -s

echo "== Uninstalled, it leaves nothing"
list_packages "$folder/with-vtk" > "$folder/installed.txt"
"$folder/with-vtk/bin/pip" uninstall -q -y volumehaptics
list_packages "$folder/with-vtk" > "$folder/uninstalled.txt"
grep -c '^volumehaptics' "$folder/installed.txt"
if grep '^volumehaptics' "$folder/uninstalled.txt" ||
  ! diff <(grep -v '^volumehaptics' "$folder/installed.txt") "$folder/uninstalled.txt"; then
  echo "$(basename "$wheel") left or took the above" >&2
  exit 1
fi

echo "== $(basename "$wheel") beside PyVista"
make_environment with-pyvista pytest pyvista
run_pytest with-pyvista "$root/Testing/Python"
run_pytest with-pyvista "$root/Testing/PyVista"
