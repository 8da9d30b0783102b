#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs the tests FILTER of test programs in an empty folder, which is also the temporary folder. Fails if a file stays
# in it.
#
# usage: Testing/leaves_nothing.sh PROGRAM FILTER [PROGRAM FILTER ...]
#
# Runs each program twice at the same time, as tests of two build folders do.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/temporary"
chmod 755 "$folder" "$folder/temporary" # because a test becomes a user without permissions
cd "$folder/temporary"
export TMPDIR=$PWD TEST_TMPDIR=$PWD ASAN_OPTIONS=verify_asan_link_order=0
while [ $# -gt 0 ]; do
  program=$1
  filter=--gtest_filter=$2
  shift 2
  wrapper=()
  if [[ $(basename "$program") == *EmulatedTest ]]; then
    wrapper=(umockdev-wrapper)
  fi
  "${wrapper[@]}" "$program" "$filter" > "$folder/first.log" 2>&1 &
  first=$!
  status=0
  "${wrapper[@]}" "$program" "$filter" > "$folder/second.log" 2>&1 || status=$?
  other=0
  wait "$first" || other=$?
  # Status 77 means that umockdev can't be used here. Fail if either program fails.
  if [[ $status != @(0|77) || $other != @(0|77) ]]; then
    cat "$folder/first.log" "$folder/second.log"
    exit 1
  fi
  if [ -n "$(ls -A)" ]; then
    echo "$(basename "$program") leaves behind in the temporary folder:"
    ls -AR
    exit 1
  fi
done
