#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Presses a burr into a head in the explorer, on a screen of its own. The burr drills while the left button is pressed.
# Ctrl+E writes what was removed, Ctrl+Z brings it back, and Ctrl+Y removes it again. A picture shows the burr. On a
# busy machine, the force may pause, which divides a stroke. So each stroke is undone and done again more than once.
#
# usage: drill.sh PROGRAM VOLUME [--pictures FOLDER]
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth python3" xvfb-run python3
take_own_screen "$@"
program=$(realpath "$1")
volume=$(realpath "$2")
pictures=${4:+$(realpath "$4")}
size=${4:+700}
size=${size:-240}
take_own_home
cd "$folder"

fail()
{
  echo "FAILED: $*" >&2
  cat "$folder"/*.log >&2 || true
  exit 1
}

# The burr presses on the forehead. It must remove no tissue before the button is pressed and after its release.
cat > drill.txt << END
0.0  move 0.5 0.6
0.5  key t
1.0  wheel 6
2.0  key Ctrl+e
2.5  press left
3.0  stroke 0.54 0.6 1.5
5.0  key F12
5.5  release left
6.0  key Ctrl+e
6.5  key Ctrl+z
6.6  key Ctrl+z
6.7  key Ctrl+z
7.5  key Ctrl+e
8.0  key Ctrl+y
8.1  key Ctrl+y
8.2  key Ctrl+y
9.0  key Ctrl+e
9.5  key q
END
"$program" "$volume" --size "$size" --tool burr --script drill.txt > "$folder/program.log" 2>&1 &
child=$!
expect_end

grep -q "The hand holds a burr" program.log || fail "no burr is in the hand"
[[ $(grep -c "The burr has removed nothing yet" program.log) -eq 2 ]] ||
  fail "it removes without its button, or an undo leaves something"
grep -q "Burr stroke undone" program.log || fail "nothing was undone"
grep -q "Burr stroke redone" program.log || fail "nothing was done again"
[[ -s removal-001.vti && -s removal-002.vti ]] || fail "what was removed was not written"
cmp removal-001.vti removal-002.vti || fail "a redo does not bring back what was removed"
[[ -s picture-001.png ]] || fail "there is no picture"
[[ -z "$pictures" ]] || cp picture-001.png "$pictures/drill.png"
