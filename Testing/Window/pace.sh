#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Opens a program's window on a screen of its own, with a window manager. Prints how quickly the window follows the
# hand: frames per second in a stroke, and the latency of input while a fine frame is due. See pace.py.
#
# usage: pace.sh [--at X Y] [--rounds N] [--rest SECONDS] [OPTION OF pace.py]... TITLE PROGRAM [ARGUMENT]...
# example: pace.sh --rest 4 "VTK Volume Haptics" build/bin/volumehaptics-explore Data/HeadPhantom.vti --size 700
#
# Use a machine that does nothing else. No test asserts the figures.
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils python3" xvfb-run openbox xdotool wmctrl xprop python3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
take_own_screen "$@"
options=()
while [[ "$1" == --* ]]
do
  case "$1" in
    --at) options+=("$1" "$2" "$3") && shift 3 ;;
    *) options+=("$1" "$2") && shift 2 ;;
  esac
done
title=$1
shift
take_own_home

start_window_manager
"$@" > "$folder/program.log" 2>&1 &
child=$!
wait_for_window "$title"
sleep 1
python3 "$here/pace.py" "${options[@]}" "$title" || fail "nothing was measured"
