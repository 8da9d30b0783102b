# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Functions for scripts that a person starts: they install a script's packages and open a virtual screen.
#
#   source CMake/install-packages.sh
#   require_packages cmake ninja-build

# Installs those of the named Debian packages that are missing. If that fails, prints the missing packages and the
# command that installs them, and returns 1.
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
  # If the update fails, go on: the existing package lists may suffice.
  "${as_root[@]}" apt-get update -qq || echo "The package lists could not be brought up to date."
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}"
  then
    echo "Debian packages could not be installed: ${missing[*]}" >&2
    echo "Cure: look at apt-get's message above; as root, run: $cure" >&2
    return 1
  fi
}

# Runs a command on its own X server, so that no window appears on the user's screen. -noreset keeps Xvfb from
# restarting when its last client leaves: an Xvfb that restarts refuses connections, which made one of about 400
# consecutive programs fail.
with_own_screen()
{
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
}
