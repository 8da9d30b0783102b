#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Uses the explorer by its buttons and menus alone, with real mouse events on a screen of its own: touches and holds,
# measures, undoes, saves, and chooses another preset, a cut, slices, a picture, a recording and a tool. Opens another
# file by the desktop's dialog (a stand-in program chooses at once), and a recent file. Then Ctrl+O opens the dialog,
# too. If the dialog fails or can't open its window, a list in the explorer's window takes its place. While a dialog
# waits, the explorer handles signals as before, closes, and ends on SIGTERM. A picture that is taken while the mouse
# moves shows the volume.
#
# usage: buttons.sh [--pictures FOLDER] EXPLORER VOLUME
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils imagemagick" xvfb-run openbox xdotool wmctrl xprop compare
take_own_screen "$@"
pictures=""
if [[ "$1" == --pictures ]]
then
  pictures=$(realpath "$2")
  shift 2
fi
explorer=$(realpath "$1")
volume=$(realpath "$2")
take_own_home
cd "$folder"
mkdir bin data
cp "$volume" data/first.vti
cp "$volume" data/second.vti
cat > bin/zenity << END
#!/bin/sh
echo "\$*" >> "$folder/dialogs"
case \$(cat "$folder/manner") in
  choose) echo "$folder/data/second.vti" ;;
  fail) exit 127 ;;
  refuse) exit 1 ;; # as zenity does without a screen
  wait) echo \$\$ > "$folder/dialog" && exec sleep 300 ;;
esac
END
echo choose > manner
chmod +x bin/zenity
export PATH=$folder/bin:$PATH

# In a window of this width, the bar's buttons have no labels, and share the width equally. Menus have lines of 19
# pixels below a margin of 8 pixels. The first line is the title.
size=390
button_width=$((size / 13))
go()
{
  xdotool mousemove --window "$window" "$1" "$2"
}
click_button()
{
  go $(($1 * button_width + button_width / 2)) $((button_width / 2))
  xdotool click 1
}
choose()
{
  click_button "$1"
  if [[ -n "$pictures" ]]
  then
    sleep 1 # until the menu is drawn
    import -window "$window" "$pictures/menu-$1.png"
  fi
  xdotool mousemove_relative -- 20 $((button_width / 2 + 8 + $2 * 19 + 9))
  xdotool click 1
}
FILE=1 TOUCH=2 HOLD=3 PRESET=5 TOOL=6 CUT=7 SLICES=8 MEASURE=9 RECORD=10
has_read()
{
  [[ "$(grep -c "^Reading .*$1\$" program.log)" == "$2" ]]
}
count_positions()
{
  grep -o '"position"' measurements-001.mrk.json | wc -l
}

start_window_manager
"$explorer" data/first.vti --size $size > program.log 2>&1 &
child=$!
wait_for_window "VTK Volume Haptics: first.vti"

# Hold the hand where it presses, so that the pointer can go to the buttons without the hand. The servo takes its time
# for a press. On a busy machine, the events of a press may come in one frame, so that nothing is touched; then try
# again.
press_hold_and_measure()
{
  click_button $HOLD # also begins the touch
  go $((size * 55 / 100)) 140
  xdotool click --repeat 6 --delay 120 4
  sleep 1
  xdotool click 1
  choose $MEASURE 1
  choose $FILE 1
}
has_positions()
{
  [[ $(count_positions) -eq $1 ]]
}
has_measured()
{
  press_hold_and_measure
  for _ in 1 2 3 4 5 6 7 8 9 10
  do
    [[ ! -s measurements-001.mrk.json ]] || return 0
    sleep 0.3
  done
  click_button $TOUCH # lets go
  return 1
}
wait_for "a press that can be measured" has_measured
wait_for "a file with a point" has_positions 1
choose $MEASURE 1
choose $MEASURE 1
choose $MEASURE 6 # undo
choose $FILE 1
wait_for "a file with two points, of which one was undone" has_positions 2

choose $PRESET 8
wait_for "the first preset" test -s preset-001.json
choose $PRESET 2
choose $PRESET 8
wait_for "the second preset" test -s preset-002.json
! cmp -s preset-001.json preset-002.json || fail "another preset changes nothing"
xdotool key Escape

picture=0
take_picture()
{
  "$@"
  picture=$((picture + 1))
  last=$(printf 'picture-%03d.png' $picture)
  wait_for "picture $picture" is_complete "$last"
}
is_complete()
{
  [[ "$(tail -c 8 "$1")" == *IEND* ]]
}
# usage: shows_same FIRST SECOND
# Succeeds if two pictures show the same cheek, which no text covers.
shows_same()
{
  local different
  different=$(compare -metric AE -fuzz 10% -extract 30x40+236+190 "$1" "$2" null: 2>&1) || true
  echo "$different of 1200 pixels of $1 and $2 differ"
  [[ ${different%%.*} -lt 300 ]]
}
# The picture shows a whole frame, so that each command changes it.
take_picture choose $RECORD 3
whole=$last
choose $CUT 2
take_picture choose $RECORD 3
! cmp -s "$whole" "$last" || fail "a cut changes nothing in the picture"
click_button $SLICES
before=$last
take_picture choose $RECORD 3
! cmp -s "$before" "$last" || fail "slices change nothing in the picture"
click_button $SLICES
choose $CUT 1

# Input interrupts a frame, but not that of a picture.
move_on()
{
  while xdotool mousemove_relative 2 0 mousemove_relative -- -2 0
  do
    :
  done
}
go $((size / 2)) $((size / 2))
move_on &
mover=$!
for _ in 1 2 3
do
  take_picture xdotool key F12
  shows_same "$whole" "$last" || fail "a picture that is taken while the mouse moves lacks the volume"
done
kill $mover
choose $RECORD 2
sleep 1
choose $RECORD 2
wait_for "a recording" test -s touch-001.vtp
choose $TOOL 3
wait_for "a burr" grep -q "The hand holds a burr" program.log
# Two quick presses of a key count as two: from the burr to the point and to the needle. A key that is held counts once.
has_held()
{
  [[ "$(grep -c "^The hand holds a" program.log)" -eq "$1" ]]
}
held=$(grep -c "^The hand holds a" program.log)
xdotool key --delay 4 w w
wait_for "two changes of the tool" has_held $((held + 2))
xdotool keydown w
sleep 1.5
xdotool keyup w
wait_for "a change by a held key" has_held $((held + 3))
sleep 0.5
has_held $((held + 3)) || fail "a held key changes the tool again and again"

choose $FILE 2
wait_for "the file of the dialog" has_read second.vti 1
wait_for_window "VTK Volume Haptics: second.vti"
grep -q -- "--filename=$folder/data/" dialogs || fail "the dialog does not begin in the folder of the file"
choose $FILE 4
wait_for "the recent file" has_read first.vti 2
wait_for_window "VTK Volume Haptics: first.vti"
xdotool key ctrl+o
wait_for "the file of the dialog again" has_read second.vti 2
wait_for_window "VTK Volume Haptics: second.vti"

echo fail > manner
# Chooses the file before or after the present one, once there is a list: the keys do nothing else.
# usage: list_gives KEY FILE TIMES
list_gives()
{
  xdotool key "$1" Return
  sleep 0.5
  has_read "$2" "$3"
}
xdotool key ctrl+o
wait_for "the file of the list" list_gives Up first.vti 3
wait_for_window "VTK Volume Haptics: first.vti"
echo refuse > manner
xdotool key ctrl+o
wait_for "the file of the list of a dialog without a window" list_gives Down second.vti 3
wait_for_window "VTK Volume Haptics: second.vti"

list_signals()
{
  grep SigCgt "/proc/$child/status"
}
open_waiting_dialog()
{
  local before
  before=$(list_signals)
  rm -f dialog
  xdotool key ctrl+o
  wait_for "a dialog" test -s dialog
  [[ "$(list_signals)" == "$before" ]] || fail "a dialog changes which signals are handled"
}
echo wait > manner
open_waiting_dialog
xdotool key q
PATIENCE=20 expect_end
! kill -0 "$(cat dialog)" 2> /dev/null || fail "the dialog stays when the window closes"
! grep -q "ERR|" program.log || fail "there are errors"
"$explorer" data/first.vti --size $size > ended.log 2>&1 &
child=$!
wait_for_window "VTK Volume Haptics: first.vti"
open_waiting_dialog
kill -TERM "$child"
PATIENCE=20 expect_end_with $((128 + 15))
kill "$(cat dialog)"
echo "touched, held, measured, cut, recorded and opened by buttons"
