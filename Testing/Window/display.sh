#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Tests the question that Examples/explore.sh asks the explorer before it opens a window. The answer is yes on a screen,
# and no without a screen, or on a screen without GLX (as over a network).
# usage: display.sh PROGRAM
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth" xvfb-run

check()
{
  local wanted=$1 what=$2 status=0 usable=yes
  shift 2
  "$@" --check-display > /dev/null 2>&1 || status=$?
  [[ $status -eq 0 ]] || usable=no
  if [[ $usable != "$wanted" ]]
  then
    echo "FAILED: $what: exit status $status" >&2
    exit 1
  fi
  echo "$what: exit status $status"
}
check_all()
{
  check yes "a screen" xvfb-run -a -s "-screen 0 640x480x24" "$1"
  check no "a screen without GLX" xvfb-run -a -s "-screen 0 640x480x24 -extension GLX" "$1"
  check no "no screen at that address" env DISPLAY=:59999 "$1"
  check no "no address" env -u DISPLAY "$1"
}
check_all "$1" 2>&1
