#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Opens another file in the explorer's window, with real key events on a screen of its own: by the list of key F2, and
# by dropping it on the window. A broken file leaves the window with its old contents. Then the window shows a label map
# as labels, and the series of a DICOM folder one after the other.
#
# usage: open.sh [--picture FOLDER] EXPLORER VOLUME DROP_FILE PYTHON
#
#   --picture FOLDER   takes pictures of the lists; needs imagemagick
#   DROP_FILE          the program of DropFile.cxx
#   PYTHON             a Python that has VTK; it writes the label map and DICOM files
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils" xvfb-run openbox xdotool wmctrl xprop
take_own_screen "$@"
pictures=""
if [[ "$1" == --picture ]]
then
  pictures=$(realpath "$2")
  shift 2
fi
explorer=$(realpath "$1")
volume=$(realpath "$2")
drop=$(realpath "$3")
python=$4
take_own_home
cd "$folder"

# usage: has_read NAME TIMES
# Succeeds if the program has said TIMES times that it reads the file NAME.
has_read()
{
  [[ "$(grep -c "^Reading .*$1\$" program.log)" == "$2" ]]
}
take_picture()
{
  [[ -z "$pictures" ]] || { sleep 0.7 && import -window "$window" "$pictures/$1.png"; }
}

mkdir data data/deeper
cp "$volume" data/first.vti
cp "$volume" data/second.vti
cp "$volume" data/deeper/third.vti
echo "no volume" > data/zebra.vti
"$python" - << 'END'
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
image = vtkImageData()
image.SetDimensions(40, 40, 40)
image.AllocateScalars(3, 1)  # unsigned char
values = image.GetPointData().GetScalars()
for i in range(values.GetNumberOfTuples()):
    x, y, z = i % 40 - 19.5, i // 40 % 40 - 19.5, i // 1600 - 19.5
    r = (x * x + y * y + z * z) ** 0.5
    values.SetValue(i, 0 if r > 17 else 7 if x > 0 else 2)
values.SetName("labels")
writer = vtkXMLImageDataWriter()
writer.SetFileName("data/deeper/labels.vti")
writer.SetInputData(image)
writer.Write()
END

# Write a folder with two DICOM series according to parts 5 and 10 of the standard: a ball, and a box with fewer slices.
mkdir scan
"$python" - << 'END'
import struct


def part(group, element, kind, value):
    value += b"" if len(value) % 2 == 0 else b"\0" if kind == b"UI" else b" "
    length = struct.pack("<xxI" if kind == b"OW" else "<H", len(value))
    return struct.pack("<HH", group, element) + kind + length + value


def number(element, value):
    return part(0x0028, element, b"US", struct.pack("<H", value))


SIDE, CT, EXPLICIT = 40, b"1.2.840.10008.5.1.4.1.1.2", b"1.2.840.10008.1.2.1"
for series, (name, slices, is_inside) in enumerate((
        (b"Ball", 40, lambda i, j, k: (i - 20) ** 2 + (j - 20) ** 2 + (k - 20) ** 2 < 225),
        (b"Box", 30, lambda i, j, k: max(abs(i - 20), abs(j - 20), abs(k - 15)) < 12)), 1):
    for k in range(slices):
        pixels = b"".join(struct.pack("<H", 1064 if is_inside(i, j, k) else 24)
                          for j in range(SIDE) for i in range(SIDE))
        meta = part(2, 2, b"UI", CT) + part(2, 0x10, b"UI", EXPLICIT)
        with open(f"scan/{series}-{k}.dcm", "wb") as file:
            file.write(bytes(128) + b"DICM" + part(2, 0, b"UL", struct.pack("<I", len(meta))) + meta
                       + part(8, 0x16, b"UI", CT) + part(8, 0x18, b"UI", b"1.2.%d.%d" % (series, k))
                       + part(8, 0x60, b"CS", b"CT") + part(8, 0x103E, b"LO", name)
                       + part(0x20, 0x0E, b"UI", b"1.2.%d" % series) + part(0x20, 0x11, b"IS", b"%d" % series)
                       + part(0x20, 0x32, b"DS", b"0\\0\\%d" % k) + part(0x20, 0x37, b"DS", b"1\\0\\0\\0\\1\\0")
                       + number(2, 1) + part(0x28, 4, b"CS", b"MONOCHROME2") + number(0x10, SIDE) + number(0x11, SIDE)
                       + part(0x28, 0x30, b"DS", b"1\\1") + number(0x100, 16) + number(0x101, 16) + number(0x102, 15)
                       + number(0x103, 0) + part(0x28, 0x1052, b"DS", b"-1024") + part(0x28, 0x1053, b"DS", b"1")
                       + part(0x7FE0, 0x10, b"OW", pixels))
END

start_window_manager
"$explorer" data/first.vti --size 300 > program.log 2>&1 &
child=$!
wait_for "the first volume" has_read first.vti 1
wait_for_window "VTK Volume Haptics"

# The list consists of this folder, its parent, deeper/, and then the files. The present file is marked.
xdotool key F2
take_picture list
xdotool key Down Return
wait_for "the second volume" has_read second.vti 1
wait_for_window "VTK Volume Haptics"
xdotool key F2 Down Return
wait_for "the broken volume" has_read zebra.vti 1
wait_for "the second volume again" has_read second.vti 2
wait_for_window "VTK Volume Haptics"
take_picture broken
grep -q "Cure: " program.log || fail "nobody tells what is wrong with the broken volume"

"$drop" "$window" "$folder/data/deeper/third.vti" || fail "the window takes no file that is dropped"
wait_for "the dropped volume" has_read third.vti 1
wait_for_window "VTK Volume Haptics"
# In the folder deeper, move up in the list, past this folder and its parent, to the label map at the end.
xdotool key F2 Up Return
wait_for "the label map" has_read labels.vti 1
wait_for_window "VTK Volume Haptics"
take_picture values
xdotool key F4
wait_for "the labels" has_read labels.vti 2
wait_for_window "VTK Volume Haptics"
take_picture labels
grep -q "its values are taken as labels: 2" program.log || fail "the labels are not counted"

# The series with the most slices must be opened first. The key F3 lists both.
"$drop" "$window" "$folder/scan" || fail "the window takes no folder that is dropped"
wait_for "the ball" has_read scan 1
wait_for_window "VTK Volume Haptics"
grep -q "series 1.*Ball.*, of 2 series" program.log || fail "the ball's series is not shown"
xdotool key F3
take_picture series
xdotool key Down Return
wait_for "the box" has_read scan 2
wait_for_window "VTK Volume Haptics"
grep -q "series 2.*Box.*, of 2 series" program.log || fail "the box's series is not shown"

# Escape must close only the list.
xdotool key F2 Escape
xdotool key q
expect_end
echo "opened by a list, by a drop, as labels, and as series"
