#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Makes a package whose archive lets everybody write to the samples, as Debian's does. Unpacks the head CT from it, and
# checks that then only the owner can write to the samples.
# usage: head-ct.sh SOURCE_DIR
set -euo pipefail

# shellcheck source=../../Data/head-ct.sh
source "$1/Data/head-ct.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# shellcheck disable=SC2032 # root needs no sudo
apt-get() { touch invesalius-examples_1_all.deb; }
dpkg()
{
  local examples=$3/usr/share/doc/invesalius-examples/examples
  mkdir -p "$examples" "$work/Cranium"
  truncate -s $((256 * 256 * 108 * 2)) "$work/Cranium/matrix.dat"
  chmod 666 "$work/Cranium/matrix.dat"
  tar -czf "$examples/Cranium.inv3" -C "$work" Cranium
}

check()
{
  local mode
  mode=$(stat -c %a "$work/data/matrix.dat")
  if [ "$mode" != 644 ]; then
    echo "matrix.dat has the mode $mode" >&2
    exit 1
  fi
}

umask 022
get_head_ct "$work/data" > "$work/licence.txt"
grep -q GPL-2 "$work/licence.txt"
check
# The script must also correct the permissions of files that were unpacked earlier.
chmod 666 "$work/data/matrix.dat"
get_head_ct "$work/data" > "$work/licence.txt"
check
