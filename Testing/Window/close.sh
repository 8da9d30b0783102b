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

for program in xvfb-run openbox xdotool wmctrl xprop
do
  if ! command -v "$program" > /dev/null
  then
    echo "SKIPPED: closing a window by hand takes $program, which is not installed. Testing/run.sh installs it, or:" \
      "apt-get install --no-install-recommends xvfb xauth openbox xdotool wmctrl x11-utils"
    exit 77
  fi
done
if [[ -z "${CLOSE_SCREEN:-}" ]]
then
  CLOSE_SCREEN=own exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "${BASH_SOURCE[0]}" "$@"
fi

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
folder=$(mktemp -d)
export HOME=$folder XDG_CONFIG_HOME=$folder XDG_CACHE_HOME=$folder

# A window that asks to be mapped while openbox is starting is never mapped: openbox runs the startup command when it
# handles requests.
openbox --startup "touch $folder/managed" > "$folder/openbox.log" 2>&1 &
manager=$!
child=""
clean_up()
{
  local process
  for process in "$child" "$manager"
  do
    [[ -z "$process" ]] || { kill -9 "$process" && wait "$process"; } 2> /dev/null || true
  done
  rm -rf "$folder"
}
trap clean_up EXIT
for ((i = 0; i < 600; ++i))
do
  [[ ! -e "$folder/managed" ]] || break
  sleep 0.1
done
if [[ ! -e "$folder/managed" ]]
then
  echo "FAILED: openbox did not start within a minute" >&2
  cat "$folder/openbox.log" >&2
  exit 1
fi

fail()
{
  echo "FAILED: $*, in round $round, closed by $way, touched: $touched" >&2
  cat "$folder/program.log" >&2
  exit 1
}

# Runs a command until it succeeds, for as long as the program lives; a minute at most.
wait_for()
{
  local what=$1 i
  shift
  for ((i = 0; i < 600; ++i))
  do
    if "$@" > /dev/null 2>&1
    then
      return 0
    fi
    kill -0 "$child" 2> /dev/null || fail "the program ended before $what"
    sleep 0.1
  done
  fail "$what did not come about within a minute"
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

has_ended()
{
  ! kill -0 "$child" 2> /dev/null
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
  local status=0 i
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
  for ((i = 0; i < 600; ++i))
  do
    has_ended && break
    sleep 0.1
  done
  has_ended || fail "the program did not end within a minute"
  wait "$child" || status=$?
  child=""
  [[ $status -eq 0 ]] || fail "the program ended with status $status"
  [[ -z "$expected" || -s "$expected" ]] || fail "the program did not write $expected"
  echo "round $round, closed by $way, touched: $touched: ended with status 0"
}

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
