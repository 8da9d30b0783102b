#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs each case of Google Test programs in a separate process, as CTest does, because some tests change the permissions
# of their process. COMMAND, such as "env LANG=C", starts each process with an empty temporary folder. WHERE, such as
# "in German", is printed with each case that fails.
#
# usage: Testing/each_case.sh WHERE COMMAND... -- PROGRAM...
set -euo pipefail

where=$1
shift
command=()
while [[ $1 != -- ]]; do
  command+=("$1")
  shift
done
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
run()
{
  mkdir "$folder/temporary"
  local status=0
  TEST_TMPDIR="$folder/temporary" "${command[@]}" "$@" > "$folder/output" 2>&1 || status=$?
  rm -rf "$folder/temporary"
  return $status
}
for program in "$@"; do
  cases=$("$program" --gtest_list_tests --gtest_filter="${GTEST_FILTER:-*}" | sed 's/ *#.*//')
  suite=
  while read -r word; do
    if [[ $word == *. ]]; then
      suite=$word
    elif [[ -n $suite && -n $word && $word != DISABLED_* ]] && ! run "$program" --gtest_brief=1 \
      --gtest_filter="$suite$word"; then
      echo "$suite$word of $(basename "$program") fails $where:"
      cat "$folder/output"
      failed=1
    fi
  done <<< "$cases"
done
exit $failed
