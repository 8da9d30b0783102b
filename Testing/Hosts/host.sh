#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Touches a volume in the window of another project's program. The program runs on a screen of its own, with a window
# manager; drive.py drives it.
#
# usage: host.sh PYTHON PROGRAM [VOLUME PICTURE]
#
#   PYTHON   has the package volumehaptics and the program's libraries; for f3d: the value of VTK_AUTOLOAD_PATH
#   PROGRAM  one of programs/, or f3d
#   VOLUME   a CT of a head (.mhd); a PICTURE is taken of its window while it is touched
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=../Window/own-screen.sh
source "$here/../Window/own-screen.sh"
require_programs "xvfb xauth openbox xdotool wmctrl x11-utils imagemagick" xvfb-run openbox xdotool wmctrl import
declare -A packages=([wx]=python3-wxgtk4.0 [tk]=python3-tk [invesalius]=invesalius [f3d]=f3d [trame]=chromium)
if [[ -n ${packages[$2]:-} ]] && ! dpkg -s "${packages[$2]}" > /dev/null 2>&1
then
  echo "SKIPPED: this takes Debian's package ${packages[$2]}"
  exit 77
fi
take_own_screen "$@"
take_own_home
start_window_manager
mkdir "$folder/state"
PYTHONUNBUFFERED=1 python3 -B "$here/drive.py" "$1" "$2" "$folder/state" "${@:3}"
