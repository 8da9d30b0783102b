#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Sets points and drills with a burr in the explorer's window, with real mouse and key events on a screen of its own.
# Then opens a file that can't be read: the window comes back with the points and the hole, which the keys S and T save.
# A window that is closed with an unsaved point keeps the point, and the next window offers it: the key F11 brings it
# back. A window in which nothing was done keeps nothing.
#
# usage: keep.sh EXPLORER VOLUME
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils" xvfb-run openbox xdotool wmctrl xprop
take_own_screen "$@"
explorer=$(realpath "$1")
volume=$(realpath "$2")
take_own_home
cd "$folder"
mkdir data
cp "$volume" data/first.vti
echo "no volume" > data/zebra.vti

has_read()
{
  [[ "$(grep -c "^Reading .*$1\$" program.log)" == "$2" ]]
}
# usage: open LOG ARGUMENT...
open()
{
  "$explorer" data/first.vti --size 300 "$@" > program.log 2>&1 &
  child=$!
  wait_for_window "VTK Volume Haptics"
}
# Presses into the forehead and sets a point there. Tries three times, because the force pauses if the machine stalls.
press_and_measure()
{
  local HEIGHT WIDTH
  eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=')"
  xdotool mousemove --window "$window" $((WIDTH / 2)) $((HEIGHT * 2 / 5))
  xdotool key t
  for _ in 1 2 3
  do
    sleep 0.5
    xdotool click 4 click 4
    sleep 0.5
    xdotool key 1
  done
}
is_kept()
{
  [[ -n "$(ls -A state/volumehaptics 2> /dev/null)" ]]
}
has_file()
{
  [[ -s "$1" ]]
}

start_window_manager
open --tool burr
press_and_measure
xdotool mousedown 1
for _ in 1 2 3 4 5 6 7 8 9 10
do
  xdotool mousemove_relative -- 1 0
  sleep 0.1
done
xdotool mouseup 1
xdotool key Escape
xdotool key F2 Down Return
wait_for "the broken volume" has_read zebra.vti 1
wait_for "the first volume again" has_read first.vti 2
wait_for_window "VTK Volume Haptics"
grep -q "Not saved: [0-9]* measurements*, .*mm^3 that the burr removed. Kept in" program.log ||
  fail "the work was not kept when another file was opened"
xdotool key ctrl+s
wait_for "the points that came back" has_file measurements-001.mrk.json
grep -q '"position"' measurements-001.mrk.json || fail "there is no point in the list that came back"
xdotool key ctrl+e
wait_for "the hole that came back" has_file removal-001.vti
xdotool key q
expect_end
! is_kept || fail "what was saved is kept, too"

open
press_and_measure
xdotool key q
expect_end
is_kept || fail "the work was not kept when the window was closed"
open
grep -q "Not saved last time: [0-9]* measurement.*F11 brings it back" program.log || fail "nothing is offered"
xdotool key F11
xdotool key ctrl+s
wait_for "the points of the window before" has_file measurements-002.mrk.json
xdotool key q
expect_end
! is_kept || fail "what was brought back and saved is kept, too"

open
xdotool key q
expect_end
! grep -q "Not saved" program.log || fail "something is kept of a window in which nothing was done"
! is_kept || fail "there is a folder of a window in which nothing was done"
echo "kept, offered and brought back"
