#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Writes files like those of other people, by independent libraries from PyPI, and compares the explorer's result with
# the phantom's formula.
#
# usage: Testing/Data/Formats/formats.sh BUILD_DIR [seeds | only FOLDER NAME...]
#
# With seeds, only writes small files into BUILD_DIR/formats/seeds, for the fuzzer; with only, only writes the cases
# with these names into a folder. BUILD_DIR/formats holds the
# libraries, and is kept. $VOLUMEHAPTICS_EXPLORE is the explorer.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build_dir=$(cd "$1" && pwd)/formats
libraries=$build_dir/libraries
mkdir -p "$build_dir"
exec {lock}> "$build_dir/lock"
flock $lock
if ! cmp -s "$here/requirements.txt" "$libraries/requirements.txt"; then
  rm -rf "$libraries"
  python3 -m venv "$libraries"
  if ! "$libraries/bin/pip" install -q --require-hashes -r "$here/requirements.txt"; then
    echo "SKIPPED: pip did not install the writers of the files, as it says above"
    exit 77
  fi
  cp "$here/requirements.txt" "$libraries/"
fi
if [ "${2:-}" = seeds ]; then
  rm -rf "$build_dir/seeds"
  PYTHONDONTWRITEBYTECODE=1 exec "$libraries/bin/python" "$here/seeds.py" "$build_dir/seeds"
fi
if [ "${2:-}" = only ]; then
  rm -rf "$3"
  PYTHONDONTWRITEBYTECODE=1 exec "$libraries/bin/python" "$here/write.py" "${@:3}"
fi
flock -u $lock
# The files are reused until their writers change.
writers=$(cat "$here"/write*.py "$here/cases.py" "$here/phantom.py" "$here/libraries_files.py" "$here/requirements.txt" |
  sha256sum)
if [ "$(cat "$build_dir/files/writers" 2> /dev/null)" != "$writers" ]; then
  rm -rf "$build_dir/files"
  PYTHONDONTWRITEBYTECODE=1 "$libraries/bin/python" "$here/write.py" "$build_dir/files"
  PYTHONDONTWRITEBYTECODE=1 "$libraries/bin/python" "$here/libraries_files.py" "$build_dir/files/libraries"
  echo "$writers" > "$build_dir/files/writers"
fi
VOLUMEHAPTICS_FORMATS=$build_dir/files PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -m pytest "$here/TestFormats.py" -q \
  -p no:cacheprovider
