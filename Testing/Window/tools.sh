#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Pushes a needle into a head in the explorer, on a screen of its own, and draws it out. Ctrl+E writes the needle's
# track while the needle is in tissue, and has no track to write before and after. Then a tool from a file, whose
# triangles face inwards, is pressed into the head, turned, and changed for the other tools by key w. Pictures show that
# the tool is drawn and moves.
#
# usage: tools.sh PROGRAM VOLUME
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth python3" xvfb-run python3
take_own_screen "$@"
program=$(realpath "$1")
volume=$(realpath "$2")
take_own_home
cd "$folder"

fail()
{
  echo "FAILED: $*" >&2
  cat "$folder"/*.log >&2 || true
  exit 1
}

# usage: run NAME TOOL
# Plays NAME.txt with a tool, and writes NAME.log.
run()
{
  "$program" "$volume" --size 240 --tool "$2" --script "$1.txt" > "$folder/$1.log" 2>&1 &
  child=$!
  expect_end
  # Fail if VTK has reported an error.
  if grep -q "ERR|" "$1.log"
  then
    fail "there are errors with the tool $2"
  fi
}

cat > needle.txt << END
0.0  move 0.5 0.6
0.5  key t
1.5  key Ctrl+e
2.0  key F12
2.5  wheel 6
4.5  key Ctrl+e
5.0  key F12
5.5  wheel -14
7.5  key Ctrl+e
8.0  key q
END
run needle needle
grep -q "The hand holds a needle" needle.log || fail "no needle is in the hand"
[[ $(grep -c "No track: the needle is not in tissue" needle.log) -eq 2 ]] ||
  fail "it has a track in air, or is stuck in tissue"
grep -q "Written: .*/track-001.vtp" needle.log || fail "its track was not written"
[[ $(grep -c 'Name="ForbiddenTouches"' track-001.vtp) -eq 1 ]] || fail "its track has no forbidden touches"
! cmp -s picture-001.png picture-002.png || fail "nothing of it is seen"

# Prints a facet of a tetrahedron in the format of .stl files.
facet()
{
  printf 'facet normal 0 0 0\nouter loop\n'
  printf 'vertex %s\n' "$@"
  printf 'endloop\nendfacet\n'
}
{
  echo "solid probe"
  facet "0 0 0" "4 -3 10" "4 3 10"
  facet "0 0 0" "4 3 10" "-5 0 10"
  facet "0 0 0" "-5 0 10" "4 -3 10"
  facet "4 -3 10" "-5 0 10" "4 3 10"
  echo "endsolid probe"
} > probe.stl
cat > shape.txt << END
0.0  move 0.5 0.6
0.5  key t
1.5  key F12
2.0  wheel 6
4.0  key F12
4.5  stroke 0.54 0.6 1
6.5  key F12
7.0  key w
7.5  key w
8.0  key w
8.5  key w
9.0  key q
END
run shape probe.stl
[[ $(grep -c "The hand holds a tool with a shape" shape.log) -eq 2 ]] || fail "no shape is in the hand, or not again"
for tool in point needle burr
do
  grep -q "The hand holds a $tool" shape.log || fail "key w does not get to a $tool"
done
! cmp -s picture-003.png picture-004.png || fail "nothing is seen of the press of a shape"
! cmp -s picture-004.png picture-005.png || fail "a shape is not stroked"
