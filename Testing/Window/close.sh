#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Opens a program's window on a screen of its own, with a window manager, touches what is in it with real mouse and
# key events, and closes it: with the key q and by the window manager, which sends WM_DELETE_WINDOW, in the touch mode
# (armed, the tip moving) and without. The program has to end each time, with status 0.
#
# usage: close.sh [--rounds N] [--expect FILE] [--size PIXELS] [--picture FILE] TITLE PROGRAM [ARGUMENT]...
#
#   --rounds N      how often each of the four (default 1)
#   --expect FILE   what the program writes when it ends; it has to be there anew each time
#   --size PIXELS   of the window's sides, for machines that draw in software
#   --picture FILE  a picture of the window while something is touched; takes imagemagick
#   TITLE           of the window, or its beginning
#
# Ends with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils" xvfb-run openbox xdotool wmctrl xprop
take_own_screen "$@"

rounds=1
expected=""
picture=""
size=""
while [[ "$1" == --* ]]
do
  case "$1" in
    --rounds) rounds=$2 ;;
    --expect) expected=$2 ;;
    --picture) picture=$2 ;;
    --size) size=$2 ;;
    *) echo "$0: unknown option $1" >&2; exit 2 ;;
  esac
  shift 2
done
title=$1
shift
take_own_home

fail()
{
  echo "FAILED: $*, in round $round, closed by $way, touched: $touched" >&2
  cat "$folder"/*.log >&2
  exit 1
}

is_there()
{
  window=$(xdotool search --onlyvisible --name "^$title" | head -n 1)
  [[ -n "$window" ]]
}

# Interactors ask for WM_DELETE_WINDOW when they begin to listen.
listens()
{
  xprop -id "$window" WM_PROTOCOLS | grep -q WM_DELETE_WINDOW
}

has_focus()
{
  wmctrl -i -a "$window"
  [[ "$(xdotool getwindowfocus)" == "$window" ]]
}

# Something is seen, and it has not changed for a second.
is_drawn()
{
  local before=$folder/before.png
  import -window "$window" "$before" && sleep 1 && import -window "$window" "$picture" &&
    [[ "$(identify -format %k "$picture")" -gt 1000 && "$(compare -metric AE "$before" "$picture" null: 2>&1)" == 0 ]]
}

# The pointer is on the volume: into it, and along its surface.
touch_volume()
{
  xdotool key t
  for _ in 1 2 3 4 5 6
  do
    xdotool click 4 mousemove_relative -- 2 1
    sleep 0.05
  done
  if [[ -n "$picture" ]]
  then
    wait_for "a frame with the hand in it" is_drawn
    picture=""
  fi
  xdotool mousemove_relative -- -6 2 mousemove_relative -- 3 -2
}

run_once()
{
  [[ -z "$expected" ]] || rm -f "$expected"
  "$@" > "$folder/program.log" 2>&1 &
  child=$!
  wait_for "a window named $title" is_there
  wait_for "an interactor that listens" listens
  wait_for "the keyboard's focus" has_focus
  local HEIGHT WIDTH
  if [[ -n "$size" ]]
  then
    timeout 10 xdotool windowsize --sync "$window" "$size" "$size" || true # one that has this size does not change
  fi
  eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=')"
  xdotool mousemove --window "$window" $((WIDTH / 2)) $((HEIGHT / 2))
  [[ $touched == no ]] || touch_volume
  if [[ $way == q ]]
  then
    xdotool key q
  else
    wmctrl -i -c "$window"
  fi
  expect_end
  [[ -z "$expected" || -s "$expected" ]] || fail "the program did not write $expected"
  echo "round $round, closed by $way, touched: $touched: ended with status 0"
}

# A window that asks to be mapped while openbox is starting is never mapped: openbox runs the startup command when it
# handles requests.
round=0 way=none touched=no
openbox --startup "touch $folder/managed" > "$folder/openbox.log" 2>&1 &
wait_for "a window manager" test -e "$folder/managed"
for ((round = 1; round <= rounds; ++round))
do
  for way in q manager
  do
    for touched in no yes
    do
      run_once "$@"
    done
  done
done
