#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs a step of the wheel's tests. CTest runs the steps in order (label wheel): they install the wheel as users do, and
# run Python tests against the wheel.
#
# usage: Testing/Wheel/test.sh FOLDER REFERENCE_BUILD PYTHON STEP ENVIRONMENT [ARGUMENT...]
#
#   install    makes a new ENVIRONMENT in FOLDER with the wheel, and the packages that ARGUMENT names
#   pytest     runs pytest there, with the arguments
#   close      opens a plotter of PyVista and closes it, by Testing/Window/close.sh with the arguments
#   host       touches a volume in another project's program, which ARGUMENT names, by Testing/Hosts/host.sh
#   uninstall  removes the wheel; expects that nothing of it is left, and that nothing else is removed
#   twice      builds the wheel of the last commit again in FOLDER/ENVIRONMENT, from a copy of the sources in another folder;
#              expects the same bytes
#
# FOLDER is the result of CMake/wheel/build.sh. REFERENCE_BUILD is a build with the system's VTK; the wheel's traces
# must equal its traces. Exits with 77 if there is no wheel of the present sources.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
case ${1:-} in
  -h | --help) sed -n '5,21s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
folder=$(realpath -m "$1")
reference=$(realpath "$2")
python=$3
step=$4
environment=$folder/$5
shift 5

wheel=$(find "$folder" -maxdepth 1 -name 'volumehaptics-*.whl' 2> /dev/null || true)
if [[ -z $wheel ]]; then
  echo "SKIPPED: there is no wheel in $folder. Build it: CMake/wheel/build.sh '$folder' $python"
  exit 77
fi
newer=$(find "$root"/{Module,CMake,CMakeLists.txt,CMakePresets.json,pyproject.toml} -type f -not -name '*.pyc' \
  -newer "$wheel" -print -quit)
if [[ -n $newer ]]; then
  echo "SKIPPED: $wheel is older than $newer. Build it anew: CMake/wheel/build.sh '$folder' $python"
  exit 77
fi
unset PYTHONPATH
export PIP_FIND_LINKS=$folder/sdk PIP_DISABLE_PIP_VERSION_CHECK=1

# Lists the files of the environment's packages, except for files that Python compiles.
list_packages()
{
  "$environment/bin/python" - << 'EOF'
import pathlib, sysconfig
site = pathlib.Path(sysconfig.get_path("purelib"))
print(*sorted(str(path.relative_to(site)) for path in site.rglob("*") if path.suffix != ".pyc"), sep="\n")
EOF
}

case $step in
  install)
    rm -rf "${environment:?}"
    "$python" -m venv "$environment"
    # Don't let pip compile all packages, because Python compiles the tenth of them that it imports.
    "$environment/bin/pip" install -q --no-compile "$@" "$wheel"
    ;;
  pytest)
    VOLUMEHAPTICS_BUILD=$("$environment/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
    VOLUMEHAPTICS_VERSION=$("$environment/bin/pip" show volumehaptics | sed -n 's/^Version: //p')
    export VOLUMEHAPTICS_BUILD VOLUMEHAPTICS_VERSION VOLUMEHAPTICS_REFERENCE_BUILD=$reference
    # Run in another folder, so that no file of the repository is imported by accident.
    cd "$folder"
    exec "$environment/bin/python" -m pytest -q -p no:cacheprovider "$@"
    ;;
  close)
    exec "$root/Testing/Window/close.sh" "$@" "Touch in PyVista" "$environment/bin/python" "$root/Testing/Window/plotter.py"
    ;;
  host)
    exec "$root/Testing/Hosts/host.sh" "$environment/bin/python" "$@"
    ;;
  uninstall)
    list_packages > "$folder/installed.txt"
    "$environment/bin/pip" uninstall -q -y volumehaptics
    list_packages > "$folder/uninstalled.txt"
    grep -c '^volumehaptics' "$folder/installed.txt"
    if grep '^volumehaptics' "$folder/uninstalled.txt" ||
      ! diff <(grep -v '^volumehaptics' "$folder/installed.txt") "$folder/uninstalled.txt"; then
      echo "$(basename "$wheel") left or took the above" >&2
      exit 1
    fi
    ;;
  twice)
    # The folder's name is longer, so that a path that is written into a file moves what follows it.
    copy=$environment/a/copy/of/the/sources/in/a/folder/with/a/longer/name
    rm -rf "${environment:?}"
    mkdir -p "$environment/wheel"
    git clone -q --no-hardlinks "$root" "$copy" || { echo "SKIPPED: $root is no clone of the repository"; exit 77; }
    ln -s "$folder/sdk" "$environment/wheel/sdk"
    status=0
    "$copy/CMake/wheel/build.sh" "$environment/wheel" "$python" || status=$?
    [[ $status -ne 3 ]] || exit 77
    [[ $status -eq 0 ]] || exit "$status"
    again=$environment/wheel/$(basename "$wheel")
    if ! cmp "$wheel" "$again"; then
      # Say which files differ.
      diff <(unzip -v "$wheel" | sort -k 8) <(unzip -v "$again" | sort -k 8) || true
      exit 1
    fi
    sha256sum "$wheel" "$again"
    ;;
  *)
    echo "$0: unknown step $step; try --help" >&2
    exit 2
    ;;
esac
