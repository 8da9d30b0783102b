#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs Google Test programs in a German locale, in which a user writes 1,6 instead of 1.6. LIBRARY is built from
# Rigs/FollowLocale.cxx, which makes programs follow the locale. If the system lacks the locale, the script makes it in
# a temporary folder.
#
# usage: Testing/german.sh LIBRARY PROGRAM [PROGRAM ...]
set -euo pipefail

library=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if ! locale -a | grep -qix 'de_DE\.utf-\?8'; then
  if ! command -v localedef > /dev/null || ! localedef -i de_DE -f UTF-8 "$folder/de_DE.UTF-8" 2> "$folder/log"; then
    cat "$folder/log" 2> /dev/null || true
    echo "The locale de_DE.UTF-8 can't be made. Cure: apt-get install locales"
    exit 77
  fi
  export LOCPATH=$folder
fi
failed=0
run()
{
  mkdir "$folder/temporary"
  local status=0
  # Keep the system's own messages in English, as the tests expect them.
  env -u LC_ALL -u LANGUAGE LANG=de_DE.UTF-8 LC_MESSAGES=C LD_PRELOAD="$library" TEST_TMPDIR="$folder/temporary" \
    "$@" > "$folder/output" 2>&1 || status=$?
  rm -rf "$folder/temporary"
  return $status
}
# Run each test in a process of its own, as CTest does, because some tests change the rights of their process.
for program in "$@"; do
  cases=$("$program" --gtest_list_tests --gtest_filter="${GTEST_FILTER:-*}" | sed 's/ *#.*//')
  suite=
  while read -r word; do
    if [[ $word == *. ]]; then
      suite=$word
    elif [[ -n $suite && -n $word && $word != DISABLED_* ]] && ! run "$program" --gtest_brief=1 \
      --gtest_filter="$suite$word"; then
      echo "$suite$word of $(basename "$program") fails in German:"
      cat "$folder/output"
      failed=1
    fi
  done <<< "$cases"
done
exit $failed
