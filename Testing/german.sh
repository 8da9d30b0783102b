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
# Set the system's own messages to English, as the tests expect.
"$(dirname "${BASH_SOURCE[0]}")/each_case.sh" "in German" \
  env -u LC_ALL -u LANGUAGE LANG=de_DE.UTF-8 LC_MESSAGES=C LD_PRELOAD="$library" -- "$@"
