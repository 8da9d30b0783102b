# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Functions for the scripts of this folder: run a program in a window on a separate screen, and wait for it.
#
#   require_programs "Debian's packages" PROGRAM...
#   take_own_screen "$@"
#   take_own_home
#   "$program" > "$folder/program.log" 2>&1 &
#   child=$!
#   wait_for "a window" xdotool search --onlyvisible --name "$title"
#
# A script may define a fail() of its own afterwards, which tells a text and ends it.

fail()
{
  echo "FAILED: $*" >&2
  cat "$folder"/*.log >&2
  exit 1
}

# Exits with 77, which CTest counts as skipped, if a program is not installed.
require_programs()
{
  local packages=$1 program
  shift
  for program in "$@"
  do
    if ! command -v "$program" > /dev/null
    then
      echo "SKIPPED: this takes $program, which is not installed. Testing/run.sh installs it, or:" \
        "apt-get install --no-install-recommends $packages"
      exit 77
    fi
  done
}

# Restarts the script on a separate X server.
take_own_screen()
{
  if [[ -z "${OWN_SCREEN:-}" ]]
  then
    OWN_SCREEN=yes exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$0" "$@"
  fi
  unset OWN_SCREEN
}

# Uses a temporary home in $folder, so that the user's settings are neither read nor written. When the script ends, the
# folder and the script's processes are removed.
take_own_home()
{
  folder=$(mktemp -d)
  export HOME=$folder XDG_CONFIG_HOME=$folder XDG_CACHE_HOME=$folder XDG_STATE_HOME=$folder/state
  trap clean_up EXIT
}
clean_up()
{
  local process
  for process in $(jobs -p)
  do
    { kill -9 "$process" && wait "$process"; } 2> /dev/null || true
  done
  rm -rf "$folder"
}

child=""
has_ended()
{
  ! kill -0 "$child" 2> /dev/null
}

# Runs a command until it succeeds. Fails if the program (if one was started) ends first, or after two minutes
# ($PATIENCE seconds, for programs that start slowly on a busy machine).
wait_for()
{
  local what=$1 until=$((SECONDS + ${PATIENCE:-120}))
  shift
  until "$@" > /dev/null 2>&1
  do
    [[ -z "$child" ]] || ! has_ended || fail "the program ended before $what"
    [[ $SECONDS -lt $until ]] || fail "$what did not come about within ${PATIENCE:-120} seconds"
    sleep 0.1
  done
}

# Waits until openbox runs the startup command, and thus handles requests. Openbox never maps a window that sends its
# request while openbox starts.
start_window_manager()
{
  openbox --startup "touch $folder/managed" > "$folder/openbox.log" 2>&1 &
  wait_for "a window manager" test -e "$folder/managed"
}

# Waits until the window whose title begins with $1 responds and has the keyboard focus, under a window manager. Sets
# $window.
wait_for_window()
{
  title=$1
  wait_for "a window named $title" is_there
  wait_for "an interactor that listens" listens
  wait_for "the keyboard's focus" has_focus
}
is_there()
{
  window=$(xdotool search --onlyvisible --name "^$title" | head -n 1)
  [[ -n "$window" ]]
}
# Succeeds if the window responds: interactors register WM_DELETE_WINDOW when they begin to handle events.
listens()
{
  is_there && xprop -id "$window" WM_PROTOCOLS | grep -q WM_DELETE_WINDOW
}

has_focus()
{
  is_there && wmctrl -i -a "$window"
  [[ "$(xdotool getwindowfocus)" == "$window" ]]
}

# Expects the program, which is about to end, to exit with status 0 (expect_end), or with status $1 (expect_end_with).
expect_end()
{
  expect_end_with 0
}
expect_end_with()
{
  local status=0 wanted=$1
  wait_for "the program's end" has_ended
  wait "$child" || status=$?
  child=""
  [[ $status -eq $wanted ]] || fail "the program ended with status $status"
}
