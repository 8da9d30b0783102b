#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Plays a newcomer who knows only what the explorer's window says: starts the explorer, reads the screen (by OCR), does
# what the text says until a force is felt, strokes, lets go, looks at the list of keys, and closes the window as the
# list says. The script knows no key: all keys come from the screen.
#
# usage: newcomer.sh PROGRAM VOLUME [--pictures FOLDER]
#
#   --pictures FOLDER  keeps the pictures and the texts that were read
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils imagemagick tesseract-ocr" xvfb-run openbox xdotool \
  wmctrl xprop import tesseract
take_own_screen "$@"
program=$(realpath "$1")
volume=$(realpath "$2")
pictures=""
[[ "${3:-}" != --pictures ]] || pictures=$(realpath "$4")
take_own_home

fail()
{
  echo "FAILED: $*. The screen says:" >&2
  cat "$folder/read.txt" "$folder"/*.log >&2 || true
  exit 1
}

take_picture()
{
  import -window "$window" "$folder/screen.png"
}

# Reads the text in the screenshot, or in one of its columns, with spaces instead of line ends. $1 is tesseract's mode:
# 11 for scattered text, 6 for rows. The enlarged image is not compressed, because compression would take four times as
# long as reading it.
read_picture()
{
  convert "$folder/screen.png" -crop "${2:-100%x100%+0+0}" +repage -colorspace Gray -resize 300% -negate \
    "$folder/letters.pgm"
  OMP_THREAD_LIMIT=1 tesseract "$folder/letters.pgm" - --psm "$1" 2> /dev/null | tr '\n' ' ' > "$folder/read.txt"
}

# Succeeds if the screenshot (or, by says, the screen) contains text that matches $1. Sets $said to the first group of
# the match.
picture_says()
{
  read_picture "${2:-11}" "${@:3}"
  [[ "$(cat "$folder/read.txt")" =~ $1 ]] && said=${BASH_REMATCH[1]:-}
}
says()
{
  take_picture
  picture_says "$@"
}
says_not()
{
  ! says "$1"
}

step=0
expect()
{
  wait_for "$1" "${@:2}"
  step=$((step + 1))
  echo "$step. $1${said:+: $said}"
  [[ -z "$pictures" ]] || cp "$folder/screen.png" "$pictures/newcomer-$step.png"
}

# Presses a key, which is given by its name on the screen.
press()
{
  case $1 in
    \?) xdotool key question ;;
    *) xdotool key "$1" ;;
  esac
}

said=""
start_window_manager
"$program" "$volume" --size 700 > "$folder/program.log" 2>&1 &
child=$!
wait_for_window "VTK Volume Haptics"
eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=')"

expect "says how to begin" says 'pointer on the volume and press ([a-z])'
press_to_touch=$said
xdotool mousemove --window "$window" $((WIDTH / 2)) $((HEIGHT / 2))
press "$press_to_touch"
expect "says how to go on" says 'mouse to stroke, turn the (wheel) to press'
expect "says how to let go" says '(Escape) lets go'
let_go=$said

# Turns the wheel in both directions, because a new user does not know which direction presses.
feels()
{
  xdotool click 4
  sleep 0.3
  says '(0[.][1-9][0-9]*|[1-9][.][0-9]+) N of at most'
}
expect "says which force is felt" feels
says '(Resting on|Sliding over|Pushed through|Force of) [a-z]+' || fail "it does not say what is touched"

# Takes a screenshot while the hand moves back and forth.
stroke()
{
  local i way
  for way in 3 -3 3 -3
  do
    for ((i = 0; i < 12; ++i))
    do
      xdotool mousemove_relative -- $way 0
      sleep 0.03
    done
  done
}
slides()
{
  local hand
  stroke &
  hand=$!
  sleep 0.6
  take_picture
  wait "$hand"
  picture_says '(Sliding over [a-z]+), [0-9.]+ N of at most'
}
expect "says that a stroke slides" slides

press "$let_go"
expect "says how to begin again" says "press ($press_to_touch)"
says_not ' N of at most' || fail "a force is still told after $let_go"
said=""
expect "says where the keys are" says '([?]) shows all keys'
press "$said"
# Enlarge the window to read the small letters of a long list. The list has two columns.
wmctrl -i -r "$window" -b add,maximized_vert,maximized_horz
reads_columns()
{
  local WIDTH HEIGHT
  eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=')"
  take_picture
  picture_says '(touch what is under the pointer)' 6 "$((WIDTH / 2))x$HEIGHT+0+0" &&
    picture_says ' ([a-z]) close ' 6 "$((WIDTH / 2))x$HEIGHT+$((WIDTH / 2))+0"
}
expect "lists the keys, and says how to close" reads_columns
press "$said"
expect_end
echo "closed"
