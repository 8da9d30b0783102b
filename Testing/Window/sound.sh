#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Listens to the explorer's window. A sound server without a loudspeaker records the sound while real mouse and key
# events touch the volume. Then the server dies, hangs, and is missing.
#
# usage: sound.sh PROGRAM VOLUME
#
# Exits with 77 if a program that it needs is not installed; Testing/run.sh installs it.
set -euo pipefail

# shellcheck source=own-screen.sh
source "$(dirname "${BASH_SOURCE[0]}")/own-screen.sh"
require_programs "xvfb xauth xdotool pulseaudio" xvfb-run xdotool pulseaudio pactl parec
take_own_screen "$@"
take_own_home
export XDG_RUNTIME_DIR=$folder
export PULSE_SERVER=unix:$folder/socket
unset DBUS_SESSION_BUS_ADDRESS PULSE_RUNTIME_PATH PULSE_SINK
server=""

fail()
{
  echo "FAILED: $*" >&2
  cat "$folder/program.log" "$folder/server.log" >&2 || true
  exit 1
}

serves()
{
  pactl info
}

# Starts the server without a sound device, and without the system's configuration.
start_server()
{
  pulseaudio -n --daemonize=no --use-pid-file=no --exit-idle-time=-1 \
    -L "module-null-sink sink_name=ear rate=48000 channels=1" \
    -L "module-native-protocol-unix auth-anonymous=1 socket=$folder/socket" > "$folder/server.log" 2>&1 &
  server=$!
  wait_for "a sound server" serves
}

is_playing()
{
  [[ -n "$(pactl list short sink-inputs)" ]]
}

is_there()
{
  xdotool search --onlyvisible --name "^VTK Volume Haptics"
}

explorer=("$1" "$2" --mapper cpu --size 200 --sound)
start_program()
{
  "${explorer[@]}" > "$folder/program.log" 2>&1 &
  child=$!
  wait_for "a window" is_there
  xdotool mousemove --window "$(is_there | head -n 1)" 100 80
  sleep 1
}

# Presses a key, which the window under the pointer receives.
press()
{
  xdotool key "$1"
}

# Ends any touch, and touches the skin again from outside.
touch_skin()
{
  press Escape
  press t
  for _ in 1 2 3 4 5 6
  do
    xdotool click 4
    sleep 0.1
  done
}

# Slides along the surface for three seconds.
slide()
{
  local i
  for ((i = 0; i < 30; ++i))
  do
    xdotool mousemove_relative -- $((i % 2 == 0 ? 6 : -6)) 0
    sleep 0.1
  done
}

is_recorded()
{
  [[ $(stat -c %s "$folder/heard") -gt 96000 ]]
}

# Prints the number of nonzero bytes that the server receives while a command runs, which is 0 if the explorer is
# silent.
count_heard()
{
  parec --device=ear.monitor --raw --rate=48000 --channels=1 --format=s16le > "$folder/heard" 2> /dev/null &
  local recorder=$!
  "$@"
  wait_for "a second of a recording" is_recorded
  kill "$recorder"
  wait "$recorder" 2> /dev/null || true
  tr -d '\0' < "$folder/heard" | wc -c
}

# Expects sound on the skin. Retries several times, because on a busy machine the force fades while the window is
# blocked, and stays off until a new touch.
expect_sound()
{
  local round heard
  for ((round = 0; round < 15; ++round))
  do
    touch_skin
    heard=$(count_heard slide)
    if [[ $heard -gt 10000 ]]
    then
      echo "heard on the skin $1: $heard bytes of sound"
      return 0
    fi
  done
  fail "only $heard bytes of sound on the skin $1"
}

end_program()
{
  press q
  expect_end
}

expect_lines()
{
  local lines
  lines=$(grep -c "^--sound: there is no sound" "$folder/program.log" || true)
  [[ $lines -eq $1 ]] || fail "$lines lines about sound, not $1"
}

start_server
start_program
wait_for "a stream" is_playing
heard=$(count_heard sleep 2)
[[ $heard -eq 0 ]] || fail "$heard bytes of sound in the air"
expect_sound "at first"
press ctrl+m
wait_for "the line 'Sound off'" grep -q "^Sound off" "$folder/program.log"
sleep 1
heard=$(count_heard slide)
[[ $heard -eq 0 ]] || fail "$heard bytes of sound while it was off"
press ctrl+m
wait_for "the line 'Sound on'" grep -q "^Sound on" "$folder/program.log"
expect_sound "after it was off"
is_playing || fail "the stream ended too early"
end_program
if is_playing
then
  fail "the stream outlived the program"
fi
expect_lines 0
echo "the sound ended with the program"

start_program
wait_for "a stream" is_playing
touch_skin
slide
kill -9 "$server"
wait "$server" 2> /dev/null || true
server=""
slide
! has_ended || fail "the program ended with the server"
wait_for "a line about sound" grep -q "^--sound: there is no sound" "$folder/program.log"
expect_lines 1
start_server
press ctrl+m
wait_for "a new stream" is_playing
expect_sound "by the new server"
end_program
expect_lines 1
grep "^--sound: there is no sound" "$folder/program.log"

start_program
wait_for "a stream" is_playing
kill -STOP "$server"
slide
end_program
kill -CONT "$server"
expect_lines 0
echo "a server that hangs does not keep the program"
kill -9 "$server"
wait "$server" 2> /dev/null || true
server=""

start_program
wait_for "a line about sound" grep -q "^--sound: there is no sound" "$folder/program.log"
slide
expect_lines 1
end_program
expect_lines 1
grep "^--sound: there is no sound" "$folder/program.log"
