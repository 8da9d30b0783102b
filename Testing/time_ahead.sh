#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs Google Test programs in a time namespace (time_namespaces(7)), in which the computer appears to have run for
# 95 years: a double can't represent such a time to the microsecond, and 32 bits can't count its seconds. Exits with 77
# if no time namespace can be created.
#
# usage: Testing/time_ahead.sh PROGRAM [PROGRAM ...]
set -euo pipefail

ahead=$((95 * 365 * 24 * 3600)) # seconds
in_namespace=(unshare --time --monotonic="$ahead" --boottime="$ahead" --fork)
if ! trouble=$("${in_namespace[@]}" true 2>&1); then
  echo "SKIPPED: there are no time namespaces for this user: $trouble"
  exit 77
fi
if ! "${in_namespace[@]}" grep -q '^[0-9]\{10\}[.]' /proc/uptime; then
  echo "The time of the namespace is not ahead" >&2
  exit 1
fi
exec "$(dirname "${BASH_SOURCE[0]}")/each_case.sh" "95 years ahead" "${in_namespace[@]}" -- "$@"
