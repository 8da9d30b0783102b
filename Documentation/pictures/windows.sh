#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Takes the pictures of windows, on a screen of its own: a hand is led by mouse and keys, and a picture is taken while it
# touches.
#
# usage: Documentation/pictures/windows.sh EXPLORER CT FOLDER [PYTHON]
#
#   EXPLORER  the program volumehaptics-explore
#   CT        the CT of a head that Examples/explore.sh fetches, build/explore/data/Cranium.mhd: head.png, cut.png,
#             measurements.png and editor.png are of it
#   FOLDER    where the pictures go
#   PYTHON    one that has the package, PyVista, pyvistaqt and PyQt5: touch_live.jpg and qt_window.jpg, too
#
# On a computer that is busy with something else a force may fade meanwhile, which a picture then tells: look at them.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [[ $# -lt 3 ]]
then
  sed -n '5,17s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 2
fi
# shellcheck source=../../Testing/Window/own-screen.sh
source "$root/Testing/Window/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils imagemagick" \
  xvfb-run openbox xdotool wmctrl xprop import convert identify compare
take_own_screen "$@"
explorer=$(realpath "$1")
volume=$(realpath "$2")
pictures=$(realpath "$3")
python=${4:+$(realpath -s "$4")}
take_own_home
cd "$folder"
start_window_manager

# usage: explore NAME [OPTION...] < SCRIPT
# The picture that a demonstration in the explorer's window takes, see Documentation/recording.md.
explore()
{
  local name=$1
  shift
  cat > "$name.txt"
  rm -rf picture-*.png "$XDG_STATE_HOME" # what was not saved is not offered
  "$explorer" "$volume" --size 1000 "$@" --script "$name.txt" > "$folder/explorer.log" 2>&1 &
  child=$!
  wait_for "the program's end" has_ended
  wait "$child" || fail "the explorer ended with an error"
  child=""
  mv picture-001.png "$pictures/$name.png"
  echo "$pictures/$name.png"
}

explore head << 'END'
0.0 move 0.60 0.62
4.0 key t
6.0 wheel 5
8.0 stroke 0.72 0.60 2
10.2 stroke 0.70 0.48 2.5
15.5 key F12
17.0 key q
END

explore cut --cut box << 'END'
0.0 move 0.60 0.60
2.0 key z        # the faces of the cut hold
4.0 key t
6.0 wheel 4
8.0 stroke 0.66 0.68 2
10.5 stroke 0.52 0.64 3
13.8 key F12
15.0 key q
END

explore measurements << 'END'
0.0 move 0.46 0.62
2.0 key t
4.0 wheel 4
6.0 key 2        # a distance
7.0 stroke 0.62 0.68 2
12.0 key 2
13.0 stroke 0.44 0.52 2
18.0 key 4       # a path
19.0 stroke 0.50 0.55 1.5
21.0 stroke 0.58 0.53 1.5
26.0 key 4
27.0 stroke 0.72 0.66 1.5
31.0 key 3       # an angle
32.0 stroke 0.66 0.57 1.5
36.0 key 3
37.0 stroke 0.77 0.56 1.5
41.0 key 3
42.0 stroke 0.66 0.38 1.5
46.0 key 5       # an area
47.0 stroke 0.70 0.40 1
48.5 stroke 0.74 0.37 1
50.0 stroke 0.70 0.35 1
51.5 stroke 0.67 0.37 1
56.0 key 5
57.0 stroke 0.80 0.42 1.5
61.0 key 1       # a point
62.0 stroke 0.80 0.50 1.5
74.0 key F12
75.0 key q
END

explore editor << 'END'
0.0 move 0.60 0.80
1.0 key v
1.5 key u        # below the scene
2.5 key n
3.2 key n
4.0 key n        # surface strength
5.2 key g
5.5 key t
7.0 wheel 4
8.5 stroke 0.68 0.76 2
11.0 stroke 0.62 0.82 2
16.0 key F12
17.0 key q
END

# Whether the window has something in it, and has not changed for six seconds, in which a frame is drawn also in software.
is_drawn()
{
  import -window "$window" "$folder/before.png" && sleep 6 && import -window "$window" "$folder/window.png" &&
    [[ "$(identify -format %k "$folder/window.png")" -gt 1000 ]] &&
    [[ "$(compare -metric AE "$folder/before.png" "$folder/window.png" null: 2>&1)" == 0 ]]
}

# Runs a script with frames as fine as those of a graphics card, however long that takes in software.
cat > finely.py << 'END'
import runpy
import sys

import volumehaptics.pyvista

add_haptics = volumehaptics.pyvista.add_haptics


def add_fine_haptics(*words, **settings):
    haptics = add_haptics(*words, **settings)
    haptics.style.AutoAdjustVolumeQualityOff()
    haptics.device.SetAttentionTime(600.0)
    return haptics


volumehaptics.pyvista.add_haptics = add_fine_haptics
sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name="__main__")
END

# usage: touch_window NAME TITLE WORD...
# The picture of a script's window, 720 pixels wide, while a hand is led over its middle.
touch_window()
{
  "$python" -B "${@:3}" > "$folder/script.log" 2>&1 &
  child=$!
  wait_for_window "$2"
  local HEIGHT WIDTH
  timeout 10 xdotool windowsize --sync "$window" 720 540 || true
  eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=')"
  xdotool mousemove --window "$window" $((WIDTH * 52 / 100)) $((HEIGHT * 40 / 100))
  wait_for "a first frame" is_drawn
  xdotool key t
  sleep 1
  wait_for "a frame with the hand in it" is_drawn
  for _ in 1 2 3 4 5
  do
    xdotool click 4
    sleep 1
  done
  for ((step = 0; step < 8; ++step))
  do
    xdotool mousemove_relative -- 2 0
    sleep 0.3
  done
  sleep 1
  wait_for "a frame at rest" is_drawn
  convert "$folder/window.png" -resize 720x -quality 92 "$pictures/$1.jpg"
  echo "$pictures/$1.jpg"
  xdotool key Escape
  wmctrl -i -c "$window"
  wait_for "the program's end" has_ended
  child=""
}

if [[ -n "$python" ]]
then
  touch_window touch_live "PyVista" finely.py "$root/Examples/PyVista/touch_live.py"
  # Not finely: Qt has no time for the mouse then.
  touch_window qt_window "Touch in pyvistaqt" "$root/Examples/PyVista/qt_window.py"
fi
