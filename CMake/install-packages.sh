# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by scripts that a person starts, so that each script can install its packages and open a screen:
#
#   source CMake/install-packages.sh
#   require_packages cmake ninja-build

# Installs the named Debian packages that are missing, and nothing else. If that is not possible, returns 1, and prints
# the missing packages and the command that installs them.
require_packages()
{
  local package
  local missing=()
  if ! command -v dpkg-query > /dev/null
  then
    echo "This is not a Debian system, so nothing can be installed here." >&2
    echo "Cure: install by hand what these Debian packages hold: $*" >&2
    return 1
  fi
  for package in "$@"
  do
    if [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null)" != installed ]]
    then
      missing+=("$package")
    fi
  done
  if [[ ${#missing[@]} -eq 0 ]]
  then
    return 0
  fi

  local cure="apt-get install --no-install-recommends ${missing[*]}"
  local as_root=()
  if [[ "$(id -u)" -ne 0 ]]
  then
    if ! command -v sudo > /dev/null
    then
      echo "Missing Debian packages: ${missing[*]}" >&2
      echo "Cure: there is no sudo here; as root, run: $cure" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing the missing Debian packages: ${missing[*]}"
  # If the update fails, go on: the present lists may be good enough.
  "${as_root[@]}" apt-get update -qq || echo "The package lists could not be brought up to date."
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}"
  then
    echo "Debian packages could not be installed: ${missing[*]}" >&2
    echo "Cure: look at apt-get's message above; as root, run: $cure" >&2
    return 1
  fi
}

# Runs a command with an X server of its own, so that no window appears on the user's screen. -noreset keeps Xvfb from
# restarting when its last client leaves. While it restarts it refuses connections, which failed one of about 400
# programs run in a row.
with_own_screen()
{
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
}
