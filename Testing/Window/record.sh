#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Lets the explorer play a demonstration, on a screen of its own: it touches the head, measures a point and a distance,
# takes a picture, records the touch, and closes. All of this is made into a movie. Checks all results, and loads the
# measurements into a second window.
#
# usage: record.sh PROGRAM VOLUME [--movie]
#
#   --movie   the program can write movies
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth python3" xvfb-run python3
take_own_screen "$@"
program=$(realpath "$1")
volume=$(realpath "$2")
movie=${3:-}
take_own_home
cd "$folder"

fail()
{
  echo "FAILED: $*" >&2
  cat "$folder"/*.log >&2 || true
  exit 1
}

measurements=head.csv
play()
{
  "$program" "$volume" --size 240 --measurements "$measurements" --script "$@" > "$folder/program.log" 2>&1 &
  child=$!
  expect_end
}

cat > demo.txt << END
# On the forehead, and to the side of it.
0.0  move 0.5 0.6
0.5  key t
1.0  wheel 4
2.5  key F10
3.0  key 1
3.1  key 2
3.2  stroke 0.56 0.6 1
4.8  key 2
5.0  key F10
5.1  key F12
6.0  key q
END
play demo.txt ${movie:+--movie demo.ogv}
[[ -s picture-001.png && -s touch-001.vtp ]] || fail "there is no picture or no recording"
grep -q "^1,Point 1,Point," head.csv || fail "no point was measured"
grep -q "^2,Distance 1,Distance," head.csv || fail "no distance was measured"

# Count the movie's frames by the position of Ogg's last page (RFC 3533). Theora splits the position into the number of
# the last key frame and the number of frames since then, which has 6 bits unless the header specifies another number
# (bytes 40 and 41, KFGSHIFT).
if [[ -n "$movie" ]]
then
  python3 - demo.ogv << 'END' || fail "the movie does not have 20 pictures for each of its six seconds"
import struct
import sys

data = open(sys.argv[1], "rb").read()
assert data[:4] == b"OggS"
header = data.index(b"\x80theora")
shift = (struct.unpack(">H", data[header + 40:header + 42])[0] >> 5) & 31
last = struct.unpack("<q", data[data.rindex(b"OggS") + 6:][:8])[0]
pictures = (last >> shift) + (last & ((1 << shift) - 1))
print(pictures, "pictures")
assert pictures >= 6 * 20 - 20, "the last second may be missing"
END
fi

# Load the measurements, remove one of them, and save the others.
printf '0.5 key Delete\n1.0 key q\n' > next.txt
play next.txt
grep -q "^1,Point 1,Point," head.csv || fail "the point was lost"
! grep -q "Distance 1" head.csv || fail "the distance is still there"

# Replay the recording. Its time must advance by keys, and automatically.
printf '0.5 key F7\n1.0 key F6\n1.5 key F5\n3.0 key F12\n3.5 key q\n' > look.txt
play look.txt --replay touch-001.vtp
[[ -s picture-002.png ]] || fail "there is no picture of the recording"
if "$program" "$volume" --size 240 --replay head.csv > "$folder/refused.log" 2>&1
then
  fail "a list of measurements is shown as a recording"
fi
grep -q "is not a recording of a touch" "$folder/refused.log" || fail "nobody tells what a recording is"

# A window without changes must not write the file.
before=$(stat -c %i head.csv)
printf '1.0 key q\n' > quit.txt
play quit.txt
[[ "$(stat -c %i head.csv)" == "$before" ]] || fail "the file was written anew without a change"

# An emptied list (here by one undo too many) must not replace the file.
printf '0.5 key Ctrl+z\n1.0 key q\n' > undo.txt
play undo.txt
grep -q "^1,Point 1,Point," head.csv || fail "an emptied list replaced the file"

# A list must not replace a file of 3D Slicer that was read only in part. Instead, it must be written to a new file
# beside it. The file follows Slicer's markups schema 1.0.3.
cat > slicer.mrk.json << END
{"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#",
 "markups": [
  {"type": "Fiducial", "coordinateSystem": "LPS", "coordinateUnits": "mm",
   "controlPoints": [{"id": "1", "label": "F-1", "position": [1, 2, 3], "positionStatus": "defined"}]},
  {"type": "ROI", "coordinateSystem": "LPS", "coordinateUnits": "mm", "roiType": "Box", "center": [0, 0, 0],
   "size": [10, 10, 10], "controlPoints": []}]}
END
cp slicer.mrk.json before.mrk.json
measurements=slicer.mrk.json
rm -f picture-001.png touch-001.vtp
play demo.txt
cmp slicer.mrk.json before.mrk.json || fail "a file that was not wholly read was replaced"
grep -q "F-1" slicer-001.mrk.json || fail "what was measured is not beside it"
grep -q "slicer.mrk.json stays as it is" program.log || fail "nobody was told"
