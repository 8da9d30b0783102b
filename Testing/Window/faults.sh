#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Checks that the explorer refuses a bad device, tool or recording before it reads the volume. Then reads by OCR what a
# person sees in its window, on a screen of its own: the tool that the hand holds, a list of files beside a docked
# editor, the list of keys in a small window, and that vectors are felt by their magnitude. Another file opens in a
# window of the same size.
#
# usage: faults.sh EXPLORER VOLUME
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils imagemagick tesseract-ocr python3" xvfb-run openbox xdotool \
  wmctrl xprop import tesseract python3
take_own_screen "$@"
explorer=$(realpath "$1")
volume=$(realpath "$2")
take_own_home
cd "$folder"
mkdir data
cp "$volume" data/first.vti
cp "$volume" data/second.vti
touch broken.stl

# usage: refuses WORDS OPTION...
# Expects that the explorer refuses the options, with these words.
refuses()
{
  local words=$1 status=0
  shift
  "$explorer" data/first.vti "$@" > refused.log 2>&1 || status=$?
  [[ $status -eq 2 ]] || fail "$* ends with status $status"
  grep -q "$words" refused.log || fail "$* is not refused with '$words'"
  ! grep -q "^Reading" refused.log || fail "$* is refused only after the volume was read"
}
refuses 'There is no device "falkon"' --device falkon
refuses "can't be read" --tool broken.stl
refuses "there is no such file" --replay none.vtp
refuses "is not an option" --si

# usage: open FILE ARGUMENT...
open()
{
  "$explorer" "$@" > program.log 2>&1 &
  child=$!
  wait_for_window "VTK Volume Haptics"
}
close()
{
  xdotool key q
  expect_end
}
says()
{
  import -window "$window" screen.png
  convert screen.png -colorspace Gray -resize 300% -negate letters.pgm
  OMP_THREAD_LIMIT=1 tesseract letters.pgm - --psm 11 2> /dev/null | tr '\n' ' ' > read.log
  [[ "$(cat read.log)" =~ $1 ]]
}
find_size()
{
  xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=' | tr '\n' ' '
}
has_read()
{
  [[ "$(grep -c "^Reading .*$1\$" program.log)" == "$2" ]]
}
is_there_again()
{
  is_there && [[ "$(find_size)" == "$size" ]]
}

start_window_manager
open data/first.vti --size 600
xdotool windowsize --sync "$window" 720 540
xdotool windowmove --sync "$window" 300 200
xdotool mousemove --window "$window" 300 200
size=$(find_size)
xdotool key w
wait_for "the name of the tool" says "hand holds a needle"
xdotool key u F2
wait_for "a list of files beside the editor" says "Escape: back"
xdotool key Down Return
wait_for "the second volume" has_read second.vti 1
wait_for_window "VTK Volume Haptics"
wait_for "a window as large as the first one ($size)" is_there_again
close

# Open a list of keys that is too long for its window.
open data/first.vti --size 300
xdotool windowsize --sync "$window" 320 200
xdotool key question
wait_for "a part of the list of keys" says "wheel shows more"
xdotool mousemove --window "$window" 150 100
scroll()
{
  xdotool click 5 click 5 click 5 click 5 click 5
  says "The end"
}
wait_for "the end of the list of keys" scroll
close

# Write a flow around an axis.
python3 - > data/flow.vti << END
size = 16
print('<VTKFile type="ImageData"><ImageData WholeExtent="0 15 0 15 0 15" Origin="0 0 0" Spacing="1 1 1">'
      '<Piece Extent="0 15 0 15 0 15"><PointData Vectors="flow">'
      '<DataArray type="Float32" Name="flow" NumberOfComponents="3" format="ascii">')
for z in range(size):
    for y in range(size):
        for x in range(size):
            inside = (x - 8) ** 2 + (y - 8) ** 2 + (z - 8) ** 2 < 36
            print(*((8 - y, x - 8, 1) if inside else (0, 0, 0)))
print("</DataArray></PointData></Piece></ImageData></VTKFile>")
END
open data/flow.vti --size 800
wait_for "a word about vectors" says "magnitude of the vectors"
close
echo "read, refused and scrolled"
