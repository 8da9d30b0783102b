#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Opens a program's window on a screen of its own, with a window manager. Touches the contents with real mouse and key
# events, and closes the window in three ways: with the key q, by the window manager (WM_DELETE_WINDOW), and with
# SIGTERM. Each way is used in touch mode (armed, the tip moving), after Escape has let go, and without a touch. The
# program must end each time, with status 0, or by the signal.
#
# usage: close.sh [--rounds N] [--few | --touched] [--key KEY] [--felt TEXT] [--click] [--expect FILE] [--size PIXELS]
#          [--picture FILE] TITLE PROGRAM [ARGUMENT]...
#
#   --rounds N      repeats all seven cases N times (default 1)
#   --few           three of the seven cases: each way once; only the window manager closes it without a touch
#   --touched       three of the seven cases: each way while something is touched
#   --key KEY       closes the window with KEY instead of q
#   --felt TEXT     turns the wheel until the program writes TEXT, which means that something is felt
#   --click         clicks on the volume, which gives it the keyboard's focus
#   --expect FILE   expects that the program writes FILE anew each time its window is closed
#   --size PIXELS   sets the sides of the window, for machines that draw in software
#   --picture FILE  takes a picture of the window while something is touched; needs imagemagick
#   TITLE           title of the window, or its beginning
#
# The last line of the output is the number of windows that were closed. The script ends at the first crash.
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils" xvfb-run openbox xdotool wmctrl xprop
take_own_screen "$@"

rounds=1
# A signal ends the program in the same way with and without a touch, so one case is sufficient.
cases='q-no q-yes q-before manager-no manager-yes manager-before signal-yes'
key=q
felt=""
click=no
expected=""
picture=""
size=""
while [[ "$1" == --* ]]
do
  case "$1" in
    --few | --touched | --click)
      case "$1" in
        --few) cases='q-yes manager-no signal-yes' ;;
        --touched) cases='q-yes manager-yes signal-yes' ;;
        --click) click=yes ;;
      esac
      shift
      continue
      ;;
  esac
  case "$1" in
    --rounds) rounds=$2 ;;
    --key) key=$2 ;;
    --felt) felt=$2 ;;
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

# Succeeds if the window's contents have not changed for a second.
is_drawn()
{
  local before=$folder/before.png
  import -window "$window" "$before" && sleep 1 && import -window "$window" "$picture" &&
    [[ "$(identify -format %k "$picture")" -gt 1000 && "$(compare -metric AE "$before" "$picture" null: 2>&1)" == 0 ]]
}

# With the pointer on the volume, presses into the volume, and slides along its surface.
touch_volume()
{
  [[ $click == no ]] || xdotool click 1
  xdotool key t
  for _ in 1 2 3 4 5 6
  do
    xdotool click 4 mousemove_relative -- 2 1
    sleep 0.05
  done
  [[ -z "$felt" ]] || wait_for "a force" feels
  if [[ -n "$picture" ]]
  then
    wait_for "a frame with the hand in it" is_drawn
    picture=""
  fi
  xdotool mousemove_relative -- -6 2 mousemove_relative -- 3 -2
}

# After a stall of the machine, the force is cut off, as required. Start a new touch with Escape and t.
tries=0
feels()
{
  grep -qF "$felt" "$folder/program.log" && return
  tries=$((tries + 1))
  if ((tries % 20 == 0))
  then
    xdotool key Escape
    sleep 0.2
    xdotool key t
    sleep 0.2
  fi
  xdotool click 4
  return 1
}

run_once()
{
  [[ -z "$expected" ]] || rm -f "$expected"
  "$@" > "$folder/program.log" 2>&1 &
  child=$!
  wait_for_window "$title"
  local HEIGHT WIDTH
  if [[ -n "$size" ]]
  then
    timeout 10 xdotool windowsize --sync "$window" "$size" "$size" || true # a window that already has this size does
                                                                           # not change
  fi
  eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=')"
  xdotool mousemove --window "$window" $((WIDTH / 2)) $((HEIGHT / 2))
  [[ $touched == no ]] || touch_volume
  [[ $touched != before ]] || xdotool key Escape
  case $way in
    q) xdotool key "$key" ;;
    manager) wmctrl -i -c "$window" ;;
    signal) kill -TERM "$child" ;;
  esac
  if [[ $way == signal ]]
  then
    expect_end_with $((128 + 15))
  else
    expect_end
    [[ -z "$expected" || -s "$expected" ]] || fail "the program did not write $expected"
  fi
  closes=$((closes + 1))
  echo "round $round, closed by $way, touched: $touched: ended as it should"
}

round=0 way=none touched=no
start_window_manager
closes=0
for ((round = 1; round <= rounds; ++round))
do
  for one in $cases
  do
    way=${one%-*} touched=${one#*-}
    run_once "$@"
  done
done
echo "$closes windows closed, 0 crashes"
